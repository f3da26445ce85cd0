#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene_sections.h>
#include <auxfem/scene/scene_space.h>

namespace auxfem
{
  namespace
  {
    const Text     struts          = {"Struts",
                                      "",
                                      "Set of struts that are rigid; or give Joints."};
    const Text     joints          = {"Joints",
                                      "",
                                      "Set of joints that move as one rigid part without "
                                                   "struts of its own; or give Struts."};
    const Choice   parts           = {"Parts",
                                      "struts that meet",
                                      {"struts that meet", "single struts"},
                                      "What is one part: rigid struts connected with each "
                                                  "other, or every strut (bars hinged at both ends)."};
    const Quantity rigid_part_mass = {
      "Mass",
      "0 kg",
      "kg",
      Range::non_negative(),
      "Mass of each part, spread evenly along its struts, "
      "without struts equally over its joints."};
    const QuantityList rotary_inertia = {
      "Rotary inertia",
      "auto",
      "kg m2",
      Range::non_negative(),
      1,
      3,
      "Moment of inertia of each part about its centre of mass: one number, in "
      "space the same about every axis, or three, about x, y and z at rest, of "
      "which the plane uses the last; auto: that of the spread mass.",
      {"auto"}};
    const Choice elastic_struts = {
      "Elastic struts",
      "hinged",
      {"hinged", "clamped"},
      "How elastic struts that end at joints of the part are connected to it."};

    void check_rotary_inertia(dealii::ParameterHandler   &prm,
                              const SceneContext         &context,
                              const dealii::Tensor<1, 3> &moments)
    {
      const std::string entry = context.path + "/" + rotary_inertia.name +
        " = " + prm.get(rotary_inertia.name);
      if (moments.norm() == 0)
        throw InputError(entry +
                         ": it must not be zero. Allowed: numbers > 0, "
                         "or auto for that of the spread mass");
      if (context.dimension == 2)
        return;
      for (unsigned int axis = 0; axis < 3; ++axis)
        {
          const double others =
            moments[(axis + 1) % 3] + moments[(axis + 2) % 3];
          // a flat part has equality, up to the digits given
          if (moments[axis] > others * (1 + 1e-6))
            throw InputError(entry +
                             ": no body has such moments, since none "
                             "is greater than the sum of the other "
                             "two. Correct them, or set auto");
        }
    }

    void read_rigid_part(dealii::ParameterHandler &prm,
                         const std::string        &name,
                         const SceneContext       &context,
                         Scene                    &scene)
    {
      RigidPartDefinition part;
      part.name          = name;
      part.path          = context.path;
      part.struts        = get(prm, struts);
      part.joints        = get(prm, joints);
      part.single_struts = get(prm, parts) == "single struts";
      part.mass          = get(prm, rigid_part_mass);
      part.clamps_struts = get(prm, elastic_struts) == "clamped";
      if (!is_word(prm, rotary_inertia))
        {
          part.rotary_inertia =
            read_moments_of_inertia(prm, rotary_inertia, context);
          check_rotary_inertia(prm, context, *part.rotary_inertia);
        }
      if (part.struts.empty() == part.joints.empty())
        throw InputError(part.path + ": give either Struts or Joints, " +
                         (part.struts.empty() ? "here none of them is given"
                                              : "here both are given"));
      if (part.mass == 0 && part.rotary_inertia)
        throw InputError(part.path +
                         ": Rotary inertia is given, but Mass = 0. "
                         "Give the part a mass");
      scene.rigid_parts.push_back(part);
    }
  } // namespace



  SubsectionKind rigid_parts_kind()
  {
    return {"Rigid parts",
            SubsectionKind::Form::named_groups,
            "Struts or joints that move as rigid bodies, hinged to each other "
            "where they share a joint.",
            [](dealii::ParameterHandler &prm) {
              declare(prm, struts);
              declare(prm, joints);
              declare(prm, parts);
              declare(prm, rigid_part_mass);
              declare(prm, rotary_inertia);
              declare(prm, elastic_struts);
            },
            "",
            {},
            read_rigid_part};
  }
} // namespace auxfem
