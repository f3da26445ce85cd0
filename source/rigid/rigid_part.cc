#include <auxfem/rigid/rigid_part.h>

#include <cmath>

namespace auxfem
{
  template <>
  NaturalPosition natural_position<2>(const dealii::Point<3> &r0,
                                      const dealii::Point<3> &r1,
                                      const dealii::Point<3> &point)
  {
    const PlaneVector d        = in_dimension<2>(r1 - r0),
                      to_point = in_dimension<2>(point - r0);
    return {(to_point * d) / (d * d), (to_point * perpendicular(d)) / (d * d)};
  }

  template <>
  NaturalPosition natural_position<3>(const dealii::Point<3> &r0,
                                      const dealii::Point<3> &r1,
                                      const dealii::Point<3> &point)
  {
    const dealii::Tensor<1, 3> d = r1 - r0;
    return {((point - r0) * d) / (d * d), 0};
  }

  template <>
  std::array<double, 4> shape<2>(const NaturalPosition &position,
                                 const unsigned int     component)
  {
    const auto [a, b] = position;
    if (component == 0)
      return {{1 - a, b, a, -b}};
    return {{-b, 1 - a, b, a}};
  }

  template <>
  std::array<double, 6> shape<3>(const NaturalPosition &position,
                                 const unsigned int     component)
  {
    std::array<double, 6> result = {};
    result[component]            = 1 - position.a;
    result[3 + component]        = position.a;
    return result;
  }

  template <int dim>
  std::array<double, 4 * dim * dim>
  rigid_mass_matrix(const double           mass,
                    const double           rotary_inertia,
                    const double           length,
                    const NaturalPosition &centre)
  {
    // Integrals over the mass of a, b and a^2 + b^2.
    const double first = mass * centre.a, skew = mass * centre.b,
                 second = mass * (centre.a * centre.a + centre.b * centre.b) +
      rotary_inertia / (length * length);
    const double m00 = mass - 2 * first + second, m01 = first - second;
    std::array<double, 4 *dim *dim> M = {};
    const auto set = [&M](const int i, const int j, const double value) {
      M[2 * dim * i + j] = M[2 * dim * j + i] = value;
    };
    for (int c = 0; c < dim; ++c)
      {
        set(c, c, m00);
        set(dim + c, dim + c, second);
        set(c, dim + c, m01);
      }
    if (dim == 2)
      {
        set(0, 3, -skew);
        set(1, 2, skew);
      }
    return M;
  }

  template std::array<double, 16>
  rigid_mass_matrix<2>(double, double, double, const NaturalPosition &);
  template std::array<double, 36>
  rigid_mass_matrix<3>(double, double, double, const NaturalPosition &);

  PlaneVector ClampConstraint::normal(const double rotation) const
  {
    const double c = std::cos(rotation), s = std::sin(rotation);
    PlaneVector  result;
    result[0] = -(s * rest[0] + c * rest[1]) / length;
    result[1] = (c * rest[0] - s * rest[1]) / length;
    return result;
  }

  namespace
  {
    const Text     struts          = {"Struts",
                                      "",
                                      "Set of rigid struts; alternative to Joints."};
    const Text     joints          = {"Joints",
                                      "",
                                      "Set of joints of one rigid part without struts; "
                                                   "alternative to Struts."};
    const Choice   parts           = {"Parts",
                                      "struts that meet",
                                      {"struts that meet", "single struts"},
                                      "One part per group of connected rigid struts, or "
                                                  "per strut (bars hinged at both ends)."};
    const Quantity rigid_part_mass = {
      "Mass",
      "0 kg",
      "kg",
      Range::non_negative(),
      "Mass of each part, uniform along its struts; without struts, equal "
      "at all joints."};
    const QuantityList rotary_inertia = {
      "Rotary inertia",
      "auto",
      "kg m2",
      Range::non_negative(),
      1,
      3,
      "Moment of inertia of each part about its centre of mass: one number, in "
      "space for every axis, or three about x, y and z at rest (the plane uses "
      "the last); auto: from the mass distribution.",
      {"auto"}};
    const Choice elastic_struts = {
      "Elastic struts",
      "hinged",
      {"hinged", "clamped"},
      "Connection of elastic struts at the joints of the part."};

    void check_rotary_inertia(const ParameterValues      &values,
                              const dealii::Tensor<1, 3> &moments)
    {
      if (moments.norm() == 0)
        values.refuse(rotary_inertia,
                      "it must not be zero. Allowed: numbers > 0, "
                      "or auto: from the mass distribution");
      if (values.context.dimension == 2)
        return;
      for (unsigned int axis = 0; axis < 3; ++axis)
        {
          const double others =
            moments[(axis + 1) % 3] + moments[(axis + 2) % 3];
          // Flat parts reach equality up to the given digits.
          if (moments[axis] > others * (1 + 1e-6))
            values.refuse(rotary_inertia,
                          "no body has such moments, since none "
                          "is greater than the sum of the other "
                          "two. Correct them, or set auto");
        }
    }
  } // namespace

  SubsectionSchema rigid_parts_schema()
  {
    return {
      "Rigid parts",
      SubsectionSchema::Form::named_groups,
      "Struts or joints that move as rigid bodies, hinged to each other "
      "where they share a joint.",
      {struts, joints, parts, rigid_part_mass, rotary_inertia, elastic_struts}};
  }

  RigidPartDefinition read_rigid_part(ParameterValues &values)
  {
    RigidPartDefinition part;
    part.name          = values.name();
    part.path          = values.context.path;
    part.struts        = values[struts];
    part.joints        = values[joints];
    part.single_struts = values[parts] == "single struts";
    part.mass          = values[rigid_part_mass];
    part.clamps_struts = values[elastic_struts] == "clamped";
    if (!values.is_word(rotary_inertia))
      {
        part.rotary_inertia = moments_of_inertia_of(values, rotary_inertia);
        check_rotary_inertia(values, *part.rotary_inertia);
      }
    if (part.struts.empty() == part.joints.empty())
      values.refuse(part.struts.empty()
                      ? "give either Struts or Joints; none of them is given"
                      : "give either Struts or Joints; both are given");
    if (part.mass == 0 && part.rotary_inertia)
      values.refuse("Rotary inertia is given, but Mass = 0. "
                    "Give the part a mass");

    return part;
  }
} // namespace auxfem
