#include <auxfem/contact/plate_definition.h>
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

  namespace
  {
    const Choice plate_shape = {"Shape",
                                "plane",
                                {"plane", "sphere", "cylinder"},
                                "Shape of the body."};

    const QuantityList plate_position = {
      "Position",
      "",
      "m",
      Range::any(),
      2,
      3,
      "A point of the plane, the centre of the sphere, or a point of the "
      "cylinder's axis, at rest."};

    const auto plate_motion = for_axes<TimeExpression>(
      {"Displacement",
       "0",
       "m",
       "Time history of the displacement; free: moved by forces and inertia",
       {"free"}});

    const Quantity plate_mass = {"Mass",
                                 "0",
                                 "kg",
                                 Range::non_negative(),
                                 "Mass of the body."};

    const auto plate_velocity =
      for_axes<Quantity>({"Initial velocity",
                          "0",
                          "m/s",
                          Range::any(),
                          "Velocity at t = 0 of a free displacement"});

    const QuantityList plane_normal = {
      "Normal",
      "",
      "1",
      Range::any(),
      2,
      3,
      "Direction out of the body, towards the lattice; any length."};

    const Quantity body_radius = {"Radius",
                                  "",
                                  "m",
                                  Range::positive(),
                                  "Radius of the body."};

    const QuantityList cylinder_axis = {"Axis",
                                        "",
                                        "1",
                                        Range::any(),
                                        3,
                                        3,
                                        "Direction of the axis; any length."};

    std::shared_ptr<const RigidSurface>
    read_surface(const ParameterValues &values)
    {
      const std::string shape = values[plate_shape];
      if (shape == "plane")
        {
          // Rejects a normal out of the plane.
          vector_of(values, plane_normal);
          return make_plane_surface(unit_vector_of(values, plane_normal));
        }
      if (shape == "sphere")
        return make_sphere_surface(values[body_radius]);
      if (values.context.dimension == 2)
        values.refuse(plate_shape,
                      "a cylinder needs Dimension = 3. In the plane a disc is "
                      "`Shape = sphere`");
      return make_cylinder_surface(unit_vector_of(values, cylinder_axis),
                                   values[body_radius]);
    }

    bool is_free(const ParameterValues &values, const unsigned int c)
    {
      return values.is_word(plate_motion[c]);
    }

    void read_motion(ParameterValues &values, PlateDefinition &plate)
    {
      SupportDefinition support;
      support.name   = values.name();
      support.path   = values.context.path;
      support.joints = values.name();
      for (unsigned int c = 0; c < values.context.dimension; ++c)
        if (!is_free(values, c))
          {
            support.fixed[c]  = true;
            support.motion[c] = read_time_function(values, plate_motion[c]);
          }
      if (std::find(support.fixed.begin(), support.fixed.end(), true) !=
          support.fixed.end())
        plate.support = support;
    }

    void read_initial_velocity_of(ParameterValues &values,
                                  PlateDefinition &plate)
    {
      InitialVelocityDefinition initial;
      initial.name   = values.name();
      initial.path   = values.context.path;
      initial.joints = values.name();
      bool is_moving = false;
      for (unsigned int c = 0; c < values.context.dimension; ++c)
        {
          initial.velocity[c] = values[plate_velocity[c]];
          if (initial.velocity[c] == 0)
            continue;
          is_moving = true;
          if (!is_free(values, c))
            values.refuse(
              plate_velocity[c],
              "the displacement along this axis is prescribed. Set " +
                plate_motion[c].name + " = free, or remove the velocity");
        }
      if (is_moving)
        plate.initial_velocity = initial;
    }
  } // namespace



  SubsectionSchema plates_schema()
  {
    Parameters parameters = {plate_shape, plate_position};
    parameters.insert(parameters.end(),
                      plate_motion.begin(),
                      plate_motion.end());
    parameters.push_back(plate_mass);
    parameters.insert(parameters.end(),
                      plate_velocity.begin(),
                      plate_velocity.end());
    return {"Plates",
            SubsectionSchema::Form::named_groups,
            "Rigid bodies in contact with struts: fixed or moving plates, drop "
            "weights, impactors. NAME is also a set of one joint that moves "
            "with the body, for loads, connectors and probes.",
            parameters,
            "Shape",
            {{"plane", "Half space behind a plane.", {plane_normal}},
             {"sphere", "A ball, in the plane a disc.", {body_radius}},
             {"cylinder",
              "An infinite cylinder; needs Dimension = 3.",
              {cylinder_axis, body_radius}}}};
  }



  PlateDefinition read_plate(ParameterValues &values)
  {
    require_space(values, plate_motion[2]);
    require_space(values, plate_velocity[2]);
    PlateDefinition plate;
    plate.name     = values.name();
    plate.path     = values.context.path;
    plate.surface  = read_surface(values);
    plate.position = dealii::Point<3>(vector_of(values, plate_position));
    read_motion(values, plate);
    read_initial_velocity_of(values, plate);
    const double mass = values[plate_mass];
    for (unsigned int c = 0; c < values.context.dimension && mass == 0; ++c)
      if (is_free(values, c))
        values.refuse(plate_mass,
                      plate_motion[c].name +
                        " = free needs a mass. Set Mass, or prescribe the "
                        "displacement");
    if (mass > 0)
      plate.mass = MassDefinition{values.name(),
                                  values.name(),
                                  mass,
                                  {},
                                  values.context.path};
    return plate;
  }
} // namespace auxfem
