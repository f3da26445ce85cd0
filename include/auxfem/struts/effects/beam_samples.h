#ifndef auxfem_struts_effects_beam_samples_h
#define auxfem_struts_effects_beam_samples_h

#include <auxfem/struts/effects/beam_elements.h>
#include <auxfem/struts/effects/struts.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace auxfem
{
  /**
   * Strain energy (J) of an element and its dissipated power (W). For mean
   * forces over a step: energy dissipated in the step and numerical dissipation
   * by the damping of high frequencies (J).
   */
  template <class Number>
  struct BeamEnergyOf
  {
    Number strain = 0, dissipation = 0, numerical_dissipation = 0;
  };
  using BeamEnergy = BeamEnergyOf<double>;

  /** Forces and energies of struts in one evaluation. */
  struct BeamResults : public EffectCache
  {
    explicit BeamResults(const unsigned int n_elements)
      : forces(n_elements)
      , strain_energies(n_elements)
    {}

    /** Total of the elements owned by this rank. */
    BeamEnergy energy;
    /** Largest force at the ends of each element (N); moments are divided by
     * the length of the strut. */
    std::vector<double> forces;
    /** Strain energy of each element (J). */
    std::vector<double> strain_energies;
  };

  /** Section forces, positions and strains of struts for output and checks. @p
   * Beam is as in BeamForces, which derives from it, without damping. */
  template <class Beam>
  class BeamSamples : public StrutForces
  {
  public:
    explicit BeamSamples(BeamElements<Beam> &&beams) : beams(std::move(beams))
    {}

    const DofNumbering::Group &elements() const override
    {
      return beams.group;
    }

    bool is_linear() const override
    {
      return Beam::is_linear;
    }

    std::vector<StrutPoint> sample(const State       &state,
                                   const unsigned int element,
                                   const unsigned int n_points) const override
    {
      const unsigned int          e      = index(element);
      const typename Beam::Motion motion = beams.motion(e, state);
      SectionForces elastic[order], viscous[order] = {}, strains[order];
      section_forces(e, state, elastic);
      viscous_forces(e, state, viscous);
      elastic_forces(e, state, strains);
      subtract_initial_strains(e, state, strains);
      for (SectionForces(*forces)[order] : {&elastic, &viscous, &strains})
        find_moments(*forces);

      std::vector<StrutPoint> points(n_points);
      for (unsigned int i = 0; i < n_points; ++i)
        {
          const double xi = -1 + 2. * i / (n_points - 1);
          double       N[order + 1], H[order];
          beams.shape.values_at(xi, N);
          beams.shape.gauss_interpolation_at(xi, H);
          StrutPoint          &point = points[i];
          dealii::Tensor<1, 3> tangent;
          axis_at(e, xi, point.position, tangent);
          point.displacement = interpolated(N, e, state.displacement);
          if (state.velocity)
            point.velocity = interpolated(N, e, *state.velocity);
          point.rotation = Beam::rotation(N, motion, beams.unknowns(e), state);
          point.axes =
            Beam::axes(tangent, beams.section(e).orientation(), point.rotation);
          double S[order];
          strain_interpolation(H, S);
          SectionForces E = {}, V = {};
          for (int g = 0; g < order; ++g)
            for (unsigned int k = 0; k < 6; ++k)
              {
                E[k] += H[g] * elastic[g][k];
                V[k] += H[g] * viscous[g][k];
                point.strain_forces[k] += S[g] * strains[g][k];
              }
          for (unsigned int k = 0; k < 3; ++k)
            {
              point.force[k]  = E[k] + V[k];
              point.moment[k] = E[3 + k] + V[3 + k];
            }
          point.energy_density = stored_density(e, state, H, E);
        }
      return points;
    }

    double energy_density(const unsigned int   element,
                          const SectionForces &forces) const override
    {
      return Beam::strain_product(beams.at_rest(index(element)).stiffness,
                                  forces,
                                  forces) /
        2;
    }

    std::vector<dealii::Point<3>>
    axis(const Vector      &displacement,
         const unsigned int element,
         const unsigned int n_points) const override
    {
      const unsigned int            e = index(element);
      std::vector<dealii::Point<3>> points(n_points);
      for (unsigned int i = 0; i < n_points; ++i)
        {
          const double xi = -1 + 2. * i / (n_points - 1);
          double       N[order + 1];
          beams.shape.values_at(xi, N);
          dealii::Tensor<1, 3> tangent;
          axis_at(e, xi, points[i], tangent);
          points[i] += interpolated(N, e, displacement);
        }
      return points;
    }

    ScaledMotion scaled_motion(const State       &state,
                               const unsigned int element) const override
    {
      const unsigned int e = index(element);
      SectionForces      elastic[order];
      elastic_forces(e, state, elastic);
      find_moments(elastic);
      ScaledMotion motion;
      for (const SectionForces &forces : elastic)
        motion.strains.push_back(
          scaled_strains(beams.at_rest(e).stiffness, forces));
      if (!state.acceleration)
        return motion;
      const double scale = std::sqrt(beams.section(e).mass_per_length());
      const dealii::QGauss<1> gauss(order + 1);
      for (const dealii::Point<1> &point : gauss.get_points())
        {
          double N[order + 1];
          beams.shape.values_at(2 * point[0] - 1, N);
          const dealii::Tensor<1, 3> velocity =
            scale * interpolated(N, e, *state.velocity);
          motion.velocities.push_back(
            {{velocity[0], velocity[1], velocity[2]}});
        }
      return motion;
    }

    double strain_energy(const EffectCache &results,
                         const unsigned int element) const override
    {
      return static_cast<const BeamResults &>(results)
        .strain_energies[index(element)];
    }

    double axial_force(const State       &state,
                       const unsigned int element) const override
    {
      const unsigned int e = index(element);
      SectionForces      forces[order];
      section_forces(e, state, forces);
      double integral = 0;
      for (int g = 0; g < order; ++g)
        integral += beams.shape.weight[g] * forces[g][0];
      return integral / 2;
    }

    StrutStrain largest_strain(const State                    &state,
                               const EffectCache              &results,
                               const std::vector<StrainLimit> &limits,
                               const double least) const override
    {
      const auto &energies =
        static_cast<const BeamResults &>(results).strain_energies;
      std::vector<double> bounds;
      for (std::size_t s = 0; s < limits.size(); ++s)
        bounds.push_back(
          2 * square_at_points *
          strain_per_energy(beams.sections[s], limits[s].fibres) /
          least_stored_fraction());
      StrutStrain largest{least, invalid_index};
      for (unsigned int e = 0; e < beams.size(); ++e)
        {
          const unsigned int section      = beams.strut(e).section;
          const double       strain_limit = limits[section].strain,
                       least_strain       = largest.ratio * strain_limit;
          const bool is_tapered = beams.sections[section].taper != nullptr;
          if (!beams[e].owned || !carries_load(e, state) ||
              (!is_tapered &&
               bounds[section] * energies[e] <=
                 least_strain * least_strain * beams.at_rest(e).jacobian))
            continue;
          const double ratio =
            largest_strain(state,
                           e,
                           is_tapered ? beams.section(e).outer_fibres
                                      : limits[section].fibres) /
            strain_limit;
          if (ratio > largest.ratio)
            largest = {ratio, beams.interval(e).strut};
        }
      return largest;
    }

  protected:
    static constexpr int order = Beam::order;

    /** Section forces at the Gauss points of element @p e, without damping;
     * moments are work-conjugate to the curvatures of rotation_derivative. */
    virtual void section_forces(const unsigned int e,
                                const State       &state,
                                SectionForces (&point_forces)[order]) const
    {
      elastic_forces(e, state, point_forces);
    }

    /**
     * Energy stored per length (J/m) at a point of element @p e.
     * @param H Gauss interpolation at the point
     * @param forces section forces there
     */
    virtual double stored_density(const unsigned int e,
                                  const State & /*state*/,
                                  const double (&/*H*/)[order],
                                  const SectionForces &forces) const
    {
      return Beam::strain_product(beams.at_rest(e).stiffness, forces, forces) /
        2;
    }

    /** Whether the strut of element @p e has not begun to break. */
    virtual bool carries_load(const unsigned int /*e*/,
                              const State & /*state*/) const
    {
      return true;
    }

    /** Whether strains may be interpolated between Gauss points; not where a
     * single one is a hinge. */
    virtual bool has_smooth_strains() const
    {
      return true;
    }

    /** Lower bound of the stored energy over that of the elastic stiffness. */
    virtual double least_stored_fraction() const
    {
      return 1;
    }

    /** Takes initial strains from @p forces, as of elastic_forces(). */
    virtual void
    subtract_initial_strains(const unsigned int /*e*/,
                             const State & /*state*/,
                             SectionForces (&/*forces*/)[order]) const
    {}

    /** Forces of the elastic stiffness at the Gauss points of element @p e,
     * which measure strains; moments as in section_forces(). */
    void elastic_forces(const unsigned int e,
                        const State       &state,
                        SectionForces (&point_forces)[order]) const
    {
      Beam::elastic_forces(beams.shape,
                           beams.at_rest(e),
                           beams.motion(e, state),
                           point_forces);
    }

    const BeamElements<Beam> beams;

  private:
    /** Converts moments that are work-conjugate to curvatures to section
     * moments. */
    void find_moments(SectionForces (&point_forces)[order]) const
    {
      for (unsigned int k = 3; k < 6; ++k)
        {
          double on_curvatures[order];
          for (int g = 0; g < order; ++g)
            on_curvatures[g] = point_forces[g][k];
          for (int g = 0; g < order; ++g)
            {
              point_forces[g][k] = 0;
              for (int h = 0; h < order; ++h)
                point_forces[g][k] +=
                  beams.shape.moment[g][h] * on_curvatures[h];
            }
        }
    }

    /** Weights of the Gauss points for strains, where those of smooth functions
     * are @p H: the nearest one alone beside plastic hinges. */
    void strain_interpolation(const double (&H)[order],
                              double (&S)[order]) const
    {
      const int nearest = std::max_element(H, H + order) - H;
      for (int g = 0; g < order; ++g)
        S[g] = has_smooth_strains() ? H[g] : g == nearest;
    }

    /** Damping section forces at the Gauss points of element @p e; the caller
     * zeroes them, undamped beams leave them. */
    virtual void viscous_forces(const unsigned int /*e*/,
                                const State & /*state*/,
                                SectionForces (&/*point_forces*/)[order]) const
    {}

    /** Index among the beams of an element of the numbering. */
    unsigned int index(const unsigned int element) const
    {
      return element - beams.group.begin;
    }

    /** Position and tangent of element @p e at @p xi in [-1, 1], at rest. */
    void axis_at(const unsigned int    e,
                 const double          xi,
                 dealii::Point<3>     &position,
                 dealii::Tensor<1, 3> &tangent) const
    {
      beams.lattice.axis(beams.strut(e),
                         beams.interval(e).at(xi),
                         position,
                         tangent);
    }

    /** Translation part of @p values, by local unknown, at a point of element
     * @p e with shape functions @p N. */
    dealii::Tensor<1, 3> interpolated(const double (&N)[order + 1],
                                      const unsigned int e,
                                      const Vector      &values) const
    {
      const int           *unknowns = beams.unknowns(e);
      dealii::Tensor<1, 3> result;
      for (int a = 0; a <= order; ++a)
        for (unsigned int d = 0; d < beams.lattice.dimension; ++d)
          result[d] +=
            N[a] * values[unknowns[BeamElements<Beam>::n_components * a + d]];
      return result;
    }

    /** Strains from @p forces, scaled as in ScaledMotion. */
    static SectionForces
    scaled_strains(const typename Beam::Stiffness &stiffness,
                   const SectionForces            &forces)
    {
      SectionForces strains = {};
      for (unsigned int k = 0; k < strains.size(); ++k)
        {
          SectionForces unit = {};
          unit[k]            = 1;
          strains[k] =
            forces[k] * std::sqrt(Beam::strain_product(stiffness, unit, unit));
        }
      return strains;
    }

    /** Upper bound of the squared outer-fibre strain over twice the energy per
     * length (1/N): N / EA + M d / EI against N^2 / EA + M^2 / EI. */
    static double strain_per_energy(const Section &section,
                                    const std::vector<dealii::Point<2>> &fibres)
    {
      double bending = 0;
      for (const dealii::Point<2> &fibre : fibres)
        bending =
          std::max(bending,
                   fibre[0] * fibre[0] / section.bending_stiffness_3() +
                     fibre[1] * fibre[1] / section.bending_stiffness_2());
      return 1 / section.axial_stiffness() + bending;
    }

    /** Number of intervals between strain sampling points. */
    static constexpr int n_intervals = 4 * order;

    static double strain_point(const int i)
    {
      return -1 + 2. * i / n_intervals;
    }

    /**
     * Upper bound of the squared section force at a sampling point over the
     * integral of its work-conjugate squares on [-1, 1], by the Cauchy-Schwarz
     * inequality.
     */
    static double largest_square(const BeamShape<order> &shape)
    {
      double largest = 0;
      for (int i = 0; i <= n_intervals; ++i)
        {
          double H[order], force_squares = 0, moment_squares = 0;
          shape.gauss_interpolation_at(strain_point(i), H);
          for (int g = 0; g < order; ++g)
            {
              double M = 0;
              for (int h = 0; h < order; ++h)
                M += H[h] * shape.moment[h][g];
              force_squares += H[g] * H[g] / shape.weight[g];
              moment_squares += M * M / shape.weight[g];
            }
          largest = std::max({largest, force_squares, moment_squares});
        }
      return largest;
    }

    /** Largest outer-fibre strain along element @p e. */
    double largest_strain(const State                         &state,
                          const unsigned int                   e,
                          const std::vector<dealii::Point<2>> &fibres) const
    {
      const Section &section = beams.section(e);
      SectionForces  elastic[order];
      elastic_forces(e, state, elastic);
      subtract_initial_strains(e, state, elastic);
      find_moments(elastic);
      const auto at_forces = [&](const double(&H)[order]) {
        double N = 0, M_2 = 0, M_3 = 0;
        for (int g = 0; g < order; ++g)
          {
            N += H[g] * elastic[g][0];
            M_2 += H[g] * elastic[g][4];
            M_3 += H[g] * elastic[g][5];
          }
        const double axial       = N / section.axial_stiffness(),
                     curvature_2 = M_2 / section.bending_stiffness_2(),
                     curvature_3 = M_3 / section.bending_stiffness_3();
        double largest           = std::abs(axial);
        for (const dealii::Point<2> &fibre : fibres)
          largest = std::max(largest,
                             std::abs(axial + curvature_2 * fibre[1] -
                                      curvature_3 * fibre[0]));
        return largest;
      };
      if (!has_smooth_strains())
        {
          double largest = 0;
          for (int g = 0; g < order; ++g)
            {
              double H[order] = {};
              H[g]            = 1;
              largest         = std::max(largest, at_forces(H));
            }
          return largest;
        }
      double strains[n_intervals + 1];
      for (int i = 0; i <= n_intervals; ++i)
        {
          double H[order];
          beams.shape.gauss_interpolation_at(strain_point(i), H);
          strains[i] = at_forces(H);
        }
      const double *const at =
        std::max_element(std::begin(strains), std::end(strains));
      if (at == strains || at == strains + n_intervals)
        return *at;
      // Vertex of the parabola through the largest value and its neighbours.
      const double slope = at[1] - at[-1], bend = 2 * at[0] - at[1] - at[-1];
      return bend > 0 ? *at + slope * slope / (8 * bend) : *at;
    }

    const double square_at_points = largest_square(beams.shape);
  };
} // namespace auxfem

#endif
