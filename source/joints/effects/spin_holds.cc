#include <auxfem/equations/make_effects.h>
#include <auxfem/joints/effects/revolute_hinges.h>
#include <auxfem/joints/effects/rotational_springs.h>
#include <auxfem/parameters/numerical_limits.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Stiffness of a hold relative to the torsional stiffness GJ / L of its
     * strut, large enough not to change torsional modes noticeably. */
    constexpr double relative_stiffness = 1 / noticeable_fraction;

    /**
     * Springs K' phi that prevent singular tangents: in statics nothing else
     * holds a bar between ball hinges against turning about its own axis. No
     * load can turn such a bar, so moments and energies stay zero. With large
     * rotations phi is the twist about the axis since the last state.
     */
    class SpinHolds : public Effect
    {
    public:
      explicit SpinHolds(const LatticeModel &model)
        : numbering(model.numbering)
        , is_large(model.plan.simulated.large_rotation)
      {
        for (const FreeSpin &spin : model.free_spins)
          for (unsigned int e = 0; e < numbering.elements().size(); ++e)
            if (ends_with(numbering.elements()[e].interval, spin.end))
              add_hold(model, spin.end, e);
      }

      bool is_linear() const override
      {
        return !is_large;
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        if (!is_static(evaluation))
          return;
        for (const Hold &hold : holds)
          {
            const Twist twist = twist_of(hold, evaluation);
            for (unsigned int c = 0; c < 3; ++c)
              residual[hold.spins[c]] +=
                hold.stiffness * twist.angle * twist.by_spin[c];
          }
      }

      void add_tangent(const Evaluation &evaluation,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        // Dynamic tangents need no hold, but their stiffness part alone does.
        if (factors.stiffness == 0 ||
            (!is_static(evaluation) && factors.mass != 0))
          return;
        std::vector<double> block;
        for (const Hold &hold : holds)
          {
            const unsigned int n = numbering.n_element_unknowns(hold.element);
            block.assign(n * n, 0.);
            const SpaceVector by_spin = twist_of(hold, evaluation).by_spin;
            for (unsigned int r = 0; r < 3; ++r)
              for (unsigned int c = 0; c < 3; ++c)
                block[n * (hold.row + r) + hold.row + c] =
                  factors.stiffness * hold.stiffness * by_spin[r] * by_spin[c];
            matrix.add(hold.element, block.data());
          }
      }

    private:
      struct Hold
      {
        unsigned int       element, row; ///< row of the first spin in its block
        std::array<int, 3> spins;        ///< local unknowns
        SpaceVector        axis;         ///< of the strut at rest
        double             stiffness;    ///< N m
      };

      /** Twist angle (rad) and its derivative by the spin of the end. */
      struct Twist
      {
        double      angle;
        SpaceVector by_spin;
      };

      /** Whether a step or equilibrium without inertia is evaluated. */
      static bool is_static(const Evaluation &evaluation)
      {
        return evaluation.kind == Evaluation::Kind::static_step ||
          evaluation.kind == Evaluation::Kind::equilibrium;
      }

      /** Whether @p interval has the strut end @p end. */
      static bool ends_with(const StrutInterval &interval, const StrutEnd &end)
      {
        return interval.strut == end.strut &&
          (end.end == 0 ? interval.begin == 0 : interval.end == 1);
      }

      void add_hold(const LatticeModel &model,
                    const StrutEnd     &end,
                    const unsigned int  element)
      {
        const Strut         &strut   = model.lattice.struts[end.strut];
        const Section       &section = model.sections[strut.section];
        dealii::Point<3>     position;
        dealii::Tensor<1, 3> axis;
        model.lattice.axis(strut, end.end, position, axis);
        Hold hold;
        hold.element = element;
        // The ends are the first two nodes.
        hold.row = numbering.n_components() * end.end + first_rotation;
        for (unsigned int c = 0; c < 3; ++c)
          {
            hold.spins[c] = numbering.element_unknowns(element)[hold.row + c];
            hold.axis[c]  = axis[c];
          }
        hold.stiffness = relative_stiffness * section.torsion_stiffness() /
          model.lattice.length(strut);
        holds.push_back(hold);
      }

      Twist twist_of(const Hold &hold, const Evaluation &evaluation) const
      {
        if (!is_large)
          return {hold.axis *
                    vector_at(evaluation.to.displacement.data(),
                              hold.spins.data()),
                  hold.axis};
        const unsigned int i      = numbering.rotations().with(hold.spins[0]);
        const Quaternion  &before = evaluation.from.rotations[i];
        return twist(evaluation.to.rotations[i] * conjugate(before),
                     rotated(before, hold.axis));
      }

      /** Angle of a rotation q = (w, v) about @p axis t: 2 arctan(v.t / w). */
      static Twist twist(const Quaternion &rotation, const SpaceVector &axis)
      {
        // q and -q are the same rotation.
        const double      sign  = rotation.scalar < 0 ? -1 : 1;
        const double      w     = sign * rotation.scalar;
        const SpaceVector v     = sign * rotation.vector;
        const double      along = v * axis, square = w * w + along * along;
        return {2 * std::atan2(along, w),
                (w * w * axis + w * cross_product_3d(v, axis) + along * v) /
                  square};
      }

      const DofNumbering &numbering;
      const bool          is_large;
      std::vector<Hold>   holds;
    };
  } // namespace

  std::unique_ptr<Effect> make_spin_holds(const LatticeModel &model)
  {
    if (model.free_spins.empty())
      return nullptr;
    return std::make_unique<SpinHolds>(model);
  }

  namespace
  {
    /** Local numbers of the rotation about x, y, z; -1: none. */
    std::array<int, 3> spins(const DofNumbering  &numbering,
                             const RotationOwner &rotation_owner)
    {
      std::array<int, 3> unknowns;
      for (unsigned int c = 0; c < 3; ++c)
        unknowns[c] =
          numbering.rotation_unknown(rotation_owner, first_rotation + c);
      return unknowns;
    }

    /** Calls @p add(number, base, end) for the springs of @p release on this
     * rank, numbered from @p number on. */
    template <class Add>
    void for_each_spring(const LatticeModel &model,
                         const JointRelease &release,
                         unsigned int       &number,
                         const Add          &add)
    {
      const DofNumbering &numbering = model.numbering;
      for (const RotationPair &pair : release.pairs)
        {
          const std::array<int, 3> base = spins(numbering, pair.base),
                                   end  = spins(numbering, pair.end);
          if (end[2] >= 0 &&
              (base[2] >= 0 || pair.base.kind == RotationOwner::Kind::ground))
            add(number, base, end);
          ++number;
        }
    }

    bool is_spring(const JointRelease &release)
    {
      return release.definition->type ==
        JointDefinition::Type::rotational_spring;
    }

    /** Calls @p add(number, stiffness, base, end) for the linear springs of
     * this rank. */
    template <class Add>
    void for_each_linear_spring(const LatticeModel &model, const Add &add)
    {
      unsigned int number = 0;
      for (const JointRelease &release : model.releases)
        if (is_spring(release) && !release.definition->law)
          for_each_spring(model,
                          release,
                          number,
                          [&](const unsigned int i,
                              const auto        &base,
                              const auto        &end) {
                            add(i, release.definition->stiffness, base, end);
                          });
    }
  } // namespace

  std::unique_ptr<Effect> make_rotational_springs(const LatticeModel &model)
  {
    const DofNumbering &numbering = model.numbering;
    // All ranks make the effect, because their states have the same records.
    if (!have_rotational_springs(model.releases))
      return nullptr;
    if (model.plan.simulated.large_rotation && model.lattice.dimension == 3)
      {
        std::vector<SpaceSpring> springs;
        for_each_linear_spring(model,
                               [&](const unsigned int number,
                                   const double       stiffness,
                                   const auto        &base,
                                   const auto        &end) {
                                 springs.push_back(
                                   {base[0] < 0
                                      ? -1
                                      : numbering.rotations().with(base[0]),
                                    numbering.rotations().with(end[0]),
                                    stiffness,
                                    number});
                               });
        return make_space_springs(numbering, springs);
      }
    std::vector<RotationalSpring> springs;
    for_each_linear_spring(
      model,
      [&](const unsigned int /*number*/,
          const double stiffness,
          const auto  &base,
          const auto  &end) {
        for (unsigned int c = 0; c < 3; ++c)
          if (end[c] >= 0)
            springs.push_back({{{base[c], end[c]}}, stiffness});
      });
    return make_rotational_springs(numbering, std::move(springs));
  }

  namespace
  {
    std::unique_ptr<Effect>
    make_plane_laws(const LatticeModel                        &model,
                    const JointRelease                        &release,
                    const std::shared_ptr<const ConnectorLaw> &law)
    {
      std::vector<std::array<int, 2>> unknowns;
      std::vector<unsigned int>       numbers;
      unsigned int                    number = 0;
      for_each_spring(model,
                      release,
                      number,
                      [&](const unsigned int i,
                          const auto        &base,
                          const auto        &end) {
                        unknowns.push_back({{base[2], end[2]}});
                        numbers.push_back(i);
                      });
      return make_rotational_laws(model.numbering,
                                  release.definition->name,
                                  law,
                                  unknowns,
                                  numbers);
    }

    std::unique_ptr<Effect>
    make_axis_laws(const LatticeModel                        &model,
                   const JointRelease                        &release,
                   const std::shared_ptr<const ConnectorLaw> &law)
    {
      std::vector<AxisPair> pairs;
      unsigned int          number = 0;
      for_each_spring(
        model,
        release,
        number,
        [&](const unsigned int i, const auto &base, const auto &end) {
          pairs.push_back({base, end, release.definition->axis, i});
        });
      return make_axis_laws(model.numbering,
                            model.plan.simulated.large_rotation,
                            release.definition->name,
                            law,
                            pairs);
    }
  } // namespace

  std::vector<std::unique_ptr<Effect>>
  make_rotational_laws(const LatticeModel &model)
  {
    std::vector<std::unique_ptr<Effect>> effects;
    for (const JointRelease &release : model.releases)
      {
        std::shared_ptr<const ConnectorLaw> law = release.definition->law;
        if (!law)
          continue;
        if (!model.plan.simulated.connector_viscosity && law->is_viscous())
          law = law->without_viscosity();
        effects.push_back(model.lattice.dimension == 2
                            ? make_plane_laws(model, release, law)
                            : make_axis_laws(model, release, law));
      }
    return effects;
  }

  std::unique_ptr<Constraints> make_revolute_hinges(const LatticeModel &model)
  {
    const DofNumbering        &numbering = model.numbering;
    std::vector<RevoluteHinge> hinges;
    unsigned int               number = 0;
    for (const JointRelease &release : model.releases)
      if (release.definition->type == JointDefinition::Type::revolute)
        for (const RotationPair &pair : release.pairs)
          {
            const std::array<int, 2> multipliers = {
              {numbering.constraints().hinge_multiplier(number, 0),
               numbering.constraints().hinge_multiplier(number, 1)}};
            ++number;
            if (multipliers[0] >= 0)
              hinges.push_back({spins(numbering, pair.base),
                                spins(numbering, pair.end),
                                multipliers,
                                release.definition->axis});
          }
    return number > 0
      ? make_revolute_hinges(numbering,
                             model.plan.simulated.large_rotation,
                             model.mean_strut_length,
                             hinges)
      : nullptr;
  }
} // namespace auxfem
