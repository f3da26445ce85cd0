#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene_sections.h>
#include <auxfem/scene/scene_space.h>

#include <deal.II/base/utilities.h>

namespace auxfem
{
  namespace
  {
    using Form = SubsectionKind::Form;
    using dealii::ParameterHandler;

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
      "Its moment of inertia: one number, in space the same about every axis, "
      "or three, about x, y and z at rest, of which the plane uses the last."};

    SubsectionKind masses_kind()
    {
      return {"Masses",
              Form::named_groups,
              "Point masses on joints.",
              [](ParameterHandler &prm) {
                declare(prm, set_of_joints);
                declare(prm, mass);
                declare(prm, mass_rotary_inertia);
              },
              "",
              {},
              [](ParameterHandler   &prm,
                 const std::string  &name,
                 const SceneContext &context,
                 Scene              &scene) {
                scene.masses.push_back(
                  {name,
                   get(prm, set_of_joints),
                   get(prm, mass),
                   read_moments_of_inertia(prm, mass_rotary_inertia, context),
                   context.path});
              }};
    }

    // Loads

    const Choice load_type = {"Type",
                              "joint",
                              {"joint", "line"},
                              "Whether joints or struts are loaded."};

    const auto joint_load = for_components<TimeExpression>(
      {"Force", "0", "N", "Force on every joint of the set"},
      {"Moment", "0", "N m", "Moment on every joint of the set"});

    const Choice load_direction = {
      "Direction",
      "fixed",
      {"fixed", "follows the joint"},
      "Whether force and moment keep their direction, or turn with the rotation "
      "of the joint; they are given as they are at rest."};

    const auto line_load = for_axes<TimeExpression>(
      {"Force per length", "0", "N/m", "Force per undeformed length"});

    void read_joint_load(ParameterHandler    &prm,
                         const SceneContext  &context,
                         JointLoadDefinition &load)
    {
      load.joints        = get(prm, set_of_joints);
      load.follows_joint = get(prm, load_direction) != "fixed";
      for (unsigned int c = 0; c < joint_load.size(); ++c)
        {
          if (!is_in_plane(c))
            require_space(prm, joint_load[c], context);
          load.components[c] = read_time_function(prm, joint_load[c], context);
        }
    }

    void read_line_load(ParameterHandler   &prm,
                        const SceneContext &context,
                        LineLoadDefinition &load)
    {
      load.struts = get(prm, loaded_struts);
      require_space(prm, line_load[2], context);
      for (unsigned int c = 0; c < line_load.size(); ++c)
        load.components[c] = read_time_function(prm, line_load[c], context);
    }

    void read_load(ParameterHandler   &prm,
                   const std::string  &name,
                   const SceneContext &context,
                   Scene              &scene)
    {
      if (get(prm, load_type) == "joint")
        {
          JointLoadDefinition load;
          load.name = name;
          load.path = context.path;
          read_joint_load(prm, context, load);
          scene.joint_loads.push_back(load);
        }
      else
        {
          LineLoadDefinition load;
          load.name = name;
          load.path = context.path;
          read_line_load(prm, context, load);
          scene.line_loads.push_back(load);
        }
    }

    SubsectionKind loads_kind()
    {
      return {"Loads",
              Form::named_groups,
              "Forces and moments; all loads of a joint or strut add up.",
              [](ParameterHandler &prm) { declare(prm, load_type); },
              "Type",
              {{"joint",
                "Force and moment on joints.",
                [](ParameterHandler &prm) {
                  declare(prm, set_of_joints);
                  declare(prm, load_direction);
                  for (const TimeExpression &entry : joint_load)
                    declare(prm, entry);
                }},
               {"line",
                "Dead force per length on struts.",
                [](ParameterHandler &prm) {
                  declare(prm, loaded_struts);
                  for (const TimeExpression &entry : line_load)
                    declare(prm, entry);
                }}},
              read_load};
    }

    // Gravity

    const auto acceleration = for_axes<Quantity>(
      {"Acceleration", "0", "m/s2", Range::any(), "Acceleration of free fall"});

    void read_gravity(ParameterHandler &prm,
                      const std::string &,
                      const SceneContext &context,
                      Scene              &scene)
    {
      require_space(prm, acceleration[2], context);
      for (unsigned int c = 0; c < acceleration.size(); ++c)
        scene.gravity[c] = get(prm, acceleration[c]);
    }

    SubsectionKind gravity_kind()
    {
      return {"Gravity",
              Form::fixed,
              "Weight of struts and masses, e.g. Acceleration y = -9.81.",
              [](ParameterHandler &prm) {
                for (const Quantity &entry : acceleration)
                  declare(prm, entry);
              },
              "",
              {},
              read_gravity};
    }

    // Initial velocities

    const auto initial_velocity = for_components<Quantity>(
      {"Velocity", "0", "m/s", Range::any(), "Velocity at t = 0"},
      {"Angular velocity",
       "0",
       "rad/s",
       Range::any(),
       "Angular velocity at t = 0"});

    void read_initial_velocity(ParameterHandler   &prm,
                               const std::string  &name,
                               const SceneContext &context,
                               Scene              &scene)
    {
      InitialVelocityDefinition definition;
      definition.name   = name;
      definition.path   = context.path;
      definition.joints = get(prm, set_of_joints);
      for (unsigned int c = 0; c < initial_velocity.size(); ++c)
        {
          if (!is_in_plane(c))
            require_space(prm, initial_velocity[c], context);
          definition.velocity[c] = get(prm, initial_velocity[c]);
        }
      scene.initial_velocities.push_back(definition);
    }

    SubsectionKind initial_velocities_kind()
    {
      return {
        "Initial velocities",
        Form::named_groups,
        "Joints that move at t = 0, each set as a rigid body; struts move "
        "along if both their ends are in these sets.",
        [](ParameterHandler &prm) {
          declare(prm, set_of_joints);
          for (const Quantity &entry : initial_velocity)
            declare(prm, entry);
        },
        "",
        {},
        read_initial_velocity};
    }
  } // namespace



  TimeFunction read_time_function(ParameterHandler     &prm,
                                  const TimeExpression &entry,
                                  const SceneContext   &context,
                                  const TableKind       tables)
  {
    const std::string text = get(prm, entry);
    if (const auto table = table_text(text))
      prm.set(entry.name,
              table->word + " " + absolute_file(table->file, context));
    return TimeFunction(text, entry.name, context, tables);
  }



  std::vector<SubsectionKind> load_kinds()
  {
    return {supports_kind(),
            masses_kind(),
            loads_kind(),
            gravity_kind(),
            initial_velocities_kind()};
  }
} // namespace auxfem
