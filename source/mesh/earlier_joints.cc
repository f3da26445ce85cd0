#include <auxfem/mesh/earlier_joints.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
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
        std::vector<unsigned int> found;
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
                    found.push_back(joint);
              }
        return found;
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
      size = std::max({size, cell_extent(cell, d), cell.period[d]});
    return 1e-8 * size;
  }

  std::vector<std::vector<EarlierJoint>>
  find_earlier_joints(const UnitCell                    &cell,
                      const std::array<unsigned int, 3> &n_cells)
  {
    const JointFinder  finder(cell);
    std::array<int, 3> reach = {{0, 0, 0}};
    for (unsigned int d = 0; d < 3; ++d)
      if (n_cells[d] > 1)
        reach[d] =
          std::min<int>(n_cells[d] - 1,
                        (cell_extent(cell, d) + joint_tolerance(cell)) /
                          cell.period[d]);

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
              shift[d] = offset[d] * cell.period[d];
            for (unsigned int joint = 0; joint < cell.joints.size(); ++joint)
              for (const unsigned int other :
                   finder.find(cell.joints[joint] - shift))
                earlier[joint].push_back({offset, other});
          }
    return earlier;
  }
} // namespace auxfem
