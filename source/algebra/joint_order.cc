#include <auxfem/algebra/joint_order.h>

#include <algorithm>
#include <unordered_map>

namespace auxfem
{
  namespace
  {
    constexpr unsigned int first_rotation = 3;

    /**
     * Component @p moved of the motion at @p arm due to a unit motion of
     * component @p body_component of a rigid body.
     */
    double motion(const unsigned int          body_component,
                  const unsigned int          moved,
                  const dealii::Tensor<1, 3> &arm)
    {
      if (body_component == moved)
        return 1.;
      if (body_component < first_rotation || moved >= first_rotation)
        return 0.;
      dealii::Tensor<1, 3> axis;
      axis[body_component - first_rotation] = 1.;
      return dealii::cross_product_3d(axis, arm)[moved];
    }
  } // namespace

  JointRows::JointRows(const Unknowns &all, const std::vector<int> &selected)
    : unknowns(all)
    , rows(all.kinds.size())
  {
    std::unordered_map<unsigned int, std::vector<unsigned int>> blocks;
    for (const int unknown : selected)
      add(unknown, blocks[unknowns.joint[unknown]]);
    share();
  }

  void JointRows::add(const unsigned int         unknown,
                      std::vector<unsigned int> &blocks)
  {
    const std::vector<unsigned int> &components = unknowns.components;
    const unsigned int               number     = std::find(components.begin(),
                                          components.end(),
                                          unknowns.component[unknown]) -
      components.begin();
    auto block =
      std::find_if(blocks.begin(), blocks.end(), [&](const unsigned int b) {
        return !unknown_of_row[b * block_size() + number];
      });
    if (block == blocks.end())
      {
        block = blocks.insert(block, joint_of_block.size());
        joint_of_block.push_back(unknowns.joint[unknown]);
        unknown_of_row.resize(unknown_of_row.size() + block_size());
      }
    rows[unknown]                  = *block * block_size() + number;
    unknown_of_row[*rows[unknown]] = unknown;
  }

  void JointRows::share()
  {
    const UnknownLayout &unknown_layout = unknowns.layout;
    const UnknownLayout  owned(unknown_layout.communicator(),
                              unknown_of_row.size(),
                              {});
    std::vector<std::optional<unsigned int>> numbers = rows;
    for (std::optional<unsigned int> &number : numbers)
      if (number)
        number = owned.global(*number);
    unknown_layout.update_ghosts(numbers);
    std::vector<int> ghosts;
    for (unsigned int i = unknown_layout.n_owned();
         i < unknown_layout.n_local();
         ++i)
      if (numbers[i])
        {
          rows[i] = unknown_of_row.size() + ghosts.size();
          ghosts.push_back(*numbers[i]);
        }
    row_layout = std::make_unique<UnknownLayout>(unknown_layout.communicator(),
                                                 unknown_of_row.size(),
                                                 ghosts);
  }

  unsigned int JointRows::block_size() const
  {
    return unknowns.components.size();
  }

  std::vector<std::vector<double>> JointRows::rigid_body_modes() const
  {
    const std::vector<dealii::Point<3>> &joints = *unknowns.positions;
    dealii::Point<3>                     middle;
    for (const dealii::Point<3> &joint : joints)
      middle += joint / static_cast<double>(joints.size());

    const std::vector<unsigned int> &components = unknowns.components;
    std::vector<std::vector<double>> modes(
      block_size(),
      std::vector<double>(unknown_of_row.size(), 0.));
    for (unsigned int row = 0; row < unknown_of_row.size(); ++row)
      {
        if (!unknown_of_row[row])
          continue;
        if (unknowns.kinds[*unknown_of_row[row]] == UnknownKind::prescribed)
          continue;
        const dealii::Tensor<1, 3> arm =
          (joints[joint_of_block[row / block_size()]] - middle) /
          unknowns.length;
        for (unsigned int mode = 0; mode < block_size(); ++mode)
          modes[mode][row] =
            motion(components[mode], components[row % block_size()], arm);
      }
    return modes;
  }

  namespace
  {
    using Link  = JointOrder::Link;
    using Links = std::vector<Link>;

    template <typename SomeLinks>
    auto find_link(SomeLinks &links, const unsigned int group)
    {
      return std::lower_bound(links.begin(),
                              links.end(),
                              group,
                              [](const Link &link, const unsigned int sought) {
                                return link.group < sought;
                              });
    }

    /**
     * Groups by number of neighbours; among equals the last changed one comes
     * first. Elimination then spreads from its front and leaves stout members,
     * which keeps iterations few; first-in-first-out left chains.
     */
    class Queue
    {
    public:
      void push(const unsigned int group, const std::size_t degree)
      {
        if (degree >= by_degree.size())
          by_degree.resize(degree + 1);
        by_degree[degree].push_back(group);
        lowest = std::min(lowest, degree);
      }

      /** A group with at most @p most neighbours when pushed. */
      std::optional<unsigned int> pop(const std::size_t most)
      {
        for (; lowest < by_degree.size() && lowest <= most; ++lowest)
          {
            std::vector<unsigned int> &waiting = by_degree[lowest];
            if (waiting.empty())
              continue;
            const unsigned int group = waiting.back();
            waiting.pop_back();
            return group;
          }
        return std::nullopt;
      }

      std::size_t degree() const
      {
        return lowest;
      }

    private:
      std::vector<std::vector<unsigned int>> by_degree;
      std::size_t                            lowest = 0;
    };
  } // namespace

  JointGroups::JointGroups(const Unknowns &unknowns)
    : group(unknowns.layout.n_owned())
    , number(unknowns.layout.n_owned(), 0)
  {
    std::unordered_map<unsigned int, unsigned int> group_of_joint;
    for (unsigned int row = 0; row < group.size(); ++row)
      {
        if (unknowns.kinds[row] == UnknownKind::prescribed)
          continue;
        group[row] = group_of_joint.emplace(unknowns.joint[row], rows.size())
                       .first->second;
        if (*group[row] == rows.size())
          rows.emplace_back();
        number[row] = rows[*group[row]].size();
        rows[*group[row]].push_back(row);
      }
  }

  JointOrder::JointOrder(const SparseMatrix &matrix,
                         const JointGroups  &groups,
                         const Unknowns     &unknowns,
                         const unsigned int  max_neighbours)
    : groups(groups)
    , adjacent(groups.rows.size())
    , is_eliminated(groups.rows.size(), false)
    , must_stay(groups.rows.size(), false)
  {
    connect(matrix, unknowns);
    initial_links = adjacent;
    eliminate_groups(max_neighbours);
    for (unsigned int group = 0; group < groups.rows.size(); ++group)
      if (!is_eliminated[group])
        remaining_groups.push_back(group);
  }

  std::size_t JointOrder::initial_block(const unsigned int row,
                                        const unsigned int column) const
  {
    return find_link(initial_links[row], column)->block;
  }

  std::size_t JointOrder::memory() const
  {
    std::size_t sum = 0;
    for (const Links &links : initial_links)
      sum += sizeof(Links) + links.capacity() * sizeof(Link);
    for (const Links &links : adjacent)
      sum += sizeof(Links) + links.capacity() * sizeof(Link);
    for (const Pivot &pivot : order)
      sum += sizeof(Pivot) +
        (pivot.right.capacity() + pivot.left.capacity()) * sizeof(Link) +
        pivot.between.capacity() * sizeof(std::size_t);
    return sum;
  }

  void JointOrder::connect(const SparseMatrix &matrix, const Unknowns &unknowns)
  {
    std::vector<unsigned int> seen;
    for (unsigned int group = 0; group < groups.rows.size(); ++group)
      {
        seen.assign(1, group);
        for (const int row : groups.rows[group])
          for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1];
               ++i)
            if (const int column = matrix.columns[i];
                unknowns.kinds[column] != UnknownKind::prescribed)
              {
                if (!matrix.layout->is_owned(column))
                  must_stay[group] = true;
                // Columns of a group are usually adjacent.
                else if (const unsigned int other = *groups.group[column];
                         other != seen.back())
                  seen.push_back(other);
              }
        std::sort(seen.begin(), seen.end());
        seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
        adjacent[group].reserve(seen.size());
        for (const unsigned int other : seen)
          block(group, other);
      }
  }

  void JointOrder::eliminate_groups(const std::size_t max_neighbours)
  {
    const auto can_be_eliminated = [&](const unsigned int group) {
      return !is_eliminated[group] && !must_stay[group];
    };
    const auto degree = [this](const unsigned int group) {
      return adjacent[group].size() - 1;
    };
    Queue queue;
    for (unsigned int group = 0; group < groups.rows.size(); ++group)
      if (can_be_eliminated(group))
        queue.push(group, degree(group));
    while (const std::optional<unsigned int> group = queue.pop(max_neighbours))
      {
        // A group is pushed at every change; only its last entry is valid.
        if (is_eliminated[*group] || degree(*group) != queue.degree())
          continue;
        eliminate(*group);
        for (const Link &link : order.back().right)
          if (can_be_eliminated(link.group))
            queue.push(link.group, degree(link.group));
      }
  }

  void JointOrder::eliminate(const unsigned int group)
  {
    Pivot pivot;
    pivot.group = group;
    for (const Link &link : adjacent[group])
      if (link.group == group)
        pivot.block = link.block;
      else
        pivot.right.push_back(link);
    for (const Link &link : pivot.right)
      {
        Links     &neighbour_links = adjacent[link.group];
        const auto back            = find_link(neighbour_links, group);
        pivot.left.push_back({link.group, back->block});
        neighbour_links.erase(back);
      }
    for (const Link &row : pivot.right)
      for (const Link &column : pivot.right)
        pivot.between.push_back(block(row.group, column.group));
    is_eliminated[group] = true;
    Links().swap(adjacent[group]);
    order.push_back(std::move(pivot));
  }

  std::size_t JointOrder::block(const unsigned int row,
                                const unsigned int column)
  {
    Links &links = adjacent[row];
    auto   link  = find_link(links, column);
    if (link == links.end() || link->group != column)
      {
        link = links.insert(link, {column, n_used});
        n_used += groups.rows[row].size() * groups.rows[column].size();
      }
    return link->block;
  }
} // namespace auxfem
