#include <auxfem/algebra/elimination_front.h>

#include <algorithm>
#include <utility>

namespace auxfem
{
  EliminationFront::EliminationFront(
    const SparseMatrix                             &matrix,
    const Unknowns                                 &unknowns,
    const std::vector<std::optional<unsigned int>> &pivots,
    const unsigned int                              most_neighbours)
    : layout(unknowns.layout)
  {
    ListsByRank<Row>         rows;
    ListsByRank<Place>       places;
    ListsByRank<int>         owned;
    ListsByRank<std::size_t> entries;
    for (unsigned int row = 0; row < layout.n_owned(); ++row)
      for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
        {
          const int   column = matrix.columns[i];
          const auto &rank   = pivots[row] ? pivots[row] : pivots[column];
          if (!rank || unknowns.kinds[row] == UnknownKind::prescribed)
            continue;
          std::vector<int> &of_rank = owned[*rank];
          if (of_rank.empty() || of_rank.back() != static_cast<int>(row))
            {
              of_rank.push_back(row);
              rows[*rank].push_back({layout.global(row),
                                     pivots[row].has_value(),
                                     unknowns.kinds[row],
                                     unknowns.joint[row],
                                     unknowns.component[row]});
            }
          places[*rank].push_back({layout.global(row), layout.global(column)});
          entries[*rank].push_back(i);
        }
    rows_there    = one_after_the_other(owned);
    entries_there = one_after_the_other(entries);

    const MPI_Comm communicator = layout.communicator();
    const auto     rows_here    = exchange_lists(rows, communicator);
    const auto     places_here  = exchange_lists(places, communicator);
    send_values   = {communicator, lengths(rows), lengths(rows_here)};
    return_values = {communicator, lengths(rows_here), lengths(rows)};
    send_entries  = {communicator, lengths(places), lengths(places_here)};
    receive(one_after_the_other(rows_here), unknowns, most_neighbours);
    make_pattern(one_after_the_other(places_here));
  }

  void EliminationFront::receive(const std::vector<Row> &rows,
                                 const Unknowns         &of_all,
                                 const unsigned int      most_neighbours)
  {
    unknowns = std::make_unique<Unknowns>(
      UnknownLayout(layout.communicator(), rows.size(), {}));
    unknowns->positions  = of_all.positions;
    unknowns->components = of_all.components;
    std::vector<int> kept;
    for (unsigned int row = 0; row < rows.size(); ++row)
      {
        globals.push_back(rows[row].global);
        unknowns->kinds[row]     = rows[row].kind;
        unknowns->joint[row]     = rows[row].joint;
        unknowns->component[row] = rows[row].component;
        if (!rows[row].is_pivot)
          kept.push_back(row);
      }
    joints = std::make_unique<JointElimination>(*unknowns,
                                                most_neighbours,
                                                std::move(kept));
  }

  void EliminationFront::make_pattern(const std::vector<Place> &places)
  {
    front = std::make_unique<SparseMatrix>(unknowns->layout);
    front->entries.resize(places.size());
    places_in_front.resize(places.size());
    std::vector<std::pair<int, std::size_t>>
                row; // columns, numbers as they come
    std::size_t next = 0;
    for (unsigned int number = 0; number < globals.size(); ++number)
      {
        row.clear();
        for (; next < places.size() && places[next].row == globals[number];
             ++next)
          row.emplace_back(std::lower_bound(globals.begin(),
                                            globals.end(),
                                            places[next].column) -
                             globals.begin(),
                           next);
        std::sort(row.begin(), row.end());
        for (const auto &[column, place] : row)
          {
            places_in_front[place] = front->columns.size();
            front->columns.push_back(column);
          }
        front->first[number + 1] = front->columns.size();
      }
  }

  bool EliminationFront::factorize(const SparseMatrix &matrix)
  {
    std::vector<double> entries;
    entries.reserve(entries_there.size());
    for (const std::size_t i : entries_there)
      entries.push_back(matrix.entries[i]);
    auto place = places_in_front.begin();
    for (const double entry : send_entries.exchange(entries))
      front->entries[*place++] = entry;
    front->is_symmetric = matrix.is_symmetric;
    return joints->factorize(*front);
  }

  std::vector<EliminationFront::Place> EliminationFront::places_of_returns()
  {
    const JointRows         &rows = joints->rows();
    const SparseMatrix      &left = joints->matrix();
    ListsByRank<Place>       leaving;
    ListsByRank<std::size_t> entries;
    for (unsigned int row = 0; row < rows.layout().n_owned(); ++row)
      if (const auto unknown = rows.unknown(row))
        {
          const int          global = globals[*unknown];
          const unsigned int rank   = layout.owner(global);
          for (std::size_t i = left.first[row]; i < left.first[row + 1]; ++i)
            {
              leaving[rank].push_back(
                {global, globals[*rows.unknown(left.columns[i])]});
              entries[rank].push_back(i);
            }
        }
    entries_back      = one_after_the_other(entries);
    const auto coming = exchange_lists(leaving, layout.communicator());
    return_entries = {layout.communicator(), lengths(leaving), lengths(coming)};
    return one_after_the_other(coming);
  }

  std::vector<double> EliminationFront::returns() const
  {
    std::vector<double> entries;
    entries.reserve(entries_back.size());
    for (const std::size_t i : entries_back)
      entries.push_back(joints->matrix().entries[i]);
    return return_entries.exchange(entries);
  }

  void EliminationFront::reduce(std::vector<double> &values)
  {
    std::vector<double> of_front = send_values.exchange(values);
    const JointRows    &rows     = joints->rows();
    std::vector<double> left(rows.layout().n_owned());
    joints->reduce(of_front.data(), left.data());
    std::fill(of_front.begin(), of_front.end(), 0.);
    for (unsigned int row = 0; row < left.size(); ++row)
      if (const auto unknown = rows.unknown(row))
        of_front[*unknown] = left[row];
    values = return_values.exchange(of_front);
  }

  void EliminationFront::expand(std::vector<double> &values)
  {
    std::vector<double> of_front = send_values.exchange(values);
    const JointRows    &rows     = joints->rows();
    std::vector<double> left(rows.layout().n_owned(), 0.);
    for (unsigned int row = 0; row < left.size(); ++row)
      if (const auto unknown = rows.unknown(row))
        left[row] = of_front[*unknown];
    joints->expand(left.data(), of_front.data());
    values = return_values.exchange(of_front);
  }

  std::size_t EliminationFront::memory() const
  {
    return entries_there.capacity() * sizeof(std::size_t) +
      front->entries.capacity() * (sizeof(double) + sizeof(int)) +
      entries_back.capacity() * sizeof(std::size_t) + joints->memory();
  }
} // namespace auxfem
