#include <auxfem/equations/effects/contact_effect.h>
#include <auxfem/equations/plate_proximity.h>

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

    /** A point of a strut that touches a plate. */
    struct PlateTouch : Touch
    {
      unsigned int point; ///< of the axis
      unsigned int plate; ///< in the order of the scene
      /** Of the force on the strut: out of the plate. In a step between two
       * states not quite of length 1. */
      Vector3 normal = {};
      /** By minus this the depth changes with the position. */
      Vector3 now     = {};
      Tensor  turning = {}; ///< of `normal`, by the position (1/m)

      /** Of the plate on the strut (N). */
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
      PlateTouches(const Scene &scene, const LatticeModel &model)
        : ContactEffect(scene, model)
        , points_of_axes(make_contact_points(model.lattice, axes))
        , proximity(scene, model, axes, points_of_axes)
      {
        proximity.refuse_bad_plates();
      }

      bool update_couplings(const State      &accepted,
                            std::vector<int> &wanted) override
      {
        if (!proximity.follow(accepted))
          return false;
        want_unknowns(wanted);
        return true;
      }

      void save(Records &records) const override
      {
        proximity.save(records);
      }

      bool resume(const Records &records, std::vector<int> &wanted) override
      {
        proximity.resume(records);
        want_unknowns(wanted);
        return true;
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectResults    *results) const override
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
                       const EffectResults  *results,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        if (factors.stiffness == 0 && factors.damping == 0)
          return;
        const bool   is_between  = evaluation.kind == Evaluation::Kind::between;
        const double by_position = is_between ? 1. : factors.stiffness,
                     by_velocity =
                       is_between ? 1. / evaluation.dt : factors.damping;
        std::vector<double> block;
        for (const PlateTouch &touch : points_of(results))
          {
            const Tensor of_point =
              stiffness_of(touch, by_position, by_velocity);
            const std::size_t n = coupled[touch.pair].unknowns.size();
            block.assign(n * n, 0.);
            std::size_t row = 0;
            add_to_unknowns(
              touch,
              [&](const int, const unsigned int a, const double of_row) {
                std::size_t column = row * n;
                add_to_unknowns(
                  touch,
                  [&](const int, const unsigned int b, const double of_column) {
                    block[column++] = of_row * of_column * of_point[a][b];
                  });
                ++row;
              });
            matrix.add(first_block + touch.pair, block.data());
          }
      }

      void raise_forces(const Evaluation & /*evaluation*/,
                        const EffectResults *results,
                        double              *forces) const override
      {
        for (const PlateTouch &touch : points_of(results))
          add_to_unknowns(touch,
                          [&](const int unknown,
                              const unsigned int /*component*/,
                              const double share) {
                            raise(forces,
                                  unknown,
                                  std::abs(share) * touch.force);
                          });
      }

      void raise_uncertain_forces(const Evaluation    &evaluation,
                                  const EffectResults *results,
                                  const LargestMotion &largest,
                                  double              *forces) const override
      {
        for (const PlateTouch &touch : points_of(results))
          {
            // Depths are differences of positions, and where they are round-off
            // themselves the stiffness is none that can be told.
            const double length = largest.displacement +
              position(touch, evaluation.to.displacement).norm();
            const double slope = law_at(touch).slope(
              touch.depth + std::numeric_limits<double>::epsilon() * length);
            add_to_unknowns(touch,
                            [&](const int unknown,
                                const unsigned int /*component*/,
                                const double share) {
                              raise(forces,
                                    unknown,
                                    std::abs(share) *
                                      (touch.force +
                                       std::max(slope, touch.slope) * length));
                            });
          }
      }

      bool may_touch() const override
      {
        return !near().empty();
      }

      std::string why_not_acceptable(const Evaluation &step) const override
      {
        const auto found = proximity.first_too_deep(step);
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

      std::vector<PlateReport> reports(const EffectResults &results,
                                       const State &state) const override
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
              largest         = std::max(largest, penetration(touch).part);
            }
        const UnknownLayout &layout = model.numbering.layout();
        forces                      = layout.sum(forces);
        std::vector<PlateReport> of_plates;
        for (unsigned int i = 0; i < n_plates(); ++i)
          of_plates.push_back(
            {displacements[i],
             Vector3({forces[3 * i], forces[3 * i + 1], forces[3 * i + 2]}),
             layout.largest(penetrations[i])});
        return of_plates;
      }

      std::vector<ContactReport> contacts(const EffectResults &results,
                                          const State &state) const override
      {
        std::vector<ContactReport> all;
        for (const PlateTouch &touch : points_of(&results))
          if (is_owned(touch) &&
              (touch.depth > 0 || touch.whole_force().norm() > 0))
            all.push_back(
              {axes[touch.axis].strut,
               touch.plate,
               points_of_axes[touch.axis].rest[touch.point],
               proximity.displacement(touch.axis, touch.point, state),
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
        const PlateDefinition &definition =
          *proximity.plates()[plate].definition;
        std::vector<std::vector<dealii::Point<3>>> lines;
        for (const auto &line : definition.surface->outline(size, dimension))
          {
            lines.emplace_back();
            for (const Vector3 &point : line)
              lines.back().push_back(definition.position + point);
          }
        return lines;
      }

    private:
      const std::vector<PlatePair> &near() const override
      {
        return proximity.near();
      }

      std::vector<int> unknowns_of(const PlatePair &pair) const override
      {
        std::vector<int>        unknowns = axes[pair.axis].unknowns;
        const std::vector<int> &of_plate =
          proximity.plates()[pair.plate].unknowns;
        unknowns.insert(unknowns.end(), of_plate.begin(), of_plate.end());
        return unknowns;
      }

      std::vector<PlateTouch>
      touching(const Evaluation &evaluation) const override
      {
        std::vector<PlateTouch> points;
        for (unsigned int i = 0; i < coupled.size(); ++i)
          {
            const PlatePair &pair = coupled[i].pair;
            for (unsigned int p = 0; p < points_of_axes[pair.axis].size(); ++p)
              if (const auto touch =
                    press(evaluation, {{i, pair.axis}, p, pair.plate}))
                points.push_back(*touch);
          }
        return points;
      }

      ContactLaw law_at(const PlateTouch &touch) const override
      {
        return {axes[touch.axis].stiffness *
                  points_of_axes[touch.axis].weights[touch.point],
                parameters.smoothing * proximity.thickness(touch.axis)};
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
        const std::vector<int> &unknowns = coupled[touch.pair].unknowns;
        Vector3                 result =
          points_of_axes[touch.axis].displacement(touch.point,
                                                  dimension,
                                                  unknowns.data(),
                                                  values.data());
        const std::size_t of_plate = axes[touch.axis].n_nodes() * dimension;
        for (unsigned int c = 0; c < dimension; ++c)
          result[c] -= values[unknowns[of_plate + c]];
        return result;
      }

      const RigidSurface &surface_of(const PlateTouch &touch) const
      {
        return *proximity.plates()[touch.plate].definition->surface;
      }

      /** Of a contact point from the point of reference of the plate (m). */
      Vector3 position(const PlateTouch &touch,
                       const Vector     &displacement) const
      {
        return points_of_axes[touch.axis].rest[touch.point] -
          proximity.plates()[touch.plate].definition->position +
          difference(touch, displacement);
      }

      /** Of a point of a near pair, if it touches. */
      std::optional<PlateTouch> press(const Evaluation &evaluation,
                                      PlateTouch        touch) const
      {
        const bool   is_between = evaluation.kind == Evaluation::Kind::between;
        const double half       = axes[touch.axis].half_thickness;
        const RigidSurface &surface = surface_of(touch);
        const Vector3       to = position(touch, evaluation.to.displacement);
        Vector3             from;
        touch.depth         = half - surface.distance(to);
        double depth_before = touch.depth;
        if (is_between)
          {
            from         = position(touch, evaluation.from.displacement);
            depth_before = half - surface.distance(from);
          }
        if (touch.depth <= 0 && depth_before <= 0)
          return {};
        const SurfaceDistance now = surface.at(to);
        const ContactLaw      law = law_at(touch);
        touch.now                 = now.normal;
        if (is_between)
          {
            const MeanDistance mean = surface.between(from, to);
            touch.force             = law.mean_force(depth_before, touch.depth);
            touch.slope             = law.mean_slope(depth_before, touch.depth);
            touch.normal            = mean.direction;
            touch.turning           = mean.change;
          }
        else
          {
            touch.force   = law.force(touch.depth);
            touch.slope   = law.slope(touch.depth);
            touch.normal  = now.normal;
            touch.turning = now.curvature;
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

      /** Calls @p add(unknown, component, share) for all unknowns of a point's
       * pair: its motion against the plate is their sum times the share. */
      template <class Add>
      void add_to_unknowns(const PlateTouch &touch, const Add &add) const
      {
        const ContactAxis      &axis     = axes[touch.axis];
        const std::vector<int> &unknowns = coupled[touch.pair].unknowns;
        for (unsigned int node = 0; node <= axis.n_nodes(); ++node)
          {
            const double share = node < axis.n_nodes()
              ? (*points_of_axes[touch.axis].shape)(touch.point, node)
              : -1.;
            for (unsigned int c = 0; c < dimension; ++c)
              add(unknowns[node * dimension + c], c, share);
          }
      }

      /** Derivative of minus the force on the strut by its motion against the
       * plate (N/m). */
      Tensor stiffness_of(const PlateTouch &touch,
                          const double      by_position,
                          const double      by_velocity) const
      {
        const Tensor of_pressure =
          touch.slope * dealii::outer_product(touch.normal, touch.now) -
          touch.force * touch.turning;
        if (touch.friction.scale == 0)
          return by_position * of_pressure;

        const double         length    = touch.normal.norm();
        const Vector3        n         = touch.normal / length;
        const FrictionChange change    = friction.change(touch.friction, n);
        const Tensor         of_normal = touch.turning / length -
          dealii::outer_product(n, n * touch.turning) / length;
        return by_velocity * change.by_velocity +
          by_position *
          (of_pressure + change.by_normal * of_normal -
           touch.slope * dealii::outer_product(change.by_pressure, touch.now));
      }

      const std::vector<ContactPoints> points_of_axes; ///< of each axis
      PlateProximity                   proximity;
    };
  } // namespace


  std::unique_ptr<PlateContact> make_plate_contact(const Scene        &scene,
                                                   const LatticeModel &model)
  {
    return std::make_unique<PlateTouches>(scene, model);
  }
} // namespace auxfem
