#include <auxfem/mesh/lattice_reduction.h>
#include <auxfem/mesh/merge_joints.h>
#include <auxfem/mesh/strut_geometry.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Index3 = std::array<unsigned int, 3>;

    /** Numbers of struts or pairs by their two joints, in either order. */
    class LinkNumbers
    {
    public:
      /** A number between joints @p a and @p b that satisfies @p matches;
       * invalid_index if there is none. */
      template <class Matches>
      unsigned int find(const unsigned int a,
                        const unsigned int b,
                        const Matches     &matches) const
      {
        const auto [low, high] = std::minmax(a, b);
        if (low >= first.size())
          return invalid_index;
        for (unsigned int l = first[low]; l != invalid_index; l = links[l].next)
          if (links[l].high == high && matches(links[l].number))
            return links[l].number;
        return invalid_index;
      }

      void
      add(const unsigned int a, const unsigned int b, const unsigned int number)
      {
        const auto [low, high] = std::minmax(a, b);
        if (low >= first.size())
          first.resize(low + 1, invalid_index);
        links.push_back({high, number, first[low]});
        first[low] = links.size() - 1;
      }

    private:
      struct Link
      {
        unsigned int high;
        unsigned int number;
        unsigned int next; ///< next link of the same lower joint
      };

      std::vector<unsigned int> first; ///< first link, by lower joint
      std::vector<Link>         links;
    };

    void check_numbers_of_cells(const UnitCell &cell, const Index3 &n_cells)
    {
      for (unsigned int d = 0; d < 3; ++d)
        {
          const std::string direction(1, "xyz"[d]);
          if (n_cells[d] == 0)
            throw InputError("The number of cells along " + direction +
                             " is 0; at least 1 is needed.");
          if (n_cells[d] > 1 && !cell.repeats(d))
            throw InputError(
              "The lattice asks for " + std::to_string(n_cells[d]) +
              " cells along " + direction +
              ", but this cell cannot be repeated along " + direction + ". " +
              (cell.no_vector_reasons[d].empty()
                 ? std::string()
                 : cell.no_vector_reasons[d] + " ") +
              "Set the number of cells along " + direction + " to 1.");
        }
    }

    void sort_and_unite(std::vector<unsigned int> &indices)
    {
      // Most sets are sorted already, and may be long.
      if (!std::is_sorted(indices.begin(), indices.end()))
        std::sort(indices.begin(), indices.end());
      indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    }

    /** Builds the array cell by cell. */
    class ArrayBuilder
    {
    public:
      using Keeps = std::function<bool(const dealii::Point<3> &)>;

      ArrayBuilder(const UnitCell &cell,
                   const Index3   &n_cells,
                   const Keeps    &keeps)
        : cell(cell)
        , n_cells(n_cells)
        , keeps(keeps)
        , tolerance(joint_tolerance(cell))
        , earlier_joints(find_earlier_joints(cell, n_cells))
      {
        lattice.n_cells = n_cells[0] * n_cells[1] * n_cells[2];
        lattice.joints.reserve(std::size_t(lattice.n_cells) *
                               cell.joints.size());
        lattice.struts.reserve(std::size_t(lattice.n_cells) *
                               cell.struts.size());
      }

      Lattice build()
      {
        lattice.notes = cell.notes;
        create_sets();
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
        if (keeps)
          remove_joints_of_no_cell();
        return std::move(lattice);
      }

    private:
      /** Creates all sets, as some may stay empty. */
      void create_sets()
      {
        for (const auto &port : cell.ports)
          lattice.joint_sets[port.first];
        for (const auto &set : cell.joint_sets)
          lattice.joint_sets[set.first];
        for (const auto &set : cell.pairs)
          lattice.pair_sets[set.first];
        for (const auto &set : cell.pairs_across)
          lattice.pair_sets[set.first];
        for (const auto &strut : cell.struts)
          {
            sets_of_struts.emplace_back();
            for (const std::string &set : strut.sets)
              sets_of_struts.back().push_back(&lattice.strut_sets[set]);
          }
      }

      void add_cell(const Index3 &at)
      {
        number = number_of(at);
        add_joints(at);
        if (keeps)
          is_kept.push_back(keeps(middle_of_cell()));
        if (keeps && !is_kept.back())
          return;
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
        dealii::Tensor<1, 3> origin;
        for (unsigned int d = 0; d < 3; ++d)
          origin += at[d] * cell.vectors[d];

        global.clear();
        for (unsigned int j = 0; j < cell.joints.size(); ++j)
          {
            unsigned int index = joint_of_earlier_cell(j, at);
            if (index == invalid_index)
              {
                index = lattice.joints.size();
                lattice.joints.push_back(cell.joints[j] + origin);
              }
            global.push_back(index);
          }
        joints_of_cells.insert(joints_of_cells.end(),
                               global.begin(),
                               global.end());
      }

      /** The lattice joint of an earlier cell that joint @p j of the cell @p at
       * coincides with, unless another joint of this cell has it already;
       * otherwise invalid_index. */
      unsigned int joint_of_earlier_cell(const unsigned int j,
                                         const Index3      &at) const
      {
        unsigned int index = invalid_index;
        for (const EarlierJoint &earlier : earlier_joints[j])
          {
            // Negative indices wrap round and fail the test below.
            Index3 other = at;
            for (unsigned int d = 0; d < 3; ++d)
              other[d] += earlier.offset[d];
            if (other[0] >= n_cells[0] || other[1] >= n_cells[1] ||
                other[2] >= n_cells[2])
              continue;
            const unsigned int candidate =
              joint_of_cell(number_of(other), earlier.joint);
            if (std::find(global.begin(), global.end(), candidate) ==
                global.end())
              index = std::min(index, candidate);
          }
        return index;
      }

      /** Mean position of the joints of the current cell. */
      dealii::Point<3> middle_of_cell() const
      {
        dealii::Point<3> sum;
        for (const unsigned int joint : global)
          sum += lattice.joints[joint] / double(global.size());
        return sum;
      }

      void remove_joints_of_no_cell()
      {
        LatticeReduction reduction(lattice);
        reduction.keep_joint.assign(lattice.joints.size(), false);
        for (unsigned int c = 0; c < lattice.n_cells; ++c)
          for (unsigned int j = 0; is_kept[c] && j < cell.joints.size(); ++j)
            reduction.keep_joint[joint_of_cell(c, j)] = true;
        reduction.apply();
      }

      unsigned int number_of(const Index3 &at) const
      {
        return at[0] + n_cells[0] * (at[1] + n_cells[1] * at[2]);
      }

      unsigned int joint_of_cell(const unsigned int number,
                                 const unsigned int joint) const
      {
        return joints_of_cells[std::size_t(number) * cell.joints.size() +
                               joint];
      }

      void add_struts()
      {
        for (unsigned int u = 0; u < cell.struts.size(); ++u)
          {
            const auto &unit = cell.struts[u];
            Strut       strut;
            strut.joints  = {{global[unit.first], global[unit.second]}};
            strut.sagitta = unit.sagitta;
            strut.normal  = unit.normal;
            strut.cell    = number;
            add_strut(strut, sets_of_struts[u]);
          }
      }

      void add_strut(const Strut                                    &strut,
                     const std::vector<std::vector<unsigned int> *> &sets)
      {
        const auto &[a, b]       = strut.joints;
        const unsigned int index = lattice.struts.size();
        const unsigned int known =
          strut_numbers.find(a, b, [&](const unsigned int other) {
            // Arcs that bulge to different sides are different struts.
            return (rise(lattice.struts[other]) - rise(strut)).norm() <=
              tolerance;
          });
        if (known == invalid_index)
          strut_numbers.add(a, b, index);
        else if (lattice.struts[known].cell != strut.cell)
          return;
        for (auto *const set : sets)
          set->push_back(index);
        lattice.struts.push_back(strut);
      }

      dealii::Tensor<1, 3> rise(const Strut &strut) const
      {
        return rise_of_arc(lattice.joints[strut.joints[1]] -
                             lattice.joints[strut.joints[0]],
                           strut.sagitta,
                           strut.normal);
      }

      /** Needs all cells, because a cell's neighbours are made after it. */
      void add_struts_across()
      {
        for (const auto &[set, ends] : cell.struts_across)
          for (const JointPair &pair : pairs_of_neighbours(ends))
            {
              Strut strut;
              strut.joints = {{pair.first, pair.second}};
              strut.cell   = pair.cell;
              add_strut(strut, {&lattice.strut_sets[set]});
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
        LinkNumbers &numbers = pair_numbers[name];
        auto        &pairs   = lattice.pair_sets[name];
        const auto   any     = [](unsigned int) { return true; };
        if (numbers.find(pair.first, pair.second, any) != invalid_index)
          return;
        numbers.add(pair.first, pair.second, pairs.size());
        pairs.push_back(pair);
      }

      /** Needs all cells, as add_struts_across(). */
      void add_pairs_across()
      {
        for (const auto &[name, members] : cell.pairs_across)
          for (const JointPair &pair : pairs_of_neighbours(members))
            add_pair(name, pair);
      }

      /** Pairs of @p members in all cells, without those whose joints are
       * merged. */
      std::vector<JointPair>
      pairs_of_neighbours(const std::vector<NeighbourPair> &members) const
      {
        const Index3 stride = {{1, n_cells[0], n_cells[0] * n_cells[1]}};
        std::vector<JointPair> pairs;
        for (unsigned int c = 0; c < lattice.n_cells; ++c)
          for (const auto &member : members)
            {
              unsigned int neighbour = c;
              bool         exists    = true;
              for (unsigned int d = 0; d < 3; ++d)
                {
                  // Negative indices wrap round and are too large, too.
                  const unsigned int at =
                    c / stride[d] % n_cells[d] + member.shift[d];
                  exists = exists && at < n_cells[d];
                  neighbour += member.shift[d] * stride[d];
                }
              if (!exists || (keeps && !(is_kept[c] && is_kept[neighbour])))
                continue;
              const JointPair pair = {joint_of_cell(c, member.first),
                                      joint_of_cell(neighbour, member.second),
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
            const auto [low, high] = coordinate_range(lattice.joints, d);
            const bool is_planar   = (high - low <= tolerance);
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

      const UnitCell &cell;
      const Index3   &n_cells;
      const Keeps    &keeps;
      const double    tolerance; ///< for positions (m)
      const std::vector<std::vector<EarlierJoint>> earlier_joints; ///< by joint
      /** Sets of each strut of the cell. */
      std::vector<std::vector<std::vector<unsigned int> *>> sets_of_struts;
      Lattice                                               lattice;
      std::vector<bool>         is_kept;    ///< by cell, if some are not
      unsigned int              number = 0; ///< of the current cell
      std::vector<unsigned int> global; ///< lattice joint of each cell joint
      std::vector<unsigned int> joints_of_cells; ///< the same, of all cells
      LinkNumbers               strut_numbers;
      std::map<std::string, LinkNumbers> pair_numbers; ///< by pair set
    };
  } // namespace

  Lattice make_array(const UnitCell &cell,
                     const Index3   &n_cells,
                     const std::function<bool(const dealii::Point<3> &)> &keeps)
  {
    Assert(!cell.joints.empty(), dealii::ExcMessage("A cell has joints."));
    check_numbers_of_cells(cell, n_cells);
    return ArrayBuilder(cell, n_cells, keeps).build();
  }
} // namespace auxfem
