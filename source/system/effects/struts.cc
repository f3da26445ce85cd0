#include <auxfem/elements/beam_2d.h>
#include <auxfem/system/effects/beam_dispatch.h>
#include <auxfem/system/effects/struts.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Without shear flexibility the shear strain is held at zero by a stiffness
     * this many times 12 EI / L^2: the deflection is right to its inverse, and
     * the residual loses no more digits than by the axial stiffness.
     */
    constexpr double rigid_shear_factor = 1e6;

    template <int order, bool large_rotation, bool damped>
    class BeamForces : public StrutForces
    {
    public:
      BeamForces(const Lattice              &lattice,
                 const DofNumbering         &numbering,
                 const std::vector<Section> &sections,
                 const bool                  shear_flexibility)
        : lattice(lattice)
        , numbering(numbering)
      {
        const unsigned int n_elements = numbering.elements().size();
        frames.resize(std::size_t(n_elements) * order);
        elements.reserve(n_elements);
        for (unsigned int e = 0; e < n_elements; ++e)
          {
            const DofNumbering::Element &element = numbering.elements()[e];
            const Strut   &strut   = lattice.struts[element.place.strut];
            const Section &section = sections[strut.section];
            const double   length  = lattice.length(strut);

            Element data;
            data.jacobian =
              length * (element.place.end - element.place.begin) / 2;
            data.stiffness = {section.axial_stiffness(),
                              section.shear_stiffness_2(),
                              section.bending_stiffness_3(),
                              section.stiffness_proportional_damping};
            if (!shear_flexibility)
              data.stiffness.shear =
                std::max(data.stiffness.shear,
                         rigid_shear_factor * 12 *
                           section.bending_stiffness_3() / (length * length));
            data.counted = numbering.is_owned(element);
            largest_stiffness_per_length =
              std::max({largest_stiffness_per_length,
                        data.stiffness.axial / data.jacobian,
                        data.stiffness.shear / data.jacobian});
            largest_stiffness = std::max(
              {largest_stiffness, data.stiffness.axial, data.stiffness.shear});
            elements.push_back(data);
            set_frames(element.place,
                       strut,
                       data.jacobian,
                       &frames[std::size_t(e) * order]);
          }
      }

      bool is_linear() const override
      {
        return !large_rotation;
      }

      void add_residual(const Step &step, double *residual) override
      {
        const double *u = step.to.displacement.Values();
        const double *v = damped ? step.to.velocity->Values() : nullptr;
        energy          = {};
        double local_u[n], local_v[n] = {}, force[n];
        for (unsigned int e = 0; e < elements.size(); ++e)
          {
            const int *unknowns = numbering.element_unknowns(e);
            gather(unknowns, u, local_u);
            if (damped)
              gather(unknowns, v, local_v);
            const Beam2D::EnergyRate of_element =
              Beam2D::internal_force<order, large_rotation, damped>(
                shape,
                &frames[std::size_t(e) * order],
                elements[e].jacobian,
                elements[e].stiffness,
                local_u,
                local_v,
                force);
            if (elements[e].counted)
              {
                energy.strain += of_element.strain;
                energy.dissipation += of_element.dissipation;
              }
            for (int i = 0; i < n; ++i)
              residual[unknowns[i]] += force[i];
          }
      }

      void add_tangent(const Step           &step,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        if (factors.stiffness == 0 && factors.damping == 0)
          return;
        const double *u = step.to.displacement.Values();
        const double *v = damped ? step.to.velocity->Values() : nullptr;
        double        local_u[n], local_v[n] = {}, block[n * n];
        for (unsigned int e = 0; e < elements.size(); ++e)
          {
            const int *unknowns = numbering.element_unknowns(e);
            gather(unknowns, u, local_u);
            if (damped)
              gather(unknowns, v, local_v);
            Beam2D::tangent<order, large_rotation, damped>(
              shape,
              &frames[std::size_t(e) * order],
              elements[e].jacobian,
              elements[e].stiffness,
              local_u,
              local_v,
              factors.stiffness,
              factors.damping,
              block);
            matrix.add(e, block);
          }
      }

      void accept(const Step &step) override
      {
        step.to.strut_damping_power += energy.dissipation;
      }

      void add_energies(const State & /*state*/,
                        Energies &energies) const override
      {
        energies.strain += energy.strain;
      }

      double round_off_scale(const double largest_displacement,
                             const double largest_rotation) const override
      {
        return largest_stiffness_per_length * largest_displacement +
          largest_stiffness * std::min(1., largest_rotation);
      }

      std::vector<StrutPoint> sample(const State       &state,
                                     const unsigned int e,
                                     const unsigned int n_points) const override
      {
        const DofNumbering::Element &element = numbering.elements()[e];
        const Strut   &strut = lattice.struts[element.place.strut];
        const Element &data  = elements[e];
        double         u[n], v[n] = {};
        gather(numbering.element_unknowns(e), state.displacement.Values(), u);
        if (state.velocity)
          gather(numbering.element_unknowns(e), state.velocity->Values(), v);

        double elastic[order][3], viscous[order][3];
        for (int g = 0; g < order; ++g)
          section_forces(data,
                         frames[std::size_t(e) * order + g],
                         g,
                         u,
                         v,
                         elastic[g],
                         viscous[g]);

        std::vector<StrutPoint> points(n_points);
        for (unsigned int i = 0; i < n_points; ++i)
          {
            const double xi = -1 + 2. * i / (n_points - 1);
            double       N[order + 1], H[order];
            shape.values_at(xi, N);
            shape.gauss_interpolation_at(xi, H);
            StrutPoint          &point = points[i];
            dealii::Tensor<1, 3> tangent;
            lattice.axis(strut,
                         element.place.begin +
                           (element.place.end - element.place.begin) *
                             (1 + xi) / 2,
                         point.position,
                         tangent);
            for (int a = 0; a <= order; ++a)
              {
                for (unsigned int d = 0; d < 2; ++d)
                  {
                    point.displacement[d] += N[a] * u[3 * a + d];
                    point.velocity[d] += N[a] * v[3 * a + d];
                  }
                point.rotation[2] += N[a] * u[3 * a + 2];
              }
            double E[3] = {0, 0, 0}, V[3] = {0, 0, 0};
            for (int g = 0; g < order; ++g)
              for (unsigned int k = 0; k < 3; ++k)
                {
                  E[k] += H[g] * elastic[g][k];
                  V[k] += H[g] * viscous[g][k];
                }
            const double turn = large_rotation ? point.rotation[2] : 0.;
            const double c = std::cos(turn), s = std::sin(turn);
            for (unsigned int d = 0; d < 2; ++d)
              {
                const double normal = d == 0 ? -tangent[1] : tangent[0];
                point.axes[d][0]    = c * tangent[d] + s * normal;
                point.axes[d][1]    = c * normal - s * tangent[d];
              }
            point.axes[2][2]     = 1;
            point.force[0]       = E[0] + V[0];
            point.force[1]       = E[1] + V[1];
            point.moment[2]      = E[2] + V[2];
            point.energy_density = (E[0] * E[0] / data.stiffness.axial +
                                    E[1] * E[1] / data.stiffness.shear +
                                    E[2] * E[2] / data.stiffness.bending) /
              2;
          }
        return points;
      }

    private:
      static constexpr int n = 3 * (order + 1);

      struct Element
      {
        double            jacobian;
        Beam2D::Stiffness stiffness;
        bool              counted;
      };

      static void gather(const int *unknowns, const double *all, double *local)
      {
        for (int i = 0; i < n; ++i)
          local[i] = all[unknowns[i]];
      }

      /**
       * Frames of the true axis; r0' is that of the interpolated axis, so the
       * strut is free of stress at rest.
       */
      void set_frames(const StrutMesh::Place &place,
                      const Strut            &strut,
                      const double            jacobian,
                      Beam2D::Frame          *frame) const
      {
        const auto fraction = [&](const double xi) {
          return place.begin + (place.end - place.begin) * (1 + xi) / 2;
        };
        dealii::Point<3>     nodes[order + 1], position;
        dealii::Tensor<1, 3> tangent;
        for (int a = 0; a <= order; ++a)
          lattice.axis(strut, fraction(shape.node[a]), nodes[a], tangent);
        for (int g = 0; g < order; ++g)
          {
            lattice.axis(strut, fraction(shape.point[g]), position, tangent);
            dealii::Tensor<1, 3> slope;
            for (int a = 0; a <= order; ++a)
              slope += shape.derivative[g][a] / jacobian * nodes[a];
            frame[g].cosine = tangent[0];
            frame[g].sine   = tangent[1];
            frame[g].axial  = slope[0] * tangent[0] + slope[1] * tangent[1];
            frame[g].shear  = slope[1] * tangent[0] - slope[0] * tangent[1];
          }
      }

      /** N, Q, M of the strains and those of the strain rates. */
      void section_forces(const Element       &data,
                          const Beam2D::Frame &frame,
                          const int            g,
                          const double        *u,
                          const double        *v,
                          double (&elastic)[3],
                          double (&viscous)[3]) const
      {
        const Beam2D::Kinematics k = Beam2D::kinematics<large_rotation>(
          frame,
          Beam2D::interpolate(shape, g, 1 / data.jacobian, u));
        elastic[0] = data.stiffness.axial * k.epsilon;
        elastic[1] = data.stiffness.shear * k.gamma;
        elastic[2] = data.stiffness.bending * k.kappa;

        const Beam2D::Gradient rate =
          Beam2D::interpolate(shape, g, 1 / data.jacobian, v);
        double epsilon_rate, gamma_rate;
        Beam2D::strain_rates(k, rate, epsilon_rate, gamma_rate);
        const double beta = damped ? data.stiffness.damping_time : 0.;
        viscous[0]        = beta * data.stiffness.axial * epsilon_rate;
        viscous[1]        = beta * data.stiffness.shear * gamma_rate;
        viscous[2]        = beta * data.stiffness.bending * rate.kappa;
      }

      const Lattice             &lattice;
      const DofNumbering        &numbering;
      const BeamShape<order>     shape;
      std::vector<Element>       elements;
      std::vector<Beam2D::Frame> frames;
      double                     largest_stiffness            = 0;
      double                     largest_stiffness_per_length = 0;
      Beam2D::EnergyRate         energy;
    };

    template <int order>
    std::unique_ptr<StrutForces>
    make_of_order(const Lattice              &lattice,
                  const DofNumbering         &numbering,
                  const std::vector<Section> &sections,
                  const StrutModel           &model)
    {
      const bool shear = model.shear_flexibility;
      if (model.large_rotation && model.damping)
        return std::make_unique<BeamForces<order, true, true>>(lattice,
                                                               numbering,
                                                               sections,
                                                               shear);
      if (model.large_rotation)
        return std::make_unique<BeamForces<order, true, false>>(lattice,
                                                                numbering,
                                                                sections,
                                                                shear);
      if (model.damping)
        return std::make_unique<BeamForces<order, false, true>>(lattice,
                                                                numbering,
                                                                sections,
                                                                shear);
      return std::make_unique<BeamForces<order, false, false>>(lattice,
                                                               numbering,
                                                               sections,
                                                               shear);
    }
  } // namespace

  std::unique_ptr<StrutForces>
  StrutForces::make(const Lattice              &lattice,
                    const DofNumbering         &numbering,
                    const std::vector<Section> &sections,
                    const StrutModel           &model)
  {
    return dispatch_order(numbering.order(), [&](auto order) {
      return make_of_order<order>(lattice, numbering, sections, model);
    });
  }
} // namespace auxfem
