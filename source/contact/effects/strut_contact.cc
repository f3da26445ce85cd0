#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/contact/effects/touching_struts.h>

#include <set>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** See StrutContact. */
    class StrutTouches
      : public ContactEffect<StrutContact, AxisPair, StrutTouch>
    {
    public:
      explicit StrutTouches(const LatticeModel &model)
        : ContactEffect(model)
        , points_of_axes(curves, dimension)
        , proximity(model, curves)
      {}

      void register_in(StateLayout &layout) override
      {
        ContactEffect::register_in(layout);
        numerical_entry = layout.acceleration
          ? layout.energies.enter(numerical_energy_entry())
          : 0;
      }

      void register_blocks(TangentPattern &pattern) override
      {
        ContactEffect::register_blocks(pattern);
        std::vector<AxisPair> pairs;
        local_unknowns.clear();
        for (const Coupled &coupled_pair : coupled)
          {
            pairs.push_back(coupled_pair.pair);
            auto first = coupled_pair.unknowns.begin();
            for (const unsigned int axis : coupled_pair.pair)
              {
                if (first == coupled_pair.unknowns.end())
                  break; // Self-contact lists the unknowns once.
                const auto end = first + axes[axis].unknowns.size();
                local_unknowns.try_emplace(axis, first, end);
                first = end;
              }
          }
        facing = points_of_axes.facing_struts(pairs);
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache      *results) const override
      {
        auto &points = static_cast<Results &>(*results).points;
        points       = touching(evaluation);
        for (const StrutTouch &touch : points)
          {
            const StrutTouchMotion motion = motion_of(touch);
            for (const StrutTouch::Opposite &opposite : touch.opposites)
              motion.add_force(opposite.parameter,
                               -touch.force / touch.opposites.size() *
                                 opposite.direction,
                               residual);
            if (touch.friction.scale > 0)
              motion.add_force(touch.opposites.back().parameter,
                               -touch.friction.force,
                               residual);
          }
      }

      void add_tangent(const Evaluation     &evaluation,
                       const EffectCache    *results,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        const std::vector<StrutTouch> &points = points_of(results);
        if (points.empty() || (factors.stiffness == 0 && factors.damping == 0))
          return;
        const bool is_between =
          evaluation.kind == Evaluation::Kind::discrete_gradient;
        const NearCurves    now = curves_at(evaluation.to);
        std::vector<double> block;
        for (const StrutTouch &touch : points)
          {
            const StrutTouchMotion motion = motion_of(touch);
            const AxisCurve       &other  = now.at(touch.other);
            const std::size_t      n      = coupled[touch.pair].unknowns.size();
            block.assign(n * n, 0.);
            if (is_between)
              motion.add_mean_block(block);
            else
              motion.add_instant_block(other, factors.stiffness, block);
            if (touch.friction.scale > 0)
              motion.add_friction_block(
                friction,
                other,
                evaluation,
                is_between ? TangentFactors{1., 1 / evaluation.dt, 0.}
                           : factors,
                block);
            matrix.add(first_block + touch.pair, block.data());
          }
      }
      void account_step(const Evaluation  &step,
                        const EffectCache *results,
                        EnergyAccount     &account) const override
      {
        ContactEffect::account_step(step, results, account);
        if (step.kind == Evaluation::Kind::discrete_gradient &&
            account.has_duration())
          for (const StrutTouch &touch : points_of(results))
            if (is_owned(touch))
              account.add_in_step(numerical_entry, touch.stored_energy_defect);
      }

      void row_force_bounds(const Evaluation & /*evaluation*/,
                            const EffectCache *results,
                            double            *forces) const override
      {
        for (const StrutTouch &touch : points_of(results))
          for (const int unknown : coupled[touch.pair].unknowns)
            raise_bound(forces, unknown, touch.force);
      }

      void roundoff_force_bounds(const Evaluation & /*evaluation*/,
                                 const EffectCache   *results,
                                 const LargestMotion &largest,
                                 double              *forces) const override
      {
        for (const StrutTouch &touch : points_of(results))
          for (const int unknown : coupled[touch.pair].unknowns)
            raise_bound(forces,
                        unknown,
                        touch.force + touch.slope * largest.displacement);
      }

      bool has_contact_candidates() const override
      {
        return proximity.has_contact_candidates();
      }

      std::string rejection_reason(const Evaluation &step) const override
      {
        const UnknownLayout &layout = model.numbering.layout();
        std::vector<double>  before, after;
        const auto           found = proximity.first_excessive_approach(
          by_global_number(step.from.displacement, layout, before),
          by_global_number(step.to.displacement, layout, after),
          parameters.largest_penetration);
        if (!found)
          return "";
        std::ostringstream why;
        why
          << "strut " << axes[(*found)[0]].strut << " and strut "
          << axes[(*found)[1]].strut
          << " would go into each other deeper than Contact/Largest penetration "
             "allows";
        return why.str();
      }

      std::unique_ptr<FirstContactDetector>
      first_contact_detector() const override
      {
        return std::make_unique<FirstContactDetector>(model, curves, proximity);
      }

      const std::vector<StrutOverlap> &overlaps() const override
      {
        return proximity.overlaps();
      }

      std::vector<ContactReport> contacts(const EffectCache &results,
                                          const State &state) const override
      {
        std::vector<ContactReport> all;
        for (const StrutTouch &touch : points_of(&results))
          {
            if (!is_owned(touch) || (touch.depth <= 0 && touch.force == 0))
              continue;
            SpaceVector force = touch.friction.force;
            for (const StrutTouch::Opposite &opposite : touch.opposites)
              force +=
                touch.force / touch.opposites.size() * opposite.direction;
            const SpaceVector now =
              curves
                .curve(touch.axis,
                       local_unknowns.at(touch.axis).data(),
                       state.displacement.data())
                .at(touch.parameter);
            const SpaceVector rest =
              curves.at_rest(touch.axis).at(touch.parameter);
            all.push_back(
              {axes[touch.axis].strut,
               axes[touch.other].strut,
               dealii::Point<3>(rest),
               now - rest,
               axes[touch.axis].half_thickness * touch.opposites.back().normal,
               force,
               touch.depth});
          }
        return all;
      }

    private:
      using SpaceVector = dealii::Tensor<1, 3>;

      bool follow(const State &accepted) override
      {
        std::vector<double> gathered;
        return proximity.follow(by_global_number(accepted.displacement,
                                                 model.numbering.layout(),
                                                 gathered));
      }

      bool restart(const State &accepted) override
      {
        std::vector<double> gathered;
        return proximity.restart(by_global_number(accepted.displacement,
                                                  model.numbering.layout(),
                                                  gathered));
      }

      const std::vector<AxisPair> &near() const override
      {
        return proximity.near();
      }

      std::vector<int> unknowns_of(const AxisPair &pair) const override
      {
        std::vector<int> unknowns = axes[pair[0]].unknowns;
        if (pair[1] != pair[0])
          unknowns.insert(unknowns.end(),
                          axes[pair[1]].unknowns.begin(),
                          axes[pair[1]].unknowns.end());
        return unknowns;
      }

      std::vector<StrutTouch>
      touching(const Evaluation &evaluation) const override
      {
        std::vector<StrutTouch> points;
        if (facing.empty())
          return points;
        const NearCurves now = curves_at(evaluation.to);
        if (evaluation.kind == Evaluation::Kind::discrete_gradient)
          {
            const NearCurves before = curves_at(evaluation.from);
            for (const FacingStrut &facing_strut : facing)
              add_mean_contacts(facing_strut, before, now, evaluation, points);
          }
        else
          for (const FacingStrut &facing_strut : facing)
            add_instant_contacts(facing_strut, now, evaluation, points);
        return points;
      }

      ContactLaw law_at(const StrutTouch &touch) const override
      {
        const double one   = axes[touch.axis].stiffness,
                     other = axes[touch.other].stiffness;
        // The points of the other strut carry the other half.
        return {touch.weight / 2 * one * other / (one + other),
                parameters.smoothing *
                  curves.thickness(touch.axis, touch.other)};
      }

      /** Relative to the mean thickness of both struts. */
      Penetration penetration(const StrutTouch &touch) const override
      {
        return {touch.depth / curves.thickness(touch.axis, touch.other),
                axes[touch.axis].strut,
                axes[touch.other].strut};
      }

      SpaceVector difference(const StrutTouch &touch,
                             const Vector     &values) const override
      {
        return motion_of(touch).difference(values);
      }

      NearCurves curves_at(const State &state) const
      {
        NearCurves now;
        for (const auto &[axis, unknowns] : local_unknowns)
          now.emplace(axis,
                      curves.curve(axis,
                                   unknowns.data(),
                                   state.displacement.data()));
        return now;
      }

      StrutTouchMotion motion_of(const StrutTouch &touch) const
      {
        const Coupled &coupled_pair = coupled[touch.pair];
        return {curves,
                dimension,
                touch,
                coupled_pair.pair,
                coupled_pair.unknowns};
      }

      /** A contact point without forces. */
      StrutTouch contact_without_force(const FacingStrut    &facing_strut,
                                       const NearestOfStrut &found,
                                       const unsigned int    point) const
      {
        const unsigned int axis = facing_strut.axis, other = found.target.axis;
        const double       depth =
          curves.thickness(axis, other) - found.point.distance;
        return {{found.target.pair, axis, depth},
                other,
                points_of_axes.parameter(axis, point),
                points_of_axes.weight(axis, point),
                found.point.distance,
                found.point.is_inside};
      }

      /** Adds the contact points at an instant. */
      void add_instant_contacts(const FacingStrut       &facing_strut,
                                const NearCurves        &now,
                                const Evaluation        &evaluation,
                                std::vector<StrutTouch> &points) const
      {
        for (const auto &[i, found] :
             points_of_axes.touching(facing_strut, now))
          {
            const SpaceVector point =
              now.at(facing_strut.axis)
                .at(points_of_axes.parameter(facing_strut.axis, i));
            StrutTouch touch = contact_without_force(facing_strut, found, i);
            const ContactLaw law = law_at(touch);
            touch.force          = law.force(touch.depth);
            touch.slope          = law.slope(touch.depth);
            const SpaceVector away =
              point - now.at(touch.other).at(found.point.parameter);
            const SpaceVector normal = away / found.point.distance;
            touch.opposites          = {
                       {found.point.parameter, normal, normal, found.point.distance}};
            if (friction.coefficient > 0 &&
                evaluation.kind != Evaluation::Kind::equilibrium)
              add_friction(evaluation, touch);
            points.push_back(touch);
          }
      }

      /** Adds the contact points with mean forces (discrete gradient). */
      void add_mean_contacts(const FacingStrut       &facing_strut,
                             const NearCurves        &before,
                             const NearCurves        &now,
                             const Evaluation        &step,
                             std::vector<StrutTouch> &points) const
      {
        std::set<unsigned int> touching;
        for (const NearCurves *const curves_at_end : {&before, &now})
          for (const TouchingPoint &point :
               points_of_axes.touching(facing_strut, *curves_at_end))
            touching.insert(point.point);
        for (const unsigned int i : touching)
          {
            const double at = points_of_axes.parameter(facing_strut.axis, i);
            const SpaceVector from = before.at(facing_strut.axis).at(at),
                              to   = now.at(facing_strut.axis).at(at);
            const NearestOfStrut
              first = points_of_axes.nearest(facing_strut, before, from, at),
              last  = points_of_axes.nearest(facing_strut, now, to, at);
            StrutTouch touch     = contact_without_force(facing_strut, last, i);
            const ContactLaw law = law_at(touch);
            const double     depth_before =
              curves.thickness(touch.axis, touch.other) - first.point.distance;
            touch.force   = law.mean_force(depth_before, touch.depth);
            touch.slope   = law.mean_slope(depth_before, touch.depth);
            double gained = 0;
            for (const NearestOfStrut &nearest : {first, last})
              {
                // If the nearest points lie on two elements, that of the end is
                // used for both.
                const double      parameter = nearest.target.axis == touch.other
                       ? nearest.point.parameter
                       : last.point.parameter;
                const SpaceVector q0 =
                                    from - before.at(touch.other).at(parameter),
                                  q1 = to - now.at(touch.other).at(parameter);
                const double sum     = q0.norm() + q1.norm();
                touch.opposites.push_back(
                  {parameter, (q0 + q1) / sum, q1 / q1.norm(), sum});
                gained += (q1.norm() - q0.norm()) / 2;
              }
            touch.stored_energy_defect = -touch.force *
              (gained - (last.point.distance - first.point.distance));
            if (friction.coefficient > 0)
              add_friction(step, touch);
            points.push_back(touch);
          }
      }

      /** Sets the friction at a point whose other members are set. */
      void add_friction(const Evaluation &evaluation, StrutTouch &touch) const
      {
        touch.friction =
          friction.force(sliding_velocity(evaluation,
                                          [&](const Vector &u) {
                                            return difference(touch, u);
                                          }),
                         touch.opposites.back().normal,
                         touch.force);
      }

      const StrutContactPoints points_of_axes;
      StrutProximity           proximity;
      std::vector<FacingStrut> facing;
      /** Local unknowns of the axes in `coupled`. */
      std::map<unsigned int, std::vector<int>> local_unknowns;
      unsigned int                             numerical_entry = 0;
    };
  } // namespace


  std::unique_ptr<StrutContact> make_strut_contact(const LatticeModel &model)
  {
    return std::make_unique<StrutTouches>(model);
  }
} // namespace auxfem
