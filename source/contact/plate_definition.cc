#include <auxfem/contact/plate_definition.h>
#include <auxfem/loads/load_definitions.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
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

    const Quantity plate_gap = {
      "Gap",
      "as placed",
      "m",
      Range::non_negative(),
      "Gap to the face of the nearest strut at rest; the body is moved from its "
      "Position towards that strut, a plane along its normal. 0: it touches, "
      "also a lattice with imperfections. as placed: Position counts.",
      {"as placed"}};

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
    Parameters parameters = {plate_shape, plate_position, plate_gap};
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
    if (!values.is_word(plate_gap))
      plate.gap = values[plate_gap];
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
