#include <auxfem/loads/load_definitions.h>
#include <auxfem/mesh/lattice_definition.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace auxfem
{
  TimeFunction read_time_function(ParameterValues      &values,
                                  const TimeExpression &parameter)
  {
    const std::string text = values[parameter];
    if (const auto table = table_text(text))
      {
        // A comma may be part of the name, or stand before a column.
        const std::string file = absolute_file(table->file, values.context);
        values.files.push_back(file);
        values.files.push_back(
          dealii::Utilities::trim(file.substr(0, file.rfind(','))));
        values.set(parameter.name, table->prefix + " " + file);
      }
    return TimeFunction(text, parameter.name, values.context);
  }

  namespace
  {
    const Choice support_type = {
      "Type",
      "clamp",
      {"clamp", "pin", "roller x", "roller y", "roller z", "prescribed"},
      "Held or prescribed components."};

    const auto motion = for_components<TimeExpression>(
      {"Displacement",
       "free",
       "m",
       "Time history of the displacement",
       {"free"}},
      {"Rotation", "free", "rad", "Time history of the rotation", {"free"}});

    const QuantityList moment_point = {
      "Moments about",
      "none",
      "m",
      Range::any(),
      2,
      3,
      "Point, fixed in space, about which history.csv has the moment of the "
      "support's forces and moments; none: not recorded.",
      {"none"}};

    /** Holds those of the first @p n components that the dimension has. */
    void hold(const unsigned int dimension,
              const unsigned int n,
              SupportDefinition &support)
    {
      for (unsigned int c = 0; c < n; ++c)
        support.fixed[c] = dimension == 3 || is_in_plane(c);
    }

    void read_motion(ParameterValues &values, SupportDefinition &support)
    {
      for (unsigned int c = 0; c < n_motion_components; ++c)
        {
          if (!is_in_plane(c))
            require_space(values, motion[c]);
          if (!values.is_word(motion[c]))
            {
              support.fixed[c]  = true;
              support.motion[c] = read_time_function(values, motion[c]);
            }
        }
      if (support.fixed == std::array<bool, n_motion_components>())
        values.refuse("Type = prescribed, but everything is free. Give at "
                      "least one of the displacements and rotations, e.g. "
                      "Displacement x, or remove the support");
    }
  } // namespace



  SubsectionSchema supports_schema()
  {
    return {
      "Supports",
      SubsectionSchema::Form::named_groups,
      "Joints that are held or moved.",
      {set_of_joints, support_type, moment_point},
      "Type",
      {{"clamp", "Neither displacement nor rotation.", {}},
       {"pin", "No displacement, free rotation.", {}},
       {"roller x", "Free to move along x only and to rotate.", {}},
       {"roller y", "Free to move along y only and to rotate.", {}},
       {"roller z",
        "Free to move along z only and to rotate; with Dimension = 3.",
        {}},
       {"prescribed",
        "Each component is free or has a time history. In space three rotations "
        "are a rotation vector; one or two of them are angles about fixed axes, "
        "as of a shaft, whose derivatives are the angular velocities. With "
        "inertia, an impulse acts at each corner of the motion, e.g. at the rows "
        "of a table.",
        {motion.begin(), motion.end()}}}};
  }



  SupportDefinition read_support(ParameterValues &values)
  {
    SupportDefinition support;
    support.name           = values.name();
    support.path           = values.context.path;
    support.joints         = values[set_of_joints];
    const std::string type = values[support_type];
    if (type == "roller z")
      require_space(values, support_type, "Choose another Type");
    if (type == "clamp")
      hold(values.context.dimension, n_motion_components, support);
    else if (type == "pin")
      hold(values.context.dimension, 3, support);
    else if (type == "prescribed")
      read_motion(values, support);
    else
      {
        hold(values.context.dimension, 3, support);
        support.fixed[type.back() - 'x'] = false;
      }
    if (!values.is_word(moment_point))
      support.moment_point = dealii::Point<3>(vector_of(values, moment_point));

    return support;
  }

  namespace
  {
    const Text loaded_struts = {"Struts", "", "Set of struts.", true};

    // Masses

    const Quantity     mass                = {"Mass",
                                              "",
                                              "kg",
                                              Range::non_negative(),
                                              "Mass on every joint of the set."};
    const QuantityList mass_rotary_inertia = {
      "Rotary inertia",
      "0",
      "kg m2",
      Range::non_negative(),
      1,
      3,
      "Moment of inertia of the mass: one number, in space for every axis, or "
      "three, about x, y and z at rest, of which the plane uses the last."};

    // Loads

    const Choice load_type = {
      "Type",
      "joint",
      {"joint", "line", "pressure", "temperature", "pretension"},
      "What loads joints or struts."};

    const auto joint_load = for_components<TimeExpression>(
      {"Force", "0", "N", "Force on every joint of the set"},
      {"Moment", "0", "N m", "Moment on every joint of the set"});

    const Text distribution = {
      "Distribution",
      "1",
      "Factor of the load by position at rest: an expression in x, y, z (m) and "
      "the bounds xmin, xmax, ... of the lattice."};

    const Choice load_direction = {
      "Direction",
      "fixed",
      {"fixed", "follows the joint"},
      "Whether force and moment, given as at rest, keep their direction or turn "
      "with the joint."};

    const auto line_load = for_axes<TimeExpression>(
      {"Force per length", "0", "N/m", "Force per undeformed length"});

    const TimeExpression pressure = {
      "Pressure",
      "0",
      "N/m",
      "Time history of the force per current length, to the left of the way from "
      "the first joint to the second."};

    const TimeExpression temperature = {
      "Temperature",
      "0",
      "K",
      "Time history of the temperature above that at rest; free struts grow by "
      "Thermal expansion of their material."};

    const TimeExpression gradient_2 = {
      "Temperature gradient 2",
      "0",
      "K/m",
      "Time history of the temperature's slope along axis 2 of the section, in "
      "the plane the axis to the left of the strut; free struts curve."};

    const TimeExpression gradient_3 = {
      "Temperature gradient 3",
      "0",
      "K/m",
      "The same along axis 3, unused in the plane."};

    const TimeExpression pretension = {
      "Pretension",
      "0",
      "N",
      "Time history of the axial force while both ends of a strut are where "
      "they were drawn, tension positive; the equilibrium of the structure "
      "changes it."};

    JointLoadDefinition read_joint_load(ParameterValues &values)
    {
      JointLoadDefinition load;
      load.name          = values.name();
      load.path          = values.context.path;
      load.joints        = values[set_of_joints];
      load.distribution  = values[distribution];
      load.follows_joint = values[load_direction] != "fixed";
      for (unsigned int c = 0; c < joint_load.size(); ++c)
        {
          if (!is_in_plane(c))
            require_space(values, joint_load[c]);
          load.components[c] = read_time_function(values, joint_load[c]);
        }
      return load;
    }

    LineLoadDefinition read_line_load(ParameterValues &values)
    {
      LineLoadDefinition load;
      load.name         = values.name();
      load.path         = values.context.path;
      load.struts       = values[loaded_struts];
      load.distribution = values[distribution];
      require_space(values, line_load[2]);
      for (unsigned int c = 0; c < line_load.size(); ++c)
        load.components[c] = read_time_function(values, line_load[c]);
      return load;
    }

    PressureDefinition read_pressure(ParameterValues &values)
    {
      if (values.context.dimension == 3)
        values.refuse(load_type,
                      "struts in space have no side. Use Type = line");
      return {values.name(),
              values[loaded_struts],
              read_time_function(values, pressure),
              values[distribution],
              values.context.path};
    }

    /** The initial strains of one load; those that stay zero are left out. */
    std::vector<InitialStrainDefinition>
    read_initial_strains(ParameterValues &values)
    {
      using Cause = InitialStrainDefinition::Cause;
      std::vector<InitialStrainDefinition> strains;
      const auto add = [&](const TimeExpression &parameter, const Cause cause) {
        InitialStrainDefinition strain{values.name(),
                                       values[loaded_struts],
                                       cause,
                                       read_time_function(values, parameter),
                                       values[distribution],
                                       values.context.path};
        if (!strain.history.is_zero())
          strains.push_back(strain);
      };
      if (values[load_type] == "pretension")
        {
          add(pretension, Cause::pretension);
          return strains;
        }
      require_space(values, gradient_3);
      add(temperature, Cause::temperature);
      add(gradient_2, Cause::gradient_2);
      add(gradient_3, Cause::gradient_3);
      return strains;
    }

    // Gravity

    const auto acceleration = for_axes<TimeExpression>(
      {"Acceleration", "0", "m/s2", "Acceleration of free fall"});

    // Base motion

    const auto base_acceleration = for_axes<TimeExpression>(
      {"Acceleration",
       "0",
       "m/s2",
       "Acceleration of the base, such as `table: quake.csv`"});

    /** The @p components of an acceleration. */
    AccelerationDefinition
    read_acceleration(ParameterValues                     &values,
                      const std::array<TimeExpression, 3> &components)
    {
      AccelerationDefinition result;
      require_space(values, components[2]);
      for (unsigned int c = 0; c < components.size(); ++c)
        result.acceleration[c] = read_time_function(values, components[c]);
      return result;
    }

    // Initial velocities

    const auto initial_velocity = for_components<Quantity>(
      {"Velocity", "0", "m/s", Range::any(), "Velocity at t = 0"},
      {"Angular velocity",
       "0",
       "rad/s",
       Range::any(),
       "Angular velocity at t = 0"});


    /** Appends @p components to @p parameters. */
    template <class Components>
    Parameters with(Parameters parameters, const Components &components)
    {
      parameters.insert(parameters.end(), components.begin(), components.end());
      return parameters;
    }
  } // namespace



  SubsectionSchema masses_schema()
  {
    return {"Masses",
            SubsectionSchema::Form::named_groups,
            "Point masses on joints.",
            {set_of_joints, mass, mass_rotary_inertia}};
  }



  MassDefinition read_mass(ParameterValues &values)
  {
    return {values.name(),
            values[set_of_joints],
            values[mass],
            moments_of_inertia_of(values, mass_rotary_inertia),
            values.context.path};
  }



  SubsectionSchema loads_schema()
  {
    return {
      "Loads",
      SubsectionSchema::Form::named_groups,
      "Forces, moments, temperatures and pretension; loads of a joint or "
      "strut add up.",
      {load_type},
      "Type",
      {{"joint",
        "Force and moment on joints.",
        with({set_of_joints, load_direction, distribution}, joint_load)},
       {"line",
        "Dead force per length on struts.",
        with({loaded_struts, distribution}, line_load)},
       {"pressure",
        "Force normal to struts in the plane, which follows them.",
        {loaded_struts, pressure, distribution}},
       {"temperature",
        "Temperature of struts, uniform along them.",
        {loaded_struts, temperature, gradient_2, gradient_3, distribution}},
       {"pretension",
        "Struts built in too short, as cables that are tightened. With "
        "inertia, Static start = on begins in the equilibrium.",
        {loaded_struts, pretension, distribution}}}};
  }



  std::variant<JointLoadDefinition,
               LineLoadDefinition,
               PressureDefinition,
               std::vector<InitialStrainDefinition>>
  read_load(ParameterValues &values)
  {
    if (values[load_type] == "joint")
      return read_joint_load(values);
    if (values[load_type] == "line")
      return read_line_load(values);
    if (values[load_type] == "pressure")
      return read_pressure(values);
    return read_initial_strains(values);
  }



  SubsectionSchema gravity_schema()
  {
    return {
      "Gravity",
      SubsectionSchema::Form::fixed,
      "Weight of struts and masses, e.g. Acceleration y = -9.81, or in load "
      "steps -9.81 * min(t, 1).",
      with({}, acceleration)};
  }



  AccelerationDefinition read_gravity(ParameterValues &values)
  {
    return read_acceleration(values, acceleration);
  }

  SubsectionSchema base_motion_schema()
  {
    return {
      "Base motion",
      SubsectionSchema::Form::fixed,
      "Earthquakes and shakers: supports, plates and all results are relative to "
      "a base that accelerates without turning. Masses are loaded by minus this "
      "acceleration, so that a record needs no correction of its drift. In a "
      "frequency response it is the amplitude.",
      with({}, base_acceleration)};
  }



  AccelerationDefinition read_base_motion(ParameterValues &values)
  {
    return read_acceleration(values, base_acceleration);
  }

  bool AccelerationDefinition::is_zero() const
  {
    return std::all_of(acceleration.begin(),
                       acceleration.end(),
                       [](const TimeFunction &along) {
                         return along.is_zero();
                       });
  }

  std::vector<TimeFunction> AccelerationDefinition::varying_components() const
  {
    std::vector<TimeFunction> all;
    for (const TimeFunction &along : acceleration)
      if (!along.is_constant())
        all.push_back(along);
    return all;
  }

  SubsectionSchema initial_velocities_schema()
  {
    return {"Initial velocities",
            SubsectionSchema::Form::named_groups,
            "Velocities at t = 0 of joint sets, each moving as a rigid body. "
            "Struts with both ends in these sets move along.",
            with({set_of_joints}, initial_velocity)};
  }



  InitialVelocityDefinition read_initial_velocity(ParameterValues &values)
  {
    InitialVelocityDefinition definition;
    definition.name   = values.name();
    definition.path   = values.context.path;
    definition.joints = values[set_of_joints];
    for (unsigned int c = 0; c < initial_velocity.size(); ++c)
      {
        if (!is_in_plane(c))
          require_space(values, initial_velocity[c]);
        definition.velocity[c] = values[initial_velocity[c]];
      }
    return definition;
  }
} // namespace auxfem
