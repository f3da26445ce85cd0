#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/scene_sections.h>

#include <deal.II/base/utilities.h>

namespace auxfem
{
  namespace
  {
    using Form = SubsectionKind::Form;
    using dealii::ParameterHandler;

    const Text joints = {"Joints", "", "Set of joints.", true};
    const Text struts = {"Struts", "", "Set of struts.", true};

    /** Components of motion and load in the plane. */
    constexpr std::array<unsigned int, 3> plane_components = {{0, 1, 5}};

    // Supports

    const Choice support_type = {
      "Type",
      "clamp",
      {"clamp", "pin", "roller x", "roller y", "prescribed"},
      "What is held or moved."};

    const std::array<TimeExpression, 3> support_motion = {
      {{"Displacement x",
        "free",
        "m",
        "Course of the displacement along x.",
        {"free"}},
       {"Displacement y",
        "free",
        "m",
        "Course of the displacement along y.",
        {"free"}},
       {"Rotation",
        "free",
        "rad",
        "Course of the rotation, counterclockwise.",
        {"free"}}}};

    void read_motion(ParameterHandler   &prm,
                     const SceneContext &context,
                     SupportDefinition  &support)
    {
      bool anything = false;
      for (unsigned int i = 0; i < 3; ++i)
        if (!is_word(prm, support_motion[i]))
          {
            const unsigned int c = plane_components[i];
            anything             = true;
            support.fixed[c]     = true;
            support.motion[c] =
              read_time_function(prm, support_motion[i], context);
          }
      if (!anything)
        throw InputError(context.path +
                         ": Type = prescribed, but everything is free. Give at "
                         "least one of Displacement x, Displacement y, "
                         "Rotation, or remove the support");
    }

    void read_support(ParameterHandler   &prm,
                      const std::string  &name,
                      const SceneContext &context,
                      Scene              &scene)
    {
      SupportDefinition support;
      support.name           = name;
      support.path           = context.path;
      support.joints         = get(prm, joints);
      const std::string type = get(prm, support_type);
      if (type == "clamp")
        support.fixed = {{true, true, false, false, false, true}};
      else if (type == "pin")
        support.fixed = {{true, true}};
      else if (type == "roller x")
        support.fixed = {{false, true}};
      else if (type == "roller y")
        support.fixed = {{true}};
      else
        read_motion(prm, context, support);
      scene.supports.push_back(support);
    }

    SubsectionKind supports_kind()
    {
      return {"Supports",
              Form::named_groups,
              "Joints that are held or moved.",
              [](ParameterHandler &prm) {
                declare(prm, joints);
                declare(prm, support_type);
              },
              "Type",
              {{"clamp", "Neither displacement nor rotation.", {}},
               {"pin", "No displacement, free rotation.", {}},
               {"roller x", "Free to move along x and to rotate.", {}},
               {"roller y", "Free to move along y and to rotate.", {}},
               {"prescribed",
                "Each component free or with a given course in time.",
                [](ParameterHandler &prm) {
                  for (const TimeExpression &entry : support_motion)
                    declare(prm, entry);
                }}},
              read_support};
    }

    // Masses

    const Quantity mass                = {"Mass",
                                          "",
                                          "kg",
                                          Range::non_negative(),
                                          "Mass on every joint of the set."};
    const Quantity mass_rotary_inertia = {"Rotary inertia",
                                          "0",
                                          "kg m2",
                                          Range::non_negative(),
                                          "Its moment of inertia."};

    SubsectionKind masses_kind()
    {
      return {"Masses",
              Form::named_groups,
              "Point masses on joints.",
              [](ParameterHandler &prm) {
                declare(prm, joints);
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
                   get(prm, joints),
                   get(prm, mass),
                   dealii::Tensor<1, 3>({0, 0, get(prm, mass_rotary_inertia)}),
                   context.path});
              }};
    }

    // Loads

    const Choice load_type = {"Type",
                              "joint",
                              {"joint", "line"},
                              "Whether joints or struts are loaded."};

    const std::array<TimeExpression, 3> joint_load = {
      {{"Force x", "0", "N", "Force along x on every joint of the set."},
       {"Force y", "0", "N", "Force along y on every joint of the set."},
       {"Moment",
        "0",
        "N m",
        "Moment on every joint of the set, counterclockwise."}}};

    const std::array<TimeExpression, 2> line_load = {
      {{"Force per length x",
        "0",
        "N/m",
        "Force along x per undeformed length."},
       {"Force per length y",
        "0",
        "N/m",
        "Force along y per undeformed length."}}};

    void read_load(ParameterHandler   &prm,
                   const std::string  &name,
                   const SceneContext &context,
                   Scene              &scene)
    {
      if (get(prm, load_type) == "joint")
        {
          JointLoadDefinition load;
          load.name   = name;
          load.path   = context.path;
          load.joints = get(prm, joints);
          for (unsigned int i = 0; i < joint_load.size(); ++i)
            load.components[plane_components[i]] =
              read_time_function(prm, joint_load[i], context);
          scene.joint_loads.push_back(load);
        }
      else
        {
          LineLoadDefinition load;
          load.name   = name;
          load.path   = context.path;
          load.struts = get(prm, struts);
          for (unsigned int i = 0; i < line_load.size(); ++i)
            load.components[i] = read_time_function(prm, line_load[i], context);
          scene.line_loads.push_back(load);
        }
    }

    SubsectionKind loads_kind()
    {
      return {"Loads",
              Form::named_groups,
              "Dead loads; all loads of a joint or strut add up.",
              [](ParameterHandler &prm) { declare(prm, load_type); },
              "Type",
              {{"joint",
                "Force and moment on joints.",
                [](ParameterHandler &prm) {
                  declare(prm, joints);
                  for (const TimeExpression &entry : joint_load)
                    declare(prm, entry);
                }},
               {"line",
                "Force per length on struts.",
                [](ParameterHandler &prm) {
                  declare(prm, struts);
                  for (const TimeExpression &entry : line_load)
                    declare(prm, entry);
                }}},
              read_load};
    }

    // Gravity

    const std::array<Quantity, 2> acceleration = {
      {{"Acceleration x",
        "0",
        "m/s2",
        Range::any(),
        "Acceleration of free fall along x."},
       {"Acceleration y",
        "0",
        "m/s2",
        Range::any(),
        "Acceleration of free fall along y, e.g. -9.81."}}};

    SubsectionKind gravity_kind()
    {
      return {"Gravity",
              Form::fixed,
              "Weight of struts and masses.",
              [](ParameterHandler &prm) {
                for (const Quantity &entry : acceleration)
                  declare(prm, entry);
              },
              "",
              {},
              [](ParameterHandler &prm,
                 const std::string &,
                 const SceneContext &,
                 Scene &scene) {
                for (unsigned int i = 0; i < acceleration.size(); ++i)
                  scene.gravity[i] = get(prm, acceleration[i]);
              }};
    }

    // Initial velocities

    const std::array<Quantity, 3> initial_velocity = {
      {{"Velocity x", "0", "m/s", Range::any(), "Velocity along x at t = 0."},
       {"Velocity y", "0", "m/s", Range::any(), "Velocity along y at t = 0."},
       {"Angular velocity",
        "0",
        "rad/s",
        Range::any(),
        "Angular velocity at t = 0, counterclockwise."}}};

    SubsectionKind initial_velocities_kind()
    {
      return {"Initial velocities",
              Form::named_groups,
              "Joints that move at t = 0.",
              [](ParameterHandler &prm) {
                declare(prm, joints);
                for (const Quantity &entry : initial_velocity)
                  declare(prm, entry);
              },
              "",
              {},
              [](ParameterHandler   &prm,
                 const std::string  &name,
                 const SceneContext &context,
                 Scene              &scene) {
                scene.initial_velocities.push_back(
                  {name,
                   get(prm, joints),
                   {{get(prm, initial_velocity[0]),
                     get(prm, initial_velocity[1]),
                     0,
                     0,
                     0,
                     get(prm, initial_velocity[2])}},
                   context.path});
              }};
    }
  } // namespace



  TimeFunction read_time_function(ParameterHandler     &prm,
                                  const TimeExpression &entry,
                                  const SceneContext   &context)
  {
    using dealii::Utilities::trim;

    const std::string text   = get(prm, entry);
    const std::string prefix = "table:";
    if (trim(text).compare(0, prefix.size(), prefix) == 0)
      {
        const std::string file = trim(trim(text).substr(prefix.size()));
        prm.set(entry.name, prefix + " " + absolute_file(file, context));
      }
    return TimeFunction(text, entry.name, context);
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
