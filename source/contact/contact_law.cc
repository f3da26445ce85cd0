#include <auxfem/contact/contact_law.h>
#include <auxfem/loads/load_definitions.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  double ContactLaw::force(const double depth) const
  {
    if (depth <= 0)
      return 0;
    return depth < smoothing ? stiffness * depth * depth / (2 * smoothing)
                             : stiffness * (depth - smoothing / 2);
  }

  double ContactLaw::slope(const double depth) const
  {
    if (depth <= 0)
      return 0;
    return depth < smoothing ? stiffness * depth / smoothing : stiffness;
  }

  double ContactLaw::energy(const double depth) const
  {
    if (depth <= 0)
      return 0;
    return depth < smoothing
      ? stiffness * depth * depth * depth / (6 * smoothing)
      : stiffness *
        (depth * (depth - smoothing) / 2 + smoothing * smoothing / 6);
  }

  double ContactLaw::mean_force(const double from, const double to) const
  {
    const double low = std::min(from, to), high = std::max(from, to);
    if (!(high > low))
      return force(to);
    // Simpson's rule is exact on each piece of the law.
    const auto integral = [this](const double begin, const double end) {
      return begin < end ? (end - begin) / 6 *
          (force(begin) + 4 * force((begin + end) / 2) + force(end))
                         : 0.;
    };
    const double first  = std::max(low, 0.);
    const double middle = std::clamp(smoothing, first, std::max(first, high));
    return (integral(first, middle) + integral(middle, high)) / (high - low);
  }

  double ContactLaw::mean_slope(const double from, const double to) const
  {
    // Below this relative difference the force difference is mostly round-off.
    constexpr double digits = 1e-6;
    if (std::abs(to - from) <=
        digits * std::max({std::abs(to), std::abs(from), smoothing}))
      return slope((from + to) / 2) / 2;
    return (force(to) - mean_force(from, to)) / (to - from);
  }

  FrictionForce CoulombFriction::force(const dealii::Tensor<1, 3> &velocity,
                                       const dealii::Tensor<1, 3> &normal,
                                       const double pressure) const
  {
    FrictionForce result;
    result.normal_velocity = velocity * normal;
    result.slip            = velocity - result.normal_velocity * normal;
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
    const dealii::Tensor<2, 3> slip_derivative = force.limit / force.scale *
      (identity - dealii::outer_product(part, part));
    return {slip_derivative *
              (identity - dealii::outer_product(normal, normal)),
            -1 * slip_derivative *
              (dealii::outer_product(normal, force.slip) +
               force.normal_velocity * identity),
            coefficient * part};
  }

  namespace
  {
    const Quantity contact_stiffness = {
      "Stiffness",
      "1",
      "1",
      Range::positive(),
      "Penalty stiffness over EA / (2 h^2) per length, the stiffness between "
      "face and axis of a strut of half thickness h."};

    const Quantity contact_smoothing = {
      "Smoothing",
      "0.01",
      "1",
      Range{0, 1, true, false},
      "Penetration over half the thickness of the strut up to which the "
      "stiffness grows linearly from zero."};

    const Quantity contact_penetration = {
      "Largest penetration",
      "0.5",
      "1",
      Range{0, 1, true, true},
      "Penetration over half the thickness of the strut beyond which a step is "
      "rejected and divided."};

    const Quantity contact_friction = {
      "Friction coefficient",
      "0",
      "1",
      Range::non_negative(),
      "Coulomb's coefficient: largest friction force over normal force."};

    const Quantity contact_slip_velocity = {
      "Slip velocity",
      "1 mm/s",
      "m/s",
      Range::positive(),
      "Regularisation velocity v0: friction is proportional to "
      "v / sqrt(v^2 + v0^2), so sticking points creep slower than v0."};
  } // namespace



  SubsectionSchema contact_schema()
  {
    return {"Contact",
            SubsectionSchema::Form::fixed,
            "Penalty stiffness and friction of contact.",
            {contact_stiffness,
             contact_smoothing,
             contact_penetration,
             contact_friction,
             contact_slip_velocity}};
  }



  ContactParameters read_contact(ParameterValues &values)
  {
    ContactParameters contact;
    contact.stiffness           = values[contact_stiffness];
    contact.smoothing           = values[contact_smoothing];
    contact.largest_penetration = values[contact_penetration];
    contact.friction            = values[contact_friction];
    contact.slip_velocity       = values[contact_slip_velocity];
    return contact;
  }
} // namespace auxfem
