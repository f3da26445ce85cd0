#include <auxfem/mesh/arc.h>
#include <auxfem/mesh/earlier_joints.h>
#include <auxfem/mesh/merge_joints.h>
#include <auxfem/mesh/position_text.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/short_lines.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using Indices = std::vector<unsigned int>;

    /** The first of some items, and how many more there are. */
    std::string first_of(const std::vector<std::string> &items)
    {
      std::string text;
      for (std::size_t i = 0; i < std::min(n_listed, items.size()); ++i)
        text += (i > 0 ? "; " : "") + items[i];
      return items.size() <= n_listed
        ? text
        : text + "; and " + std::to_string(items.size() - n_listed) + " more";
    }

    /** For each joint the first one within @p distance, itself if none. */
    Indices first_joints_within(const double                         distance,
                                const std::vector<dealii::Point<3>> &joints)
    {
      namespace index = boost::geometry::index;
      const auto tree = dealii::pack_rtree_of_indices(joints);
      Indices    first(joints.size());
      for (unsigned int j = 0; j < joints.size(); ++j)
        {
          first[j]             = j;
          dealii::Point<3> low = joints[j], high = joints[j];
          for (unsigned int d = 0; d < 3; ++d)
            {
              low[d] -= distance;
              high[d] += distance;
            }
          const dealii::BoundingBox<3> box({low, high});
          for (auto other = tree.qbegin(index::intersects(box));
               other != tree.qend();
               ++other)
            // Only earlier joints that stay can take this one.
            if (*other < first[j] && first[*other] == *other &&
                joints[j].distance(joints[*other]) <= distance)
              first[j] = *other;
        }
      return first;
    }

    /** One merger of one cell. */
    class JointMerger
    {
    public:
      JointMerger(const double distance, const CellNames &names, UnitCell &cell)
        : distance(distance)
        , names(names)
        , cell(cell)
      {}

      void merge(const Indices &first)
      {
        renumber_joints(first);
        renumber_struts();
        for (auto &[name, members] : cell.joint_sets)
          renumber(members);
      }

    private:
      void renumber_joints(const Indices &first)
      {
        std::vector<dealii::Point<3>> kept;
        for (unsigned int j = 0; j < first.size(); ++j)
          {
            if (first[j] == j)
              {
                new_joint.push_back(kept.size());
                kept.push_back(cell.joints[j]);
              }
            else
              new_joint.push_back(new_joint[first[j]]);
          }
        cell.joints = kept;
      }

      void renumber_struts()
      {
        std::vector<UnitStrut>   kept;
        std::vector<std::string> without_length, repeated;
        for (unsigned int s = 0; s < cell.struts.size(); ++s)
          {
            UnitStrut strut = cell.struts[s];
            strut.first     = new_joint[strut.first];
            strut.second    = new_joint[strut.second];
            if (strut.first == strut.second)
              without_length.push_back(names.strut(s));
            else if (!joins_earlier(strut, kept))
              kept.push_back(strut);
            else
              repeated.push_back(names.strut(s));
          }
        cell.struts = kept;
        add_note("have no length after the merger and are left out",
                 without_length);
        add_note("repeat another strut after the merger and are one with it",
                 repeated);
      }

      void add_note(const std::string              &what,
                    const std::vector<std::string> &struts)
      {
        if (!struts.empty())
          cell.notes.push_back("Struts that " + what + ": " + first_of(struts) +
                               ".");
      }

      dealii::Tensor<1, 3> rise(const UnitStrut &strut) const
      {
        return rise_of_arc(cell.joints[strut.second] - cell.joints[strut.first],
                           strut.sagitta,
                           strut.normal);
      }

      /** Adds @p strut to the sets of an equal one of @p kept, if any. */
      bool joins_earlier(const UnitStrut &strut, std::vector<UnitStrut> &kept)
      {
        Indices &between =
          struts_of_joints[std::minmax(strut.first, strut.second)];
        for (const unsigned int other : between)
          if ((rise(kept[other]) - rise(strut)).norm() <= distance)
            {
              auto &sets = kept[other].sets;
              sets.insert(sets.end(), strut.sets.begin(), strut.sets.end());
              return true;
            }
        between.push_back(kept.size());
        return false;
      }

      void renumber(Indices &members) const
      {
        for (unsigned int &member : members)
          member = new_joint[member];
        std::sort(members.begin(), members.end());
        members.erase(std::unique(members.begin(), members.end()),
                      members.end());
      }

      const double                                             distance;
      const CellNames                                         &names;
      UnitCell                                                &cell;
      Indices                                                  new_joint;
      std::map<std::pair<unsigned int, unsigned int>, Indices> struts_of_joints;
    };
  } // namespace

  const Quantity &merge_distance()
  {
    static const Quantity parameter{
      "Merge distance",
      "0 m",
      "m",
      Range::non_negative(),
      "Joints nearer than this to one with a smaller number become one with it; "
      "struts without length or between the same joints then go. 0: none."};
    return parameter;
  }

  void merge_joints(const double       distance,
                    const CellNames   &names,
                    const unsigned int dimension,
                    UnitCell          &cell)
  {
    const Indices first =
      first_joints_within(distance > 0 ? distance : joint_tolerance(cell),
                          cell.joints);
    std::vector<std::string> pairs;
    for (unsigned int j = 0; j < first.size(); ++j)
      if (first[j] != j)
        pairs.push_back(names.joint(first[j]) + " and " + names.joint(j) +
                        " at " + position_text(cell.joints[j], dimension));
    if (pairs.empty())
      return;
    if (distance > 0)
      {
        cell.notes.push_back("Lattice/" + merge_distance().name +
                             " makes one: " + first_of(pairs) + ".");
        JointMerger(distance, names, cell).merge(first);
        if (cell.struts.empty())
          throw InputError("Lattice/" + merge_distance().name +
                           ": no strut is longer than this distance. Take "
                           "one below the length of the shortest strut.");
      }
    else
      cell.notes.push_back(
        "Joints lie at one place and are not connected by it: " +
        first_of(pairs) + ". If they are meant to be one, set Lattice/" +
        merge_distance().name + ", e.g. to a thousandth of a strut's length.");
  }
} // namespace auxfem
