#include <auxfem/loads/motion_parameters.h>
#include <auxfem/loads/support_definition.h>
#include <auxfem/mesh/set_definition.h>

namespace auxfem
{
  namespace
  {
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
      {set_of_joints, support_type},
      "Type",
      {{"clamp", "Neither displacement nor rotation.", {}},
       {"pin", "No displacement, free rotation.", {}},
       {"roller x", "Free to move along x only and to rotate.", {}},
       {"roller y", "Free to move along y only and to rotate.", {}},
       {"roller z",
        "Free to move along z only and to rotate; with Dimension = 3.",
        {}},
       {"prescribed",
        "Each component free or with a given time history. In space three "
        "rotations are a rotation vector; one or two of them, with "
        "the others free, give the angular velocity about fixed axes "
        "as their derivative, which turns a shaft by this angle. With "
        "inertia the support strikes at each corner of its motion, as at "
        "the rows of a table.",
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

    return support;
  }
} // namespace auxfem
