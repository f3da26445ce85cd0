#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene_sections.h>
#include <auxfem/scene/scene_space.h>

namespace auxfem
{
  namespace
  {
    using dealii::ParameterHandler;

    const Choice support_type = {
      "Type",
      "clamp",
      {"clamp", "pin", "roller x", "roller y", "roller z", "prescribed"},
      "What is held or moved."};

    const auto motion = for_components<TimeExpression>(
      {"Displacement",
       "free",
       "m",
       "Time history of the displacement",
       {"free"}},
      {"Rotation", "free", "rad", "Time history of the rotation", {"free"}});

    /** Holds the first @p n components, as far as there are such. */
    void hold(const SceneContext &context,
              const unsigned int  n,
              SupportDefinition  &support)
    {
      for (unsigned int c = 0; c < n; ++c)
        support.fixed[c] = context.dimension == 3 || is_in_plane(c);
    }

    /**
     * Fixed zeros may be prescribed one by one, since without any rotation
     * about an axis there is no order of rotations to agree on.
     */
    void check_rotations(ParameterHandler        &prm,
                         const SceneContext      &context,
                         const SupportDefinition &support)
    {
      std::vector<std::string> free;
      std::string              moving;
      for (unsigned int c = 3; c < n_motion_components; ++c)
        if (!support.fixed[c])
          free.push_back(motion[c].name);
        else if (!support.motion[c].is_zero())
          moving = motion[c].name;
      if (!free.empty() && !moving.empty())
        throw InputError(
          context.path + "/" + moving + " = " + prm.get(moving) +
          ": in space a rotation that is not zero needs all three rotations "
          "prescribed, because rotations about some of the axes do not add up "
          "to a rotation. Give " +
          joined(free) + " as well, e.g. set " + free.front() + " = 0");
    }

    void read_motion(ParameterHandler   &prm,
                     const SceneContext &context,
                     SupportDefinition  &support)
    {
      for (unsigned int c = 0; c < n_motion_components; ++c)
        {
          if (!is_in_plane(c))
            require_space(prm, motion[c], context);
          if (!is_word(prm, motion[c]))
            {
              support.fixed[c] = true;
              support.motion[c] =
                read_time_function(prm, motion[c], context, TableKind::smooth);
            }
        }
      if (support.fixed == std::array<bool, n_motion_components>())
        throw InputError(context.path +
                         ": Type = prescribed, but everything is free. Give at "
                         "least one of the displacements and rotations, e.g. "
                         "Displacement x, or remove the support");
      if (context.dimension == 3)
        check_rotations(prm, context, support);
    }

    void read_support(ParameterHandler   &prm,
                      const std::string  &name,
                      const SceneContext &context,
                      Scene              &scene)
    {
      SupportDefinition support;
      support.name           = name;
      support.path           = context.path;
      support.joints         = get(prm, set_of_joints);
      const std::string type = get(prm, support_type);
      if (type == "roller z")
        require_space(prm, support_type, context, "Choose another Type");
      if (type == "clamp")
        hold(context, n_motion_components, support);
      else if (type == "pin")
        hold(context, 3, support);
      else if (type == "prescribed")
        read_motion(prm, context, support);
      else
        {
          hold(context, 3, support);
          support.fixed[type.back() - 'x'] = false;
        }
      scene.supports.push_back(support);
    }
  } // namespace



  SubsectionKind supports_kind()
  {
    return {"Supports",
            SubsectionKind::Form::named_groups,
            "Joints that are held or moved.",
            [](ParameterHandler &prm) {
              declare(prm, set_of_joints);
              declare(prm, support_type);
            },
            "Type",
            {{"clamp", "Neither displacement nor rotation.", {}},
             {"pin", "No displacement, free rotation.", {}},
             {"roller x", "Free to move along x only and to rotate.", {}},
             {"roller y", "Free to move along y only and to rotate.", {}},
             {"roller z",
              "Free to move along z only and to rotate; with Dimension = 3.",
              {}},
             {"prescribed",
              "Each component free or with a given time history; in space "
              "rotations that are not zero only all three together. Through "
              "the rows of a table goes a smooth curve (a cubic spline); "
              "`linear table: FILE` has lines between them, and every row "
              "strikes.",
              [](ParameterHandler &prm) {
                for (const TimeExpression &entry : motion)
                  declare(prm, entry);
              }}},
            read_support};
  }
} // namespace auxfem
