#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/effects/strut_inertia.h>

namespace auxfem
{
  namespace
  {
    /** Consistent mass M of struts in the plane, translational rho A and rotary
     * rho I, and the force alpha M v with damping. Constant. */
    template <int order, bool damped>
    class PlaneStrutInertia : public StrutInertia
    {
    public:
      PlaneStrutInertia(const Lattice              &lattice,
                        const DofNumbering         &numbering,
                        const DofNumbering::Group  &group,
                        const std::vector<Section> &sections,
                        const bool                  rotary_inertia)
        : StrutInertia(lattice, numbering, group, sections, damped)
      {
        for (const Element &element : elements)
          rotary.push_back(rotary_inertia
                             ? element.rotary_inertia[2] * element.half_length
                             : 0.);
      }

      bool is_linear() const override
      {
        return true;
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        if constexpr (damped)
          add_forces(evaluation.to.acceleration->data(),
                     DampedVelocity(evaluation).values(),
                     residual);
        else
          add_forces(evaluation.to.acceleration->data(), nullptr, residual);
      }

      void add_tangent(const Evaluation & /*evaluation*/,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        double block[n * n] = {};
        for (unsigned int e = 0; e < elements.size(); ++e)
          {
            const double factor = factors.mass +
              (damped ? elements[e].damping * factors.damping : 0.);
            if (factor == 0)
              continue;
            for (int i = 0; i <= order; ++i)
              for (int j = 0; j <= order; ++j)
                for (int c = 0; c < 3; ++c)
                  block[(3 * i + c) * n + 3 * j + c] = factor *
                    shape.mass[i][j] * (c < 2 ? elements[e].mass : rotary[e]);
            matrix.add(group.begin + e, block);
          }
      }

    private:
      static constexpr int n = 3 * (order + 1);

      /** Adds the forces of accelerations @p a and, with damping, velocities @p
       * v. */
      void add_forces(const double *a, const double *v, double *residual) const
      {
        double local[n];
        for (unsigned int e = 0; e < elements.size(); ++e)
          {
            const int *unknowns = numbering.element_unknowns(group.begin + e);
            for (int i = 0; i < n; ++i)
              local[i] = damped
                ? a[unknowns[i]] + elements[e].damping * v[unknowns[i]]
                : a[unknowns[i]];
            for (int i = 0; i <= order; ++i)
              {
                double sum[3] = {0, 0, 0};
                for (int j = 0; j <= order; ++j)
                  for (int c = 0; c < 3; ++c)
                    sum[c] += shape.mass[i][j] * local[3 * j + c];
                residual[unknowns[3 * i]] += elements[e].mass * sum[0];
                residual[unknowns[3 * i + 1]] += elements[e].mass * sum[1];
                residual[unknowns[3 * i + 2]] += rotary[e] * sum[2];
              }
          }
      }

      double product(const Vector &x,
                     const Vector &y,
                     const Weight  weight) const override
      {
        double sum = 0;
        for (unsigned int e = 0; e < elements.size(); ++e)
          if (elements[e].owned)
            {
              const int *unknowns = numbering.element_unknowns(group.begin + e);
              double     linear = 0, angular = 0;
              for (int i = 0; i <= order; ++i)
                {
                  double weighted[3] = {0, 0, 0};
                  for (int j = 0; j <= order; ++j)
                    for (int c = 0; c < 3; ++c)
                      weighted[c] += shape.mass[i][j] * y[unknowns[3 * j + c]];
                  linear += x[unknowns[3 * i]] * weighted[0] +
                    x[unknowns[3 * i + 1]] * weighted[1];
                  angular += x[unknowns[3 * i + 2]] * weighted[2];
                }
              sum += weight(elements[e]) *
                (elements[e].mass * linear + rotary[e] * angular);
            }
        return sum;
      }

      const BeamShape<order> shape;
      /** rho I times half the length (kg m2), by element. */
      std::vector<double> rotary;
    };
  } // namespace

  EnergyEntry mass_damping_entry()
  {
    return {EnergyKind::dissipated,
            "mass_damping_dissipated",
            "energy lost by mass-proportional damping of the struts since the "
            "start"};
  }

  StrutInertia::StrutInertia(const Lattice              &lattice,
                             const DofNumbering         &numbering,
                             const DofNumbering::Group  &group,
                             const std::vector<Section> &sections,
                             const bool                  damped)
    : numbering(numbering)
    , group(group)
    , is_damped(damped)
  {
    elements.reserve(group.end - group.begin);
    for (unsigned int e = group.begin; e < group.end; ++e)
      {
        const DofNumbering::Element &element = numbering.elements()[e];
        const Strut  &strut = lattice.struts[element.interval.strut];
        const Section section =
          sections[strut.section].at(element.interval.at(0));
        const double half_length = lattice.length(strut) *
          (element.interval.end - element.interval.begin) / 2;
        elements.push_back({section.rotary_inertia_per_length(),
                            half_length,
                            section.mass_per_length() * half_length,
                            section.mass_proportional_damping,
                            element.is_owned});
      }
  }

  void StrutInertia::register_in(StateLayout &layout)
  {
    InertiaEffect::register_in(layout);
    if (is_damped)
      damping_entry = layout.energies.enter(mass_damping_entry());
  }

  void StrutInertia::account_step(const Evaluation & /*step*/,
                                  const EffectCache * /*results*/,
                                  EnergyAccount &account) const
  {
    if (!is_damped || !account.has_duration())
      return;
    // The mean damping force acts with the mean velocity.
    const StepMotion &motion = account.motion();
    account.add_in_step(damping_entry,
                        motion.dt *
                          damping_product(motion.velocity, motion.velocity));
    account.add_in_step(numerical_entry,
                        motion.dt *
                          damping_product(motion.velocity, motion.excess_rate));
  }

  void StrutInertia::account_stage(const Evaluation &stage,
                                   const EffectCache * /*results*/,
                                   EnergyAccount &account) const
  {
    if (is_damped)
      account.add_power(damping_entry,
                        damping_product(*stage.to.velocity,
                                        *stage.to.velocity));
  }

  std::unique_ptr<Effect>
  make_strut_inertia(const Lattice              &lattice,
                     const DofNumbering         &numbering,
                     const DofNumbering::Group  &group,
                     const std::vector<Section> &sections,
                     const InertiaModel         &model)
  {
    if (lattice.dimension == 3)
      return make_space_strut_inertia(lattice,
                                      numbering,
                                      group,
                                      sections,
                                      model);
    const auto make = [&](auto order, auto damped) -> std::unique_ptr<Effect> {
      return std::make_unique<PlaneStrutInertia<order, damped>>(
        lattice,
        numbering,
        group,
        sections,
        model.rotary_inertia);
    };
    return dispatch_order(group.order, [&](auto order) {
      return model.damping ? make(order, std::true_type())
                           : make(order, std::false_type());
    });
  }
} // namespace auxfem
