#include <auxfem/contact/effects/contact_effect.h>
#include <auxfem/contact/effects/plate_proximity.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using Vector3 = dealii::Tensor<1, 3>;
    using Tensor  = dealii::Tensor<2, 3>;

    /** A contact point of a strut on a plate. */
    struct PlateTouch : Touch
    {
      ContactQuadraturePoint point;
      unsigned int           plate; ///< in the order of the scene
      /** Shape functions of the axis' nodes at the point. */
      std::array<double, AxisCurve::max_degree + 1> shape = {};
      /** Position relative to the reference point of the plate (m). */
      Vector3 position = {};
      /** Direction of the force on the strut; for discrete gradients not
       * exactly of unit length. */
      Vector3 normal = {};
      /** Negative gradient of the depth with respect to the position. */
      Vector3 now = {};
      Tensor  normal_gradient =
        {}; ///< derivative of `normal` with respect to the position (1/m)

      /** Force of the plate on the strut (N). */
      Vector3 whole_force() const
      {
        return force * normal + friction.force;
      }
    };

    /** See PlateContact. */
    class PlateTouches
      : public ContactEffect<PlateContact, PlatePair, PlateTouch>
    {
    public:
      explicit PlateTouches(const LatticeModel &model)
        : ContactEffect(model)
        , points_of_axes(model, axes)
        , proximity(model, curves)
      {
        proximity.refuse_bad_plates();
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache      *results) const override
      {
        auto &points = static_cast<Results &>(*results).points;
        points       = touching(evaluation);
        for (const PlateTouch &touch : points)
          {
            const Vector3 force = touch.whole_force();
            add_to_unknowns(touch,
                            [&](const int          unknown,
                                const unsigned int component,
                                const double       share) {
                              residual[unknown] -= share * force[component];
                            });
          }
      }

      void add_tangent(const Evaluation     &evaluation,
                       const EffectCache    *results,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        if (factors.stiffness == 0 && factors.damping == 0)
          return;
        const bool is_between =
          evaluation.kind == Evaluation::Kind::discrete_gradient;
        const double by_position = is_between ? 1. : factors.stiffness,
                     by_velocity =
                       is_between ? 1. / evaluation.dt : factors.damping;
        const std::vector<PlateTouch> &points = points_of(results);
        std::vector<double>            block;
        for (auto touch = points.begin(); touch != points.end();)
          {
            const unsigned int pair = touch->pair;
            const std::size_t  n    = coupled[pair].unknowns.size();
            block.assign(n * n, 0.);
            for (; touch != points.end() && touch->pair == pair; ++touch)
              add_block(*touch,
                        stiffness_of(*touch, by_position, by_velocity),
                        block);
            matrix.add(first_block + pair, block.data());
          }
      }

      void row_force_bounds(const Evaluation & /*evaluation*/,
                            const EffectCache *results,
                            double            *forces) const override
      {
        for (const PlateTouch &touch : points_of(results))
          add_to_unknowns(touch,
                          [&](const int unknown,
                              const unsigned int /*component*/,
                              const double share) {
                            raise_bound(forces,
                                        unknown,
                                        std::abs(share) * touch.force);
                          });
      }

      void roundoff_force_bounds(const Evaluation & /*evaluation*/,
                                 const EffectCache   *results,
                                 const LargestMotion &largest,
                                 double              *forces) const override
      {
        for (const PlateTouch &touch : points_of(results))
          {
            // Depths are differences of positions; where they are round-off,
            // the stiffness is uncertain.
            const double length = largest.displacement + touch.position.norm();
            const double slope  = law_at(touch).slope(
              touch.depth + std::numeric_limits<double>::epsilon() * length);
            add_to_unknowns(touch,
                            [&](const int unknown,
                                const unsigned int /*component*/,
                                const double share) {
                              raise_bound(forces,
                                          unknown,
                                          std::abs(share) *
                                            (touch.force +
                                             std::max(slope, touch.slope) *
                                               length));
                            });
          }
      }

      bool has_contact_candidates() const override
      {
        return !near().empty();
      }

      std::string rejection_reason(const Evaluation &step) const override
      {
        const auto found = proximity.first_excessive_penetration(step);
        if (!found)
          return "";
        std::ostringstream why;
        why << "strut " << found->strut << " would go " << found->depth
            << " m into " << touched_plate(name(found->plate));
        if (found->is_near)
          why << ", more than Contact/Largest penetration allows";
        return why.str();
      }

      unsigned int n_plates() const override
      {
        return proximity.plates().size();
      }

      std::vector<PlateReport> reports(const EffectCache &results,
                                       const State       &state) const override
      {
        const std::vector<Vector3> displacements =
          proximity.plate_values(state.displacement);
        std::vector<double> forces(3 * n_plates(), 0.);
        std::vector<double> penetrations(n_plates(), 0.);
        for (const PlateTouch &touch : points_of(&results))
          if (is_owned(touch))
            {
              const Vector3 force = touch.whole_force();
              for (unsigned int c = 0; c < 3; ++c)
                forces[3 * touch.plate + c] -= force[c];
              double &largest = penetrations[touch.plate];
              largest         = std::max(largest, penetration(touch).fraction);
            }
        const UnknownLayout &layout = model.numbering.layout();
        forces                      = layout.sum(forces);
        std::vector<PlateReport> plate_reports;
        for (unsigned int i = 0; i < n_plates(); ++i)
          plate_reports.push_back(
            {displacements[i],
             Vector3({forces[3 * i], forces[3 * i + 1], forces[3 * i + 2]}),
             layout.largest(penetrations[i])});
        return plate_reports;
      }

      std::vector<ContactReport> contacts(const EffectCache &results,
                                          const State &state) const override
      {
        std::vector<ContactReport> all;
        for (const PlateTouch &touch : points_of(&results))
          if (is_owned(touch) &&
              (touch.depth > 0 || touch.whole_force().norm() > 0))
            all.push_back(
              {axes[touch.axis].strut,
               touch.plate,
               dealii::Point<3>(
                 curves.at_rest(touch.axis).at(touch.point.parameter)),
               motion_of_axis(touch, state.displacement),
               proximity.thickness(touch.axis) * touch.now,
               touch.whole_force(),
               touch.depth});
        return all;
      }

      const std::string &name(const unsigned int plate) const override
      {
        return proximity.plates()[plate].definition->name;
      }

      std::vector<std::vector<dealii::Point<3>>>
      outline(const unsigned int plate, const double size) const override
      {
        const PlateProximity::Plate &drawn = proximity.plates()[plate];
        std::vector<std::vector<dealii::Point<3>>> lines;
        for (const auto &line :
             drawn.definition->surface->outline(size, dimension))
          {
            lines.emplace_back();
            for (const Vector3 &point : line)
              lines.back().push_back(drawn.position + point);
          }
        return lines;
      }

    private:
      bool follow(const State &accepted) override
      {
        return proximity.follow(accepted);
      }

      bool restart(const State &accepted) override
      {
        return proximity.restart(accepted);
      }

      const std::vector<PlatePair> &near() const override
      {
        return proximity.near();
      }

      std::vector<int> unknowns_of(const PlatePair &pair) const override
      {
        std::vector<int>        unknowns = axes[pair.axis].unknowns;
        const std::vector<int> &plate_unknowns =
          proximity.plates()[pair.plate].unknowns;
        unknowns.insert(unknowns.end(),
                        plate_unknowns.begin(),
                        plate_unknowns.end());
        return unknowns;
      }

      std::vector<PlateTouch>
      touching(const Evaluation &evaluation) const override
      {
        std::vector<PlateTouch> points;
        for (unsigned int i = 0; i < coupled.size(); ++i)
          add_touching(i, evaluation, points);
        return points;
      }

      ContactLaw law_at(const PlateTouch &touch) const override
      {
        return {axes[touch.axis].stiffness * touch.point.weight,
                smoothing(touch.axis)};
      }

      Penetration penetration(const PlateTouch &touch) const override
      {
        return {touch.depth / (2 * proximity.thickness(touch.axis)),
                axes[touch.axis].strut,
                touch.plate};
      }

      Vector3 difference(const PlateTouch &touch,
                         const Vector     &values) const override
      {
        return motion_of_axis(touch, values) -
          motion_of_plate(touch.pair, values);
      }

      /** Depth up to which the contact law is quadratic (m). */
      double smoothing(const unsigned int axis) const
      {
        return parameters.smoothing * proximity.thickness(axis);
      }

      Vector3 motion_of_axis(const PlateTouch &touch,
                             const Vector     &values) const
      {
        const std::vector<int> &unknowns = coupled[touch.pair].unknowns;
        Vector3                 result;
        for (unsigned int node = 0; node < axes[touch.axis].n_nodes(); ++node)
          for (unsigned int c = 0; c < dimension; ++c)
            result[c] +=
              touch.shape[node] * values[unknowns[node * dimension + c]];
        return result;
      }

      Vector3 motion_of_plate(const unsigned int pair,
                              const Vector      &values) const
      {
        const Coupled    &coupled_pair = coupled[pair];
        const std::size_t first =
          axes[coupled_pair.pair.axis].n_nodes() * dimension;
        Vector3 result;
        for (unsigned int c = 0; c < dimension; ++c)
          result[c] = values[coupled_pair.unknowns[first + c]];
        return result;
      }

      /** Axis of a pair relative to the reference point of its plate. */
      AxisCurve curve_at(const unsigned int pair,
                         const Vector      &displacement) const
      {
        const Coupled &coupled_pair = coupled[pair];
        AxisCurve      curve        = curves.curve(coupled_pair.pair.axis,
                                       coupled_pair.unknowns.data(),
                                       displacement.data());
        curve.coefficients[0] -=
          proximity.plates()[coupled_pair.pair.plate].position +
          motion_of_plate(pair, displacement);
        return curve;
      }

      /** Adds the contact points of a near pair. */
      void add_touching(const unsigned int       pair,
                        const Evaluation        &evaluation,
                        std::vector<PlateTouch> &points) const
      {
        const auto [axis, plate] = coupled[pair].pair;
        const RigidSurface &surface =
          *proximity.plates()[plate].definition->surface;
        std::vector<AxisCurve> at_times = {
          curve_at(pair, evaluation.to.displacement)};
        if (evaluation.kind == Evaluation::Kind::discrete_gradient)
          at_times.push_back(curve_at(pair, evaluation.from.displacement));
        for (const ContactQuadraturePoint &point :
             points_of_axes.quadrature_points(
               axis,
               {surface, axes[axis].half_thickness, smoothing(axis)},
               at_times))
          if (const auto touch = contact_at(evaluation,
                                            surface,
                                            at_times,
                                            {{pair, axis}, point, plate}))
            points.push_back(*touch);
      }

      /** Contact at a point of a near pair; empty if it does not touch.
       * @param at_times curves at the end and, for discrete gradients, at the
       *   start */
      std::optional<PlateTouch>
      contact_at(const Evaluation             &evaluation,
                 const RigidSurface           &surface,
                 const std::vector<AxisCurve> &at_times,
                 PlateTouch                    touch) const
      {
        const bool is_between =
          evaluation.kind == Evaluation::Kind::discrete_gradient;
        const double  half = axes[touch.axis].half_thickness;
        const Vector3 to   = at_times[0].at(touch.point.parameter);
        Vector3       from;
        touch.position      = to;
        touch.depth         = half - surface.distance(to);
        double depth_before = touch.depth;
        if (is_between)
          {
            from         = at_times[1].at(touch.point.parameter);
            depth_before = half - surface.distance(from);
          }
        if (touch.depth <= 0 && depth_before <= 0)
          return {};
        curves.shape(touch.axis, touch.point.parameter, touch.shape.data());
        const SurfaceDistance now = surface.at(to);
        const ContactLaw      law = law_at(touch);
        touch.now                 = now.normal;
        if (is_between)
          {
            const MeanDistance mean = surface.between(from, to);
            touch.force             = law.mean_force(depth_before, touch.depth);
            touch.slope             = law.mean_slope(depth_before, touch.depth);
            touch.normal            = mean.direction;
            touch.normal_gradient   = mean.change;
          }
        else
          {
            touch.force           = law.force(touch.depth);
            touch.slope           = law.slope(touch.depth);
            touch.normal          = now.normal;
            touch.normal_gradient = now.curvature;
          }
        if (friction.coefficient > 0 &&
            evaluation.kind != Evaluation::Kind::equilibrium)
          touch.friction =
            friction.force(sliding_velocity(evaluation,
                                            [&](const Vector &u) {
                                              return difference(touch, u);
                                            }),
                           touch.normal / touch.normal.norm(),
                           touch.force);
        return touch;
      }

      /** Calls @p add(unknown, component, share) for all unknowns of the pair;
       * the relative motion of the point is the sum of shares times
       * unknowns. */
      template <class Add>
      void add_to_unknowns(const PlateTouch &touch, const Add &add) const
      {
        const ContactAxis      &axis     = axes[touch.axis];
        const std::vector<int> &unknowns = coupled[touch.pair].unknowns;
        for (unsigned int node = 0; node <= axis.n_nodes(); ++node)
          {
            const double share =
              node < axis.n_nodes() ? touch.shape[node] : -1.;
            for (unsigned int c = 0; c < dimension; ++c)
              add(unknowns[node * dimension + c], c, share);
          }
      }

      /** Adds the stiffness of a point to the block of its pair.
       * @param stiffness stiffness_of() the point */
      void add_block(const PlateTouch    &touch,
                     const Tensor        &stiffness,
                     std::vector<double> &block) const
      {
        std::size_t at = 0;
        add_to_unknowns(
          touch,
          [&](const int, const unsigned int a, const double row_share) {
            add_to_unknowns(
              touch,
              [&](const int, const unsigned int b, const double column_share) {
                block[at++] += row_share * column_share * stiffness[a][b];
              });
          });
      }

      /** Derivative of the negative force on the strut with respect to the
       * relative motion (N/m). */
      Tensor stiffness_of(const PlateTouch &touch,
                          const double      by_position,
                          const double      by_velocity) const
      {
        const Tensor pressure_stiffness =
          touch.slope * dealii::outer_product(touch.normal, touch.now) -
          touch.force * touch.normal_gradient;
        if (touch.friction.scale == 0)
          return by_position * pressure_stiffness;

        const double         length        = touch.normal.norm();
        const Vector3        n             = touch.normal / length;
        const FrictionChange change        = friction.change(touch.friction, n);
        const Tensor         normal_change = touch.normal_gradient / length -
          dealii::outer_product(n, n * touch.normal_gradient) / length;
        return by_velocity * change.by_velocity +
          by_position *
          (pressure_stiffness + change.by_normal * normal_change -
           touch.slope * dealii::outer_product(change.by_pressure, touch.now));
      }

      const PlateContactPoints points_of_axes;
      PlateProximity           proximity;
    };
  } // namespace


  std::unique_ptr<PlateContact> make_plate_contact(const LatticeModel &model)
  {
    return std::make_unique<PlateTouches>(model);
  }
} // namespace auxfem
