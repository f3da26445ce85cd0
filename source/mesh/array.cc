#include <auxfem/mesh/arc.h>
#include <auxfem/mesh/cell.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>

namespace auxfem
{
  namespace
  {
    using Index3 = std::array<unsigned int, 3>;

    /**
     * Two joints of different cells closer than this part of the cell's size
     * are one: far above round-off of the cell centres, far below any strut.
     */
    constexpr double joint_tolerance = 1e-8;

    /** Largest extent of the cell, its period included (m). */
    double cell_size(const UnitCell &cell)
    {
      double size = 0;
      for (unsigned int d = 0; d < 3; ++d)
        {
          double lowest  = cell.joints.front()[d];
          double highest = lowest;
          for (const auto &joint : cell.joints)
            {
              lowest  = std::min(lowest, joint[d]);
              highest = std::max(highest, joint[d]);
            }
          size = std::max({size, highest - lowest, cell.period[d]});
        }
      return size;
    }

    /** Finds joints by position, through buckets on a cubic grid. */
    class JointFinder
    {
    public:
      JointFinder(const double size)
        : tolerance(joint_tolerance * size)
        , width(size > 0. ? 1e-3 * size : 1.)
      {}

      /**
       * Index of a joint at @p position that is not in @p taken; invalid_index if
       * there is none.
       */
      unsigned int find(const std::vector<dealii::Point<3>> &joints,
                        const dealii::Point<3>              &position,
                        const std::vector<unsigned int>     &taken) const
      {
        const Key low  = key_of(position, -tolerance);
        const Key high = key_of(position, tolerance);
        for (auto x = low[0]; x <= high[0]; ++x)
          for (auto y = low[1]; y <= high[1]; ++y)
            for (auto z = low[2]; z <= high[2]; ++z)
              {
                const auto bucket = buckets.find(Key{{x, y, z}});
                if (bucket == buckets.end())
                  continue;
                for (const unsigned int index : bucket->second)
                  if (joints[index].distance(position) <= tolerance &&
                      std::find(taken.begin(), taken.end(), index) ==
                        taken.end())
                    return index;
              }
        return invalid_index;
      }

      void insert(const dealii::Point<3> &position, const unsigned int index)
      {
        buckets[key_of(position, 0.)].push_back(index);
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

      double                                                   tolerance;
      double                                                   width;
      std::unordered_map<Key, std::vector<unsigned int>, Hash> buckets;
    };

    void check_numbers_of_cells(const UnitCell &cell, const Index3 &n_cells)
    {
      for (unsigned int d = 0; d < 3; ++d)
        {
          const std::string direction(1, "xyz"[d]);
          if (n_cells[d] == 0)
            throw InputError("The number of cells along " + direction +
                             " is 0; at least 1 is needed.");
          if (n_cells[d] > 1 && !(cell.period[d] > 0.))
            throw InputError(
              "The lattice asks for " + std::to_string(n_cells[d]) +
              " cells along " + direction +
              ", but this cell cannot be repeated along " + direction + ". " +
              (cell.why_no_period[d].empty() ? std::string()
                                             : cell.why_no_period[d] + " ") +
              "Set the number of cells along " + direction + " to 1.");
        }
    }

    void sort_and_unite(std::vector<unsigned int> &indices)
    {
      std::sort(indices.begin(), indices.end());
      indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    }

    /** Makes the array cell by cell. */
    class ArrayBuilder
    {
    public:
      ArrayBuilder(const UnitCell &cell, const Index3 &n_cells)
        : cell(cell)
        , n_cells(n_cells)
        , tolerance(joint_tolerance * cell_size(cell))
        , finder(cell_size(cell))
      {
        lattice.n_cells = n_cells[0] * n_cells[1] * n_cells[2];
        lattice.joints.reserve(std::size_t(lattice.n_cells) *
                               cell.joints.size());
        lattice.struts.reserve(std::size_t(lattice.n_cells) *
                               cell.struts.size());
      }

      Lattice build()
      {
        create_empty_sets();
        Index3 at;
        for (at[2] = 0; at[2] < n_cells[2]; ++at[2])
          for (at[1] = 0; at[1] < n_cells[1]; ++at[1])
            for (at[0] = 0; at[0] < n_cells[0]; ++at[0])
              add_cell(at);
        add_struts_across();
        add_pairs_across();
        if (cell.ports.empty())
          add_faces_of_bounding_box();
        finish_sets();
        return std::move(lattice);
      }

    private:
      void create_empty_sets()
      {
        for (const auto &port : cell.ports)
          lattice.joint_sets[port.first];
        for (const auto &set : cell.joint_sets)
          lattice.joint_sets[set.first];
        for (const auto &set : cell.pairs)
          lattice.pair_sets[set.first];
        for (const auto &set : cell.pairs_across)
          lattice.pair_sets[set.first];
      }

      void add_cell(const Index3 &at)
      {
        number = at[0] + n_cells[0] * (at[1] + n_cells[1] * at[2]);
        add_joints(at);
        add_struts();
        add_pairs();
        for (const auto &[name, members] : cell.joint_sets)
          add_to_joint_set(name, members);
        for (const auto &[side, members] : cell.ports)
          if (is_on_boundary(side, at))
            add_to_joint_set(side, members);
      }

      void add_joints(const Index3 &at)
      {
        dealii::Tensor<1, 3> centre;
        for (unsigned int d = 0; d < 3; ++d)
          centre[d] = at[d] * cell.period[d];

        global.clear();
        for (const auto &joint : cell.joints)
          {
            const dealii::Point<3> position = joint + centre;
            unsigned int index = finder.find(lattice.joints, position, global);
            if (index == invalid_index)
              {
                index = lattice.joints.size();
                lattice.joints.push_back(position);
                finder.insert(position, index);
              }
            global.push_back(index);
          }
        global_of_cell.push_back(global);
      }

      void add_struts()
      {
        for (const auto &unit : cell.struts)
          {
            Strut strut;
            strut.joints  = {{global[unit.first], global[unit.second]}};
            strut.sagitta = unit.sagitta;
            strut.normal  = unit.normal;
            strut.cell    = number;
            add_strut(strut, unit.sets);
          }
      }

      void add_strut(const Strut &strut, const std::vector<std::string> &sets)
      {
        const unsigned int index = lattice.struts.size();
        const unsigned int known = find_strut(strut);
        if (known == invalid_index)
          strut_at.emplace(std::minmax(strut.joints[0], strut.joints[1]),
                           index);
        else if (lattice.struts[known].cell != strut.cell)
          return;
        for (const auto &set : sets)
          lattice.strut_sets[set].push_back(index);
        lattice.struts.push_back(strut);
      }

      /** The first strut with the same axis; invalid_index if there is none. */
      unsigned int find_strut(const Strut &strut) const
      {
        const auto known =
          strut_at.equal_range(std::minmax(strut.joints[0], strut.joints[1]));
        for (auto other = known.first; other != known.second; ++other)
          // Arcs that bulge to different sides are different struts.
          if ((rise(lattice.struts[other->second]) - rise(strut)).norm() <=
              tolerance)
            return other->second;
        return invalid_index;
      }

      dealii::Tensor<1, 3> rise(const Strut &strut) const
      {
        return rise_of_arc(lattice.joints[strut.joints[1]] -
                             lattice.joints[strut.joints[0]],
                           strut.sagitta,
                           strut.normal);
      }

      /** Needs all cells, as add_pairs_across(). */
      void add_struts_across()
      {
        for (const auto &[set, ends] : cell.struts_across)
          for (const JointPair &pair : pairs_of_neighbours(ends))
            {
              Strut strut;
              strut.joints = {{pair.first, pair.second}};
              strut.cell   = pair.cell;
              add_strut(strut, {set});
            }
      }

      void add_pairs()
      {
        for (const auto &[name, members] : cell.pairs)
          for (const auto &member : members)
            add_pair(name,
                     {global[member.first], global[member.second], number});
      }

      void add_pair(const std::string &name, const JointPair &pair)
      {
        const auto [low, high] = std::minmax(pair.first, pair.second);
        if (known_pairs[name].emplace(low, high).second)
          lattice.pair_sets[name].push_back(pair);
      }

      /** Needs all cells: the next one of a cell is made after it. */
      void add_pairs_across()
      {
        for (const auto &[name, members] : cell.pairs_across)
          for (const JointPair &pair : pairs_of_neighbours(members))
            add_pair(name, pair);
      }

      /** Those of @p members, cell by cell, whose joints are not one. */
      std::vector<JointPair>
      pairs_of_neighbours(const std::vector<NeighbourPair> &members) const
      {
        const Index3 stride = {{1, n_cells[0], n_cells[0] * n_cells[1]}};
        std::vector<JointPair> pairs;
        for (unsigned int c = 0; c < lattice.n_cells; ++c)
          for (const auto &member : members)
            {
              const unsigned int d = member.direction;
              if (c / stride[d] % n_cells[d] + 1 == n_cells[d])
                continue;
              const JointPair pair = {
                global_of_cell[c][member.first],
                global_of_cell[c + stride[d]][member.second],
                c};
              if (pair.first != pair.second)
                pairs.push_back(pair);
            }
        return pairs;
      }

      void add_to_joint_set(const std::string               &name,
                            const std::vector<unsigned int> &members)
      {
        auto &set = lattice.joint_sets[name];
        for (const unsigned int member : members)
          set.push_back(global[member]);
      }

      bool is_on_boundary(const std::string &side, const Index3 &at) const
      {
        return (side == "left" && at[0] == 0) ||
          (side == "right" && at[0] + 1 == n_cells[0]) ||
          (side == "bottom" && at[1] == 0) ||
          (side == "top" && at[1] + 1 == n_cells[1]) ||
          (side == "back" && at[2] == 0) ||
          (side == "front" && at[2] + 1 == n_cells[2]);
      }

      void add_faces_of_bounding_box()
      {
        const char *names[3][2] = {{"left", "right"},
                                   {"bottom", "top"},
                                   {"back", "front"}};
        for (unsigned int d = 0; d < 3; ++d)
          {
            const auto [lowest, highest] =
              std::minmax_element(lattice.joints.begin(),
                                  lattice.joints.end(),
                                  [d](const auto &a, const auto &b) {
                                    return a[d] < b[d];
                                  });
            const double low = (*lowest)[d], high = (*highest)[d];
            const bool   is_planar = (high - low <= tolerance);
            if (d == 2 && is_planar)
              continue;
            for (unsigned int i = 0; i < lattice.joints.size(); ++i)
              {
                if (lattice.joints[i][d] <= low + tolerance)
                  add_to_side(names[d][0], i);
                if (lattice.joints[i][d] >= high - tolerance)
                  add_to_side(names[d][1], i);
              }
          }
      }

      void add_to_side(const std::string &side, const unsigned int joint)
      {
        if (cell.joint_sets.count(side) == 0)
          lattice.joint_sets[side].push_back(joint);
      }

      void finish_sets()
      {
        for (unsigned int i = 0; i < lattice.joints.size(); ++i)
          lattice.joint_sets["all"].push_back(i);
        for (unsigned int i = 0; i < lattice.struts.size(); ++i)
          lattice.strut_sets["all"].push_back(i);
        for (auto &set : lattice.joint_sets)
          sort_and_unite(set.second);
        for (auto &set : lattice.strut_sets)
          sort_and_unite(set.second);
      }

      const UnitCell           &cell;
      const Index3             &n_cells;
      const double              tolerance; ///< for positions (m)
      JointFinder               finder;
      Lattice                   lattice;
      unsigned int              number = 0; ///< of the cell in work
      std::vector<unsigned int> global; ///< lattice joint of each cell joint
      std::vector<std::vector<unsigned int>> global_of_cell; ///< by number
      /** Struts by the lower and the higher number of their joints. */
      std::multimap<std::pair<unsigned int, unsigned int>, unsigned int>
        strut_at;
      std::map<std::string, std::set<std::pair<unsigned int, unsigned int>>>
        known_pairs;
    };
  } // namespace

  Lattice make_array(const UnitCell &cell, const Index3 &n_cells)
  {
    Assert(!cell.joints.empty(), dealii::ExcMessage("A cell has joints."));
    check_numbers_of_cells(cell, n_cells);
    return ArrayBuilder(cell, n_cells).build();
  }
} // namespace auxfem
