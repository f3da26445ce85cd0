#include <auxfem/mesh/merge_joints.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/strut_geometry.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/text.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>
#include <tuple>
#include <unordered_map>

namespace auxfem
{
  namespace
  {
    double cell_extent(const UnitCell &cell, const unsigned int d)
    {
      const auto [low, high] = coordinate_range(cell.joints, d);
      return high - low;
    }

    /** Finds joints of a cell by position, through buckets on a cubic grid. */
    class JointFinder
    {
    public:
      JointFinder(const UnitCell &cell)
        : joints(cell.joints)
        , tolerance(joint_tolerance(cell))
        , width(tolerance > 0. ? 1e5 * tolerance : 1.)
      {
        for (unsigned int joint = 0; joint < joints.size(); ++joint)
          buckets[key_of(joints[joint], 0.)].push_back(joint);
      }

      /** Indices of all joints at @p position. */
      std::vector<unsigned int> find(const dealii::Point<3> &position) const
      {
        std::vector<unsigned int> matches;
        const Key                 low  = key_of(position, -tolerance);
        const Key                 high = key_of(position, tolerance);
        for (auto x = low[0]; x <= high[0]; ++x)
          for (auto y = low[1]; y <= high[1]; ++y)
            for (auto z = low[2]; z <= high[2]; ++z)
              {
                const auto bucket = buckets.find(Key{{x, y, z}});
                if (bucket == buckets.end())
                  continue;
                for (const unsigned int joint : bucket->second)
                  if (joints[joint].distance(position) <= tolerance)
                    matches.push_back(joint);
              }
        return matches;
      }

    private:
      using Key = std::array<std::int64_t, 3>;

      struct Hash
      {
        std::size_t operator()(const Key &key) const
        {
          std::size_t hash = 0;
          for (const auto part : key)
            hash = hash * 1000003u ^ std::hash<std::int64_t>()(part);
          return hash;
        }
      };

      Key key_of(const dealii::Point<3> &position, const double shift) const
      {
        Key key;
        for (unsigned int d = 0; d < 3; ++d)
          key[d] = static_cast<std::int64_t>(
            std::floor((position[d] + shift) / width));
        return key;
      }

      const std::vector<dealii::Point<3>>                     &joints;
      double                                                   tolerance;
      double                                                   width;
      std::unordered_map<Key, std::vector<unsigned int>, Hash> buckets;
    };
  } // namespace

  std::pair<double, double>
  coordinate_range(const std::vector<dealii::Point<3>> &joints,
                   const unsigned int                   d)
  {
    const auto [low, high] =
      std::minmax_element(joints.begin(),
                          joints.end(),
                          [d](const auto &a, const auto &b) {
                            return a[d] < b[d];
                          });
    return {(*low)[d], (*high)[d]};
  }

  double joint_tolerance(const UnitCell &cell)
  {
    double size = 0;
    for (unsigned int d = 0; d < 3; ++d)
      size = std::max({size, cell_extent(cell, d), cell.vectors[d].norm()});
    return std::max(1e-8 * size, cell.merge_distance);
  }

  namespace
  {
    /** Vectors whose products with a position are its coordinates along those
     * of the cell; 0 in directions without. */
    std::array<dealii::Tensor<1, 3>, 3> dual_vectors(const UnitCell &cell)
    {
      dealii::Tensor<2, 3> products;
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int e = 0; e < 3; ++e)
          products[d][e] = cell.repeats(d) && cell.repeats(e)
            ? cell.vectors[d] * cell.vectors[e]
            : double(d == e);
      const dealii::Tensor<2, 3>          inverse = invert(products);
      std::array<dealii::Tensor<1, 3>, 3> dual;
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int e = 0; e < 3; ++e)
          dual[d] += inverse[d][e] * cell.vectors[e];
      return dual;
    }

    /** Largest difference of cell numbers in direction @p d at which joints can
     * coincide. */
    int reach_of_cell(const UnitCell &cell, const dealii::Tensor<1, 3> &dual)
    {
      const auto [low, high] =
        std::minmax_element(cell.joints.begin(),
                            cell.joints.end(),
                            [&](const auto &a, const auto &b) {
                              return dual * a < dual * b;
                            });
      return dual * (*high - *low) + joint_tolerance(cell) * dual.norm();
    }
  } // namespace

  std::vector<std::vector<EarlierJoint>>
  find_earlier_joints(const UnitCell                    &cell,
                      const std::array<unsigned int, 3> &n_cells)
  {
    const JointFinder  finder(cell);
    const auto         dual  = dual_vectors(cell);
    std::array<int, 3> reach = {{0, 0, 0}};
    for (unsigned int d = 0; d < 3; ++d)
      if (n_cells[d] > 1)
        reach[d] = std::min<int>(n_cells[d] - 1, reach_of_cell(cell, dual[d]));

    std::vector<std::vector<EarlierJoint>> earlier(cell.joints.size());
    std::array<int, 3>                     offset;
    for (offset[2] = -reach[2]; offset[2] <= 0; ++offset[2])
      for (offset[1] = -reach[1]; offset[1] <= reach[1]; ++offset[1])
        for (offset[0] = -reach[0]; offset[0] <= reach[0]; ++offset[0])
          {
            if (std::make_tuple(offset[2], offset[1], offset[0]) >=
                std::make_tuple(0, 0, 0))
              continue;
            dealii::Tensor<1, 3> shift;
            for (unsigned int d = 0; d < 3; ++d)
              shift += offset[d] * cell.vectors[d];
            for (unsigned int joint = 0; joint < cell.joints.size(); ++joint)
              for (const unsigned int other :
                   finder.find(cell.joints[joint] - shift))
                earlier[joint].push_back({offset, other});
          }
    return earlier;
  }

  std::vector<unsigned int>
  first_joints_within(const double                         distance,
                      const std::vector<dealii::Point<3>> &joints)
  {
    namespace index                = boost::geometry::index;
    const auto                tree = dealii::pack_rtree_of_indices(joints);
    std::vector<unsigned int> first(joints.size());
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
          // A joint cannot be merged with one that is itself merged.
          if (*other < first[j] && first[*other] == *other &&
              joints[j].distance(joints[*other]) <= distance)
            first[j] = *other;
      }
    return first;
  }

  namespace
  {
    using Indices = std::vector<unsigned int>;

    /** Lists the first items and the number of the others. */
    std::string shortened_list(const std::vector<std::string> &items)
    {
      std::string text;
      for (std::size_t i = 0; i < std::min(max_listed_items, items.size()); ++i)
        text += (i > 0 ? "; " : "") + items[i];
      return items.size() <= max_listed_items ? text
                                              : text + "; and " +
          std::to_string(items.size() - max_listed_items) + " more";
    }

    /** Merges joints of one cell. */
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
        std::vector<dealii::Point<3>> remaining;
        for (unsigned int j = 0; j < first.size(); ++j)
          {
            if (first[j] == j)
              {
                new_joint.push_back(remaining.size());
                remaining.push_back(cell.joints[j]);
              }
            else
              new_joint.push_back(new_joint[first[j]]);
          }
        cell.joints = remaining;
      }

      void renumber_struts()
      {
        std::vector<UnitStrut>   remaining;
        std::vector<std::string> without_length, repeated;
        for (unsigned int s = 0; s < cell.struts.size(); ++s)
          {
            UnitStrut strut = cell.struts[s];
            strut.first     = new_joint[strut.first];
            strut.second    = new_joint[strut.second];
            if (strut.first == strut.second)
              without_length.push_back(names.strut(s));
            else if (!unite_with_equal(strut, remaining))
              remaining.push_back(strut);
            else
              repeated.push_back(names.strut(s));
          }
        cell.struts = remaining;
        add_note("Struts without length after the merger are removed",
                 without_length);
        add_note("Struts that repeat another one after the merger are united "
                 "with it",
                 repeated);
      }

      void add_note(const std::string              &event,
                    const std::vector<std::string> &struts)
      {
        if (!struts.empty())
          cell.notes.push_back(event + ": " + shortened_list(struts) + ".");
      }

      dealii::Tensor<1, 3> rise(const UnitStrut &strut) const
      {
        return rise_of_arc(cell.joints[strut.second] - cell.joints[strut.first],
                           strut.sagitta,
                           strut.normal);
      }

      /** Adds the sets of @p strut to those of an equal strut among
       * @p remaining; false if there is none. */
      bool unite_with_equal(const UnitStrut        &strut,
                            std::vector<UnitStrut> &remaining)
      {
        Indices &candidates =
          struts_of_joints[std::minmax(strut.first, strut.second)];
        for (const unsigned int other : candidates)
          if ((rise(remaining[other]) - rise(strut)).norm() <= distance)
            {
              auto &sets = remaining[other].sets;
              sets.insert(sets.end(), strut.sets.begin(), strut.sets.end());
              return true;
            }
        candidates.push_back(remaining.size());
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
      "Each joint is merged with the first one nearer than this; struts without "
      "length are then removed, repeated struts united. 0: no joints."};
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
                             " merges joints: " + shortened_list(pairs) + ".");
        JointMerger(distance, names, cell).merge(first);
        if (cell.struts.empty())
          throw InputError(
            "Lattice/" + merge_distance().name +
            ": no strut is longer than this distance. Give "
            "a distance below the length of the shortest strut.");
      }
    else
      cell.notes.push_back(
        "Joints lie at the same place but are not connected: " +
        shortened_list(pairs) + ". To merge them, set Lattice/" +
        merge_distance().name + ", e.g. to a thousandth of a strut's length.");
  }
} // namespace auxfem
