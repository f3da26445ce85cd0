#include <auxfem/equations/effects/strut_contact.h>

namespace auxfem
{
  namespace
  {
    /** Adds @p factor times the product of two vectors to a square block. */
    void add_product(const double               factor,
                     const std::vector<double> &rows,
                     const std::vector<double> &columns,
                     std::vector<double>       &block)
    {
      const std::size_t n = rows.size();
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          block[i * n + j] += factor * rows[i] * columns[j];
    }

    dealii::Tensor<1, 3> unit(const unsigned int direction)
    {
      dealii::Tensor<1, 3> result;
      result[direction] = 1;
      return result;
    }
  } // namespace

  void StrutContact::add_instant_block(const StrutTouch       &touch,
                                       const StrutTouchMotion &motion,
                                       const AxisCurve        &other,
                                       const double            by_position,
                                       std::vector<double>    &block) const
  {
    const StrutTouch::Opposite &opposite = touch.opposites.back();
    const SpaceVector          &n        = opposite.normal;
    const double at = opposite.parameter, distance = opposite.length;
    const std::vector<double> of_normal = motion.gradient(at, n);
    add_product(by_position * (touch.slope + touch.force / distance),
                of_normal,
                of_normal,
                block);
    for (unsigned int c = 0; c < dimension; ++c)
      {
        const std::vector<double> along = motion.gradient(at, unit(c));
        add_product(-by_position * touch.force / distance, along, along, block);
      }
    if (!touch.is_inside)
      return;
    // The nearest point moves along the other axis.
    const std::vector<double> moving  = motion.nearest_change(other);
    const SpaceVector         tangent = other.tangent(at);
    add_product(by_position * touch.force *
                  (tangent * tangent / distance - n * other.bend(at)),
                moving,
                moving,
                block);
  }

  void StrutContact::add_mean_block(const StrutTouch       &touch,
                                    const StrutTouchMotion &motion,
                                    std::vector<double>    &block) const
  {
    const StrutTouch::Opposite &last = touch.opposites.back();
    const std::vector<double>   of_depth =
      motion.gradient(last.parameter, last.normal);
    const double part = 1. / touch.opposites.size();
    for (const StrutTouch::Opposite &opposite : touch.opposites)
      {
        const std::vector<double> of_direction =
          motion.gradient(opposite.parameter, opposite.direction);
        add_product(part * touch.slope, of_direction, of_depth, block);
        const double turning = -part * touch.force / opposite.length;
        for (unsigned int c = 0; c < dimension; ++c)
          {
            const std::vector<double> along =
              motion.gradient(opposite.parameter, unit(c));
            add_product(turning, along, along, block);
          }
        add_product(-turning,
                    of_direction,
                    motion.gradient(opposite.parameter, opposite.normal),
                    block);
      }
  }

  void StrutContact::add_friction_block(const StrutTouch       &touch,
                                        const StrutTouchMotion &motion,
                                        const AxisCurve        &other,
                                        const Evaluation       &evaluation,
                                        const TangentFactors   &factors,
                                        std::vector<double>    &block) const
  {
    const StrutTouch::Opposite &last   = touch.opposites.back();
    const SpaceVector          &n      = last.normal;
    const FrictionChange        change = friction.change(touch.friction, n);
    const auto                  across = change.by_normal / touch.distance;
    std::vector<double>         moving;
    SpaceVector                 by_moving;
    if (touch.is_inside)
      {
        moving    = motion.nearest_change(other);
        by_moving = factors.stiffness *
          (change.by_velocity *
             sliding_velocity(evaluation,
                              [&](const Vector &u) {
                                return motion.difference_slope(u);
                              }) -
           across * other.tangent(last.parameter));
        // The point that the force acts on moves too.
        add_product(factors.stiffness,
                    motion.tangent_gradient(touch.friction.force),
                    moving,
                    block);
      }
    for (unsigned int c = 0; c < dimension; ++c)
      {
        SpaceVector by_motion = factors.damping * change.by_velocity[c] +
          factors.stiffness *
            (across[c] - (across[c] * n) * n -
             touch.slope * change.by_pressure[c] * n);
        std::vector<double> of_force =
          motion.gradient(last.parameter, by_motion);
        for (std::size_t i = 0; i < moving.size(); ++i)
          of_force[i] += by_moving[c] * moving[i];
        add_product(1.,
                    motion.gradient(last.parameter, unit(c)),
                    of_force,
                    block);
      }
  }

  void StrutContact::add_tangent(const Evaluation     &evaluation,
                                 const EffectResults  *results,
                                 const TangentFactors &factors,
                                 TangentMatrix        &matrix) const
  {
    const std::vector<StrutTouch> &points = points_of(results);
    if (points.empty() || (factors.stiffness == 0 && factors.damping == 0))
      return;
    const bool       is_between = evaluation.kind == Evaluation::Kind::between;
    const NearCurves now        = curves_at(evaluation.to);
    std::vector<double> block;
    for (const StrutTouch &touch : points)
      {
        const StrutTouchMotion motion = motion_of(touch);
        const AxisCurve       &other  = now.at(touch.other);
        const std::size_t      n      = coupled[touch.pair].unknowns.size();
        block.assign(n * n, 0.);
        if (is_between)
          add_mean_block(touch, motion, block);
        else
          add_instant_block(touch, motion, other, factors.stiffness, block);
        if (touch.friction.scale > 0)
          add_friction_block(touch,
                             motion,
                             other,
                             evaluation,
                             is_between
                               ? TangentFactors{1., 1 / evaluation.dt, 0.}
                               : factors,
                             block);
        matrix.add(first_block + touch.pair, block.data());
      }
  }
} // namespace auxfem
