#include <auxfem/joints/joint_definition.h>
#include <auxfem/joints/rotational_law.h>
#include <auxfem/mesh/lattice_definition.h>

namespace auxfem
{
  namespace
  {
    const Text released_struts =
      {"Struts", "all", "Set of struts whose ends are released there."};

    std::vector<SubsectionVariant> joint_types();

    Choice joint_type()
    {
      return {"Type",
              "hinge",
              names_of(joint_types()),
              "Connection of the struts."};
    }

    const QuantityList joint_axis = {
      "Axis",
      "",
      "1",
      Range::any(),
      3,
      3,
      "Vector x, y, z of the axis at rest, of any length but zero."};
    const QuantityList law_axis = {
      "Axis",
      "none",
      "1",
      Range::any(),
      3,
      3,
      "With Dimension = 3, where it is required: vector x, y, z of the axis at "
      "rest about which the law acts. The joint is then a revolute hinge.",
      {"none"}};
    const Quantity joint_stiffness = {
      "Stiffness",
      "",
      "N m/rad",
      Range::non_negative(),
      "Stiffness between a released strut and the unreleased struts of the "
      "joint; without any, the first released strut; for a single strut, the "
      "ground."};

    std::vector<SubsectionVariant> joint_types()
    {
      std::vector<SubsectionVariant> types = {
        {"hinge",
         "Struts turn freely, in space about every axis (a spherical joint).",
         {}},
        {"revolute",
         "Struts turn freely about one axis only; with Dimension = 3.",
         {joint_axis}},
        {"rotational spring",
         "A spring resists the relative rotation, in space about every "
         "axis alike.",
         {joint_stiffness}}};
      for (SubsectionVariant law : rotational_laws())
        {
          law.parameters.push_back(law_axis);
          types.push_back(law);
        }
      return types;
    }
  } // namespace



  SubsectionSchema joints_schema()
  {
    return {"Joints",
            SubsectionSchema::Form::named_groups,
            "Joints at which struts are not rigidly connected.",
            {set_of_joints, released_struts, joint_type()},
            "Type",
            joint_types()};
  }



  JointDefinition read_joint(ParameterValues &values)
  {
    JointDefinition joint;
    joint.name             = values.name();
    joint.path             = values.context.path;
    joint.joints           = values[set_of_joints];
    joint.struts           = values[released_struts];
    const std::string type = values[joint_type()];
    if (type == "revolute")
      {
        require_space(values,
                      joint_type(),
                      "In the plane that is Type = hinge; set it");
        joint.type = JointDefinition::Type::revolute;
        joint.axis = unit_vector_of(values, joint_axis);
      }
    if (type == "rotational spring")
      {
        joint.type      = JointDefinition::Type::rotational_spring;
        joint.stiffness = values[joint_stiffness];
      }
    else if (type != "hinge" && type != "revolute")
      {
        joint.type = JointDefinition::Type::rotational_spring;
        joint.law  = make_rotational_law(type, values);
        if (values.context.dimension == 2)
          require_space(values, law_axis);
        else if (values.is_word(law_axis))
          values.refuse(law_axis,
                        "in space the law acts about an axis. Give it, e.g. 0 "
                        "0 1, or choose Type = rotational spring");
        else
          {
            joint.type = JointDefinition::Type::revolute;
            joint.axis = unit_vector_of(values, law_axis);
          }
        joint.stiffness = joint.law->relaxed(0).stiffness;
      }
    return joint;
  }
} // namespace auxfem
