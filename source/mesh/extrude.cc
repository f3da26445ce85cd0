#include <auxfem/mesh/cell.h>
#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <numeric>

namespace auxfem
{
  namespace
  {
    using Indices = std::vector<unsigned int>;

    bool is_planar(const UnitCell &cell)
    {
      // z = 0 is set, not computed, in planar cells.
      const bool joints_are =
        std::all_of(cell.joints.begin(), cell.joints.end(), [](const auto &p) {
          return p[2] == 0.;
        });
      const dealii::Tensor<1, 3> z = dealii::Point<3>(0, 0, 1);
      return joints_are && !cell.repeats(2) &&
        std::all_of(cell.struts.begin(),
                    cell.struts.end(),
                    [&z](const auto &s) {
                      return s.sagitta == 0. || s.normal == z;
                    });
    }

    Indices all_joints(const UnitCell &cell)
    {
      Indices joints(cell.joints.size());
      std::iota(joints.begin(), joints.end(), 0u);
      return joints;
    }

    /** Joints by their set names in the parameter file. */
    std::map<std::string, Indices> named_joints(const UnitCell &cell)
    {
      std::map<std::string, Indices> sets = cell.joint_sets;
      sets.insert(cell.ports.begin(), cell.ports.end());
      sets["all"] = all_joints(cell);
      return sets;
    }

    [[noreturn]] void refuse_name(const std::string                    &name,
                                  const std::map<std::string, Indices> &sets,
                                  const std::string                    &path)
    {
      std::vector<std::string> known;
      std::string              list;
      for (const auto &set : sets)
        {
          known.push_back(set.first);
          list += (list.empty() ? "\"" : ", \"") + set.first + "\"";
        }
      throw InputError(path +
                       "/Interlayer joints: the cell has no set of joints "
                       "named \"" +
                       name + "\"" + did_you_mean(name, known) + "\nAllowed: " +
                       list + ", several joined by + or commas.");
    }

    Indices select(const UnitCell    &cell,
                   const std::string &names,
                   const std::string &path)
    {
      const auto  sets = named_joints(cell);
      Indices     selected;
      std::string joined = names;
      std::replace(joined.begin(), joined.end(), ',', '+');
      for (const auto &name : dealii::Utilities::split_string_list(joined, '+'))
        {
          const auto set = sets.find(name);
          if (set == sets.end())
            refuse_name(name, sets, path);
          selected.insert(selected.end(),
                          set->second.begin(),
                          set->second.end());
        }
      std::sort(selected.begin(), selected.end());
      selected.erase(std::unique(selected.begin(), selected.end()),
                     selected.end());
      return selected;
    }
  } // namespace

  UnitCell extrude(UnitCell           cell,
                   const double       distance,
                   const std::string &columns,
                   const std::string &path)
  {
    if (!is_planar(cell))
      throw InputError(path +
                       "/Layer distance: only planar cells can be stacked in "
                       "layers, but this cell extends along z. Remove Layer "
                       "distance.");
    StrutsAcross across;
    across.set = "columns";
    for (const unsigned int joint : select(cell, columns, path))
      across.ends.push_back({joint, joint, {{0, 0, 1}}});
    if (across.ends.empty())
      throw InputError(path + "/Interlayer joints: \"" + columns +
                       "\" names no joints. Name the joints that columns "
                       "connect.");
    cell.struts_across.push_back(across);
    cell.vectors[2][2] = distance;
    // Without ports the sides come from the bounding box.
    if (!cell.ports.empty())
      cell.ports["back"] = cell.ports["front"] = all_joints(cell);
    return cell;
  }
} // namespace auxfem
