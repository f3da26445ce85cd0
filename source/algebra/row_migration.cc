#include <auxfem/algebra/row_migration.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace auxfem
{
  namespace
  {
    /** Of rows, each its length and as many numbers. */
    SizesByRank n_entries(const ListsByRank<int> &rows)
    {
      SizesByRank n;
      for (const auto &[rank, of_rank] : rows)
        for (std::size_t i = 0; i < of_rank.size(); i += 1 + of_rank[i])
          n[rank] += of_rank[i];
      return n;
    }

    /** Rows of a joint go where the lowest rank among their @p target is. */
    void keep_joints_together(const Unknowns            &unknowns,
                              const unsigned int         own_rank,
                              std::vector<unsigned int> &target)
    {
      std::unordered_map<unsigned int, unsigned int> lowest;
      for (unsigned int row = 0; row < target.size(); ++row)
        if (target[row] < own_rank)
          {
            unsigned int &of_joint =
              lowest.emplace(unknowns.joint[row], target[row]).first->second;
            of_joint = std::min(of_joint, target[row]);
          }
      if (!lowest.empty())
        for (unsigned int row = 0; row < target.size(); ++row)
          if (const auto known = lowest.find(unknowns.joint[row]);
              known != lowest.end())
            target[row] = known->second;
    }

    /** Joints that act on those of a lower rank go there, and their neighbours
     * with them. */
    std::vector<unsigned int> find_targets(const SparseMatrix &matrix,
                                           const Unknowns     &unknowns)
    {
      const UnknownLayout      &layout = *matrix.layout;
      std::vector<unsigned int> target(layout.n_owned(), layout.rank());
      const auto go_with_columns = [&](const std::vector<unsigned int> &ranks) {
        for (unsigned int row = 0; row < target.size(); ++row)
          for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1];
               ++i)
            target[row] = std::min(target[row], ranks[matrix.columns[i]]);
        keep_joints_together(unknowns, layout.rank(), target);
      };
      // Joints at the boundary, then their neighbours of this rank with them.
      std::vector<unsigned int> ranks(layout.n_local(), layout.rank());
      for (unsigned int ghost = target.size(); ghost < ranks.size(); ++ghost)
        ranks[ghost] = layout.owner(layout.global(ghost));
      go_with_columns(ranks);
      ranks = target;
      ranks.resize(layout.n_local(), layout.rank());
      go_with_columns(ranks);
      return target;
    }
  } // namespace

  RowMigration::RowMigration(const SparseMatrix &matrix,
                             const Unknowns     &unknowns)
    : RowMigration(matrix, unknowns, find_targets(matrix, unknowns))
  {}

  RowMigration::RowMigration(const SparseMatrix       &matrix,
                             const Unknowns           &unknowns,
                             std::vector<unsigned int> target_of_row)
    : old_layout(*matrix.layout)
    , target(std::move(target_of_row))
  {
    number_rows();
    move_pattern(matrix);
    move_unknowns(unknowns);
  }

  void RowMigration::number_rows()
  {
    const MPI_Comm   communicator = old_layout.communicator();
    ListsByRank<int> leaving;
    for (unsigned int row = 0; row < target.size(); ++row)
      if (target[row] == old_layout.rank())
        kept.push_back(row);
      else
        leaving[target[row]].push_back(old_layout.global(row));
    const ListsByRank<int> coming = exchange_lists(leaving, communicator);

    const std::vector<int> of_others = one_after_the_other(coming);
    arrivals = std::make_unique<UnknownLayout>(communicator,
                                               old_layout.n_owned(),
                                               of_others);
    const UnknownLayout owned(communicator, kept.size() + of_others.size(), {});

    ListsByRank<int> answers;
    int              next = owned.first_of(owned.rank());
    new_number.assign(old_layout.n_local(), 0);
    for (const int row : kept)
      new_number[row] = next++;
    for (const auto &[rank, globals] : coming)
      for (unsigned int i = 0; i < globals.size(); ++i)
        answers[rank].push_back(next++);
    std::vector<int> departed;
    for (const auto &[rank, numbers] : exchange_lists(answers, communicator))
      for (unsigned int i = 0; i < numbers.size(); ++i)
        {
          new_number[old_layout.local(leaving[rank][i])] = numbers[i];
          departed.push_back(numbers[i]);
        }
    returns =
      std::make_unique<UnknownLayout>(communicator, owned.n_owned(), departed);
    // Numbers go the way values go; below 2^53 they come whole.
    std::vector<double> numbers(new_number.begin(), new_number.end());
    old_layout.update_ghosts(numbers.data());
    std::copy(numbers.begin(), numbers.end(), new_number.begin());
  }

  void RowMigration::move_pattern(const SparseMatrix &matrix)
  {
    // Every row as its length and the new numbers of its columns.
    ListsByRank<int> leaving;
    leaving[old_layout.rank()].reserve(matrix.columns.size() + target.size());
    for (unsigned int row = 0; row < target.size(); ++row)
      {
        std::vector<int> &parcel = leaving[target[row]];
        parcel.push_back(matrix.first[row + 1] - matrix.first[row]);
        for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
          parcel.push_back(new_number[matrix.columns[i]]);
      }
    std::vector<int> own;
    leaving[old_layout.rank()].swap(own);
    leaving.erase(old_layout.rank());
    const ListsByRank<int> coming =
      exchange_lists(leaving, old_layout.communicator());
    entries = NeighbourExchange(old_layout.communicator(),
                                n_entries(leaving),
                                n_entries(coming));
    const std::vector<int> of_others = one_after_the_other(coming);
    own.insert(own.end(), of_others.begin(), of_others.end());

    const int begin = returns->first_of(returns->rank()),
              end   = returns->first_of(returns->rank() + 1);
    std::vector<int> ghosts;
    for (std::size_t i = 0; i < own.size(); i += 1 + own[i])
      for (int k = 1; k <= own[i]; ++k)
        if (const int column = own[i + k]; column < begin || column >= end)
          ghosts.push_back(column);
    std::sort(ghosts.begin(), ghosts.end());
    ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
    new_layout = std::make_unique<UnknownLayout>(old_layout.communicator(),
                                                 returns->n_owned(),
                                                 ghosts);
    new_matrix = std::make_unique<SparseMatrix>(*new_layout);
    const std::size_t n_all = own.size() - returns->n_owned();
    order.reserve(n_all);
    new_matrix->columns.reserve(n_all);
    std::vector<int> columns;
    unsigned int     row = 0;
    for (std::size_t i = 0; i < own.size(); i += 1 + own[i])
      {
        columns.resize(own[i]);
        for (int k = 0; k < own[i]; ++k)
          columns[k] = new_layout->local(own[i + 1 + k]);
        append_row(columns);
        new_matrix->first[++row] = new_matrix->columns.size();
      }
    new_matrix->entries.resize(n_all);
  }

  void RowMigration::append_row(const std::vector<int> &columns)
  {
    const std::size_t first = order.size();
    order.resize(first + columns.size());
    if (std::is_sorted(columns.begin(), columns.end()))
      {
        std::iota(order.begin() + first, order.end(), first);
        new_matrix->columns.insert(new_matrix->columns.end(),
                                   columns.begin(),
                                   columns.end());
        return;
      }
    std::vector<std::size_t> positions(columns.size());
    std::iota(positions.begin(), positions.end(), 0);
    std::sort(positions.begin(),
              positions.end(),
              [&](const std::size_t a, const std::size_t b) {
                return columns[a] < columns[b];
              });
    for (std::size_t k = 0; k < positions.size(); ++k)
      {
        order[first + positions[k]] = first + k;
        new_matrix->columns.push_back(columns[positions[k]]);
      }
  }

  void RowMigration::fill(const SparseMatrix &matrix)
  {
    ListsByRank<double> leaving;
    auto                position = order.begin();
    for (unsigned int row = 0; row < target.size(); ++row)
      for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
        if (target[row] == old_layout.rank())
          new_matrix->entries[*position++] = matrix.entries[i];
        else
          leaving[target[row]].push_back(matrix.entries[i]);
    for (const double entry : entries.exchange(one_after_the_other(leaving)))
      new_matrix->entries[*position++] = entry;
    new_matrix->is_symmetric = matrix.is_symmetric;
  }

  void RowMigration::move_unknowns(const Unknowns &unknowns)
  {
    std::vector<double> kinds(target.size()), joints(kinds), components(kinds);
    for (unsigned int row = 0; row < target.size(); ++row)
      {
        kinds[row]      = static_cast<double>(unknowns.kinds[row]);
        joints[row]     = unknowns.joint[row];
        components[row] = unknowns.component[row];
      }
    kinds      = there(kinds);
    joints     = there(joints);
    components = there(components);

    new_unknowns             = std::make_unique<Unknowns>(*new_layout);
    new_unknowns->positions  = unknowns.positions;
    new_unknowns->components = unknowns.components;
    new_unknowns->length     = unknowns.length;
    for (unsigned int i = 0; i < new_layout->n_local(); ++i)
      {
        new_unknowns->kinds[i] =
          static_cast<UnknownKind>(static_cast<unsigned char>(kinds[i]));
        new_unknowns->joint[i]     = static_cast<unsigned int>(joints[i]);
        new_unknowns->component[i] = static_cast<unsigned char>(components[i]);
      }
  }

  std::vector<double>
  RowMigration::there(const std::vector<double> &before) const
  {
    std::vector<double> now(new_layout->n_local());
    go(before.data(), now.data());
    new_layout->update_ghosts(now.data());
    return now;
  }

  void RowMigration::go(const double *before, double *now) const
  {
    std::vector<double> values(arrivals->n_local());
    std::copy_n(before, arrivals->n_owned(), values.begin());
    arrivals->update_ghosts(values.data());
    for (unsigned int i = 0; i < kept.size(); ++i)
      now[i] = values[kept[i]];
    std::copy(values.begin() + arrivals->n_owned(),
              values.end(),
              now + kept.size());
  }

  void RowMigration::come_back(const double *now, double *before) const
  {
    std::vector<double> values(returns->n_local());
    std::copy_n(now, returns->n_owned(), values.begin());
    returns->update_ghosts(values.data());
    for (unsigned int row = 0; row < target.size(); ++row)
      before[row] = values[returns->local(new_number[row])];
  }
} // namespace auxfem
