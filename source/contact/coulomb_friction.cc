#include <auxfem/contact/coulomb_friction.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace auxfem
{
  FrictionForce CoulombFriction::force(const dealii::Tensor<1, 3> &velocity,
                                       const dealii::Tensor<1, 3> &normal,
                                       const double pressure) const
  {
    FrictionForce result;
    result.recess = velocity * normal;
    result.slip   = velocity - result.recess * normal;
    result.scale =
      std::sqrt(result.slip.norm_square() + slip_velocity * slip_velocity);
    result.limit = coefficient * pressure;
    result.force = -result.limit / result.scale * result.slip;
    return result;
  }

  FrictionChange
  CoulombFriction::change(const FrictionForce        &force,
                          const dealii::Tensor<1, 3> &normal) const
  {
    const dealii::Tensor<2, 3> identity = dealii::unit_symmetric_tensor<3>();
    const dealii::Tensor<1, 3> part     = force.slip / force.scale;
    const dealii::Tensor<2, 3> of_slip  = force.limit / force.scale *
      (identity - dealii::outer_product(part, part));
    return {of_slip * (identity - dealii::outer_product(normal, normal)),
            -1 * of_slip *
              (dealii::outer_product(normal, force.slip) +
               force.recess * identity),
            coefficient * part};
  }
} // namespace auxfem
