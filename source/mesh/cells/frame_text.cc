#include <auxfem/mesh/cells/frame_text.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/merge_joints.h>
#include <auxfem/mesh/strut_geometry.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/parameters/quantity.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const Text joints_entry{
      "Joints",
      "",
      "Positions `x y` of the joints, in m or with units (`0 0; 20 mm 0`), "
      "separated by semicolons; in space `x y z` or, for z = 0, `x y`. They are "
      "numbered from 0.",
      true};

    const Text struts_entry{
      "Struts",
      "",
      "Numbers of the two joints of each strut, separated by semicolons. A third "
      "number is the rise of a circular arc over its chord, in m or with a unit, "
      "positive to the left of the direction from the first to the second joint. "
      "In space the normal n of the arc's plane may follow, by default `0 0 1`; "
      "the arc rises along n x chord.",
      true};

  } // namespace

  std::vector<ListItem> split_items(const std::string &value,
                                    const std::string &entry,
                                    const std::string &noun,
                                    const std::string &path)
  {
    std::vector<ListItem> items;
    std::istringstream    list(value);
    for (std::string text; std::getline(list, text, ';');)
      {
        text = dealii::Utilities::trim(text);
        ListItem item;
        item.text  = text;
        item.where = path + "/" + entry + ": " + noun + " " +
          std::to_string(items.size()) + " (\"" + text + "\") ";
        item.words = split_quantity_list(text);
        items.push_back(item);
      }
    return items;
  }

  unsigned int read_joint_number(const std::string &word,
                                 const ListItem    &item,
                                 const std::size_t  n_joints)
  {
    const auto index = read_index(word);
    if (!index)
      throw InputError(item.where + "has \"" + word +
                       "\" where the number of a joint is needed.");
    if (*index >= n_joints)
      throw InputError(
        item.where + "names joint " + word +
        ", which does not exist. There are " + std::to_string(n_joints) +
        " joints, numbered from 0 to " + std::to_string(n_joints - 1) + ".");
    return *index;
  }

  namespace
  {
    /** @param meaning of the number for the message, e.g. `number in m` */
    double read_number(const std::string &word,
                       const std::string &unit,
                       const ListItem    &item,
                       const std::string &meaning)
    {
      try
        {
          return parse_quantity(word, unit);
        }
      catch (const InputError &error)
        {
          throw InputError(item.where + "has \"" + word + "\" where a " +
                           meaning + " is needed: " + error.what() + ".");
        }
    }

    double read_metres(const std::string &word, const ListItem &item)
    {
      return read_number(word, "m", item, "number in m, or one with a unit,");
    }

    [[noreturn]] void refuse_coordinates(const ListItem    &item,
                                         const unsigned int dimension)
    {
      throw InputError(
        item.where + "has " + std::to_string(item.words.size()) +
        (dimension == 3
           ? " numbers instead of the coordinates x y z, or x y for z = 0. "
             "Separate joints by semicolons: \"0 0 0; 1 0 0; 1 1 0.5\"."
           : " numbers instead of the two coordinates x y. "
             "Separate joints by semicolons: \"0 0; 1 0; 1 1\"."));
    }

    dealii::Point<3> position_of_joint(const ListItem    &item,
                                       const unsigned int dimension)
    {
      std::vector<double> coordinates;
      for (const std::string &word : item.words)
        coordinates.push_back(read_metres(word, item));
      if (coordinates.size() != 2 && coordinates.size() != 3)
        refuse_coordinates(item, dimension);
      dealii::Point<3> joint;
      for (unsigned int d = 0; d < coordinates.size(); ++d)
        joint[d] = coordinates[d];
      if (dimension == 2 && joint[2] != 0.)
        throw InputError(item.where + "has the third coordinate " +
                         item.words[2] +
                         ", but the scene lies in the plane z = 0. Remove that "
                         "coordinate, or set Dimension = 3 at the top of the "
                         "file.");
      return joint;
    }

    std::vector<dealii::Point<3>> read_joints(const std::string  &value,
                                              const SceneContext &context)
    {
      std::vector<dealii::Point<3>> joints;
      for (const ListItem &item :
           split_items(value, joints_entry.name, "joint", context.path))
        joints.push_back(position_of_joint(item, context.dimension));
      return joints;
    }

    dealii::Tensor<1, 3> chord_of(const UnitStrut &strut, const UnitCell &cell)
    {
      return cell.joints[strut.second] - cell.joints[strut.first];
    }

    void check_normal(const UnitStrut            &strut,
                      const dealii::Tensor<1, 3> &chord,
                      const ListItem             &item)
    {
      const bool is_parallel =
        dealii::cross_product_3d(strut.normal, chord).norm() <=
        sqrt_round_off * chord.norm();
      if (strut.sagitta != 0. && is_parallel)
        throw InputError(
          item.where +
          (item.words.size() == 3
             ? "is an arc whose chord is parallel to z, so it does not say "
               "in which plane it lies. Add the normal of that plane, for "
               "example \"0 1 0.25 0 1 0\"."
             : "is an arc whose chord is parallel to the normal of its "
               "plane. Give a normal perpendicular to the chord."));
    }

    /** Strut numbers by their joints, the lower one first. */
    using StrutsByJoints =
      std::map<std::pair<unsigned int, unsigned int>, std::vector<std::size_t>>;

    std::pair<unsigned int, unsigned int> joints_of(const UnitStrut &strut)
    {
      return std::minmax(strut.first, strut.second);
    }

    /** Whether two struts between the same joints have the same axis. */
    bool are_equal(const UnitStrut            &strut,
                   const dealii::Tensor<1, 3> &chord,
                   const UnitStrut            &other,
                   const UnitCell             &cell)
    {
      const dealii::Tensor<1, 3> difference =
        rise_of_arc(chord, strut.sagitta, strut.normal) -
        rise_of_arc(chord_of(other, cell), other.sagitta, other.normal);
      return difference.norm() <= sqrt_round_off * chord.norm();
    }

    /** @param merged length below which merge_joints() removes a strut */
    void check_strut(const double          merged,
                     const UnitStrut      &strut,
                     const UnitCell       &cell,
                     const StrutsByJoints &known_struts,
                     const ListItem       &item)
    {
      const dealii::Tensor<1, 3> chord = chord_of(strut, cell);
      if (strut.sagitta == 0. && chord.norm() < merged)
        return;
      if (chord.norm() == 0.)
        throw InputError(item.where +
                         "has zero length: its two joints lie at the same "
                         "position. Make a ring of two or more arcs.");
      check_normal(strut, chord, item);

      const auto same_joints = known_struts.find(joints_of(strut));
      if (same_joints == known_struts.end())
        return;
      for (const std::size_t other : same_joints->second)
        if (are_equal(strut, chord, cell.struts[other], cell))
          throw InputError(item.where + "repeats strut " +
                           std::to_string(other) + ". Remove one of them.");
    }

    [[noreturn]] void refuse_strut(const ListItem    &item,
                                   const unsigned int dimension)
    {
      throw InputError(
        item.where + "has " + std::to_string(item.words.size()) +
        " numbers instead of two joint numbers and, for an arc, its rise" +
        (dimension == 3
           ? ", after which the three numbers of its plane's normal may follow"
           : "") +
        ". Separate struts by semicolons: \"0 1; 1 2 0.25" +
        (dimension == 3 ? "; 2 3 0.25 0 1 0\"." : "\"."));
    }

    /** Reads the numbers from the fourth on, the components of the normal. */
    std::vector<double> read_components(const ListItem &item)
    {
      std::vector<double> components;
      for (std::size_t i = 3; i < item.words.size(); ++i)
        components.push_back(read_number(item.words[i],
                                         "1",
                                         item,
                                         "number, a component of the normal,"));
      return components;
    }

    dealii::Tensor<1, 3> normal_of(const std::vector<double> &components,
                                   const ListItem            &item)
    {
      dealii::Tensor<1, 3> normal;
      for (unsigned int d = 0; d < 3; ++d)
        normal[d] = components[d];
      if (normal.norm() == 0.)
        throw InputError(item.where +
                         "has the normal 0 0 0, which is no direction. Give "
                         "a vector perpendicular to the plane of the arc, of "
                         "any length.");
      return normal / normal.norm();
    }

    UnitStrut read_strut(const ListItem    &item,
                         const std::size_t  n_joints,
                         const unsigned int dimension)
    {
      const std::size_t         n          = item.words.size();
      const bool                has_normal = (n == 6);
      const std::vector<double> components = read_components(item);
      if (n != 2 && n != 3 && !(has_normal && dimension == 3))
        refuse_strut(item, dimension);
      UnitStrut strut;
      strut.first  = read_joint_number(item.words[0], item, n_joints);
      strut.second = read_joint_number(item.words[1], item, n_joints);
      if (n > 2)
        strut.sagitta = read_metres(item.words[2], item);
      if (has_normal)
        strut.normal = normal_of(components, item);
      return strut;
    }

    void read_struts(const double        merged,
                     const std::string  &value,
                     const SceneContext &context,
                     UnitCell           &cell)
    {
      StrutsByJoints known_struts;
      for (const ListItem &item :
           split_items(value, struts_entry.name, "strut", context.path))
        {
          const UnitStrut strut =
            read_strut(item, cell.joints.size(), context.dimension);
          check_strut(merged, strut, cell, known_struts, item);
          known_struts[joints_of(strut)].push_back(cell.struts.size());
          cell.struts.push_back(strut);
        }
    }
  } // namespace

  Parameters frame_parameters()
  {
    return {joints_entry, struts_entry, merge_distance()};
  }

  UnitCell read_frame(const ParameterValues &values, const std::string &noun)
  {
    UnitCell cell;
    cell.joints = read_joints(values[joints_entry], values.context);
    if (cell.joints.size() < 2)
      throw InputError(values.context.path + "/" + joints_entry.name + ": a " +
                       noun +
                       " needs at least two joints, for example "
                       "\"0 0; 1 0\".");
    const double distance = values[merge_distance()];
    read_struts(distance, values[struts_entry], values.context, cell);
    if (cell.struts.empty())
      throw InputError(values.context.path + "/" + struts_entry.name + ": a " +
                       noun +
                       " needs at least one strut, for example "
                       "\"0 1\".");
    return cell;
  }

  void merge_joints_of_frame(const ParameterValues &values, UnitCell &cell)
  {
    merge_joints(values[merge_distance()],
                 {[](const unsigned int joint) {
                    return "joint " + std::to_string(joint);
                  },
                  [](const unsigned int strut) {
                    return "strut " + std::to_string(strut);
                  }},
                 values.context.dimension,
                 cell);
  }
} // namespace auxfem
