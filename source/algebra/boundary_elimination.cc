#include <auxfem/algebra/boundary_elimination.h>
#include <auxfem/algebra/boundary_pivots.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace auxfem
{
  namespace
  {
    template <typename T>
    SizesByRank sizes(const ListsByRank<T> &lists)
    {
      SizesByRank n;
      for (const auto &[rank, list] : lists)
        n[rank] = list.size();
      return n;
    }

    int position(const std::vector<int> &ascending, const int number)
    {
      return std::lower_bound(ascending.begin(), ascending.end(), number) -
        ascending.begin();
    }
  } // namespace

  BoundaryElimination::BoundaryElimination(const SparseMatrix &matrix,
                                           const Unknowns     &unknowns,
                                           const unsigned int  most_neighbours)
    : before(unknowns)
    , most_neighbours(most_neighbours)
    , pivots(boundary_pivots(matrix, unknowns))
  {
    make_front(matrix);
  }

  void BoundaryElimination::make_front(const SparseMatrix &matrix)
  {
    const UnknownLayout     &layout = before.layout;
    ListsByRank<FrontRow>    rows;
    ListsByRank<Place>       places;
    ListsByRank<int>         owned;
    ListsByRank<std::size_t> entries;
    for (unsigned int row = 0; row < layout.n_owned(); ++row)
      for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
        {
          const int   column = matrix.columns[i];
          const auto &rank   = pivots[row] ? pivots[row] : pivots[column];
          if (!rank || before.kinds[row] == UnknownKind::prescribed)
            continue;
          std::vector<int> &of_rank = owned[*rank];
          if (of_rank.empty() || of_rank.back() != static_cast<int>(row))
            {
              of_rank.push_back(row);
              rows[*rank].push_back({layout.global(row),
                                     pivots[row].has_value(),
                                     before.kinds[row],
                                     before.joint[row],
                                     before.component[row]});
            }
          places[*rank].push_back({layout.global(row), layout.global(column)});
          entries[*rank].push_back(i);
        }
    rows_there    = one_after_the_other(owned);
    entries_there = one_after_the_other(entries);

    const MPI_Comm communicator = layout.communicator();
    const auto     rows_here    = exchange_lists(rows, communicator);
    const auto     places_here  = exchange_lists(places, communicator);
    send_values =
      NeighbourExchange(communicator, sizes(rows), sizes(rows_here));
    return_values =
      NeighbourExchange(communicator, sizes(rows_here), sizes(rows));
    send_entries =
      NeighbourExchange(communicator, sizes(places), sizes(places_here));
    receive_front(one_after_the_other(rows_here),
                  one_after_the_other(places_here));
  }

  void BoundaryElimination::receive_front(const std::vector<FrontRow> &rows,
                                          const std::vector<Place>    &places)
  {
    unknowns = std::make_unique<Unknowns>(
      UnknownLayout(before.layout.communicator(), rows.size(), {}));
    unknowns->positions  = before.positions;
    unknowns->components = before.components;
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
    elimination =
      std::make_unique<JointElimination>(*unknowns, most_neighbours, kept);

    front = std::make_unique<SparseMatrix>(unknowns->layout);
    front->entries.resize(places.size());
    places_in_front.resize(places.size());
    std::vector<std::pair<int, std::size_t>>
                of_row; // column, number as it came
    std::size_t next = 0;
    for (unsigned int row = 0; row < rows.size(); ++row)
      {
        of_row.clear();
        for (; next < places.size() && places[next].row == globals[row]; ++next)
          of_row.emplace_back(position(globals, places[next].column), next);
        std::sort(of_row.begin(), of_row.end());
        for (const auto &[column, number] : of_row)
          {
            places_in_front[number] = front->columns.size();
            front->columns.push_back(column);
          }
        front->first[row + 1] = front->columns.size();
      }
  }

  bool BoundaryElimination::factorize(const SparseMatrix &matrix,
                                      const double        stiffness)
  {
    fill_front(matrix);
    if (!elimination->factorize(*front))
      return false;
    if (n_orders != elimination->version())
      make_pattern(matrix);
    n_orders = elimination->version();
    fill_matrix(matrix, stiffness);
    return true;
  }

  void BoundaryElimination::fill_front(const SparseMatrix &matrix)
  {
    std::vector<double> entries;
    entries.reserve(entries_there.size());
    for (const std::size_t i : entries_there)
      entries.push_back(matrix.entries[i]);
    auto place = places_in_front.begin();
    for (const double entry : send_entries.exchange(entries))
      front->entries[*place++] = entry;
    front->is_symmetric = matrix.is_symmetric;
  }

  void BoundaryElimination::make_pattern(const SparseMatrix &matrix)
  {
    const ListsByRank<Place> leaving = find_returns(),
                             coming =
                               exchange_lists(leaving,
                                              before.layout.communicator());
    return_entries = NeighbourExchange(before.layout.communicator(),
                                       sizes(leaving),
                                       sizes(coming));
    const std::vector<Place> places = one_after_the_other(coming);
    choose_rows(places);

    std::vector<Returned> returned(before.layout.n_owned());
    for (std::size_t number = 0; number < places.size(); ++number)
      returned[before.layout.local(places[number].row)]
        .emplace_back(known->layout.local(places[number].column), number);
    left = std::make_unique<SparseMatrix>(joint_rows->layout());
    runs.clear();
    nothing.clear();
    places_left.resize(places.size());
    left->columns.reserve(matrix.columns.size() + places.size());
    std::vector<Source> sources;
    for (unsigned int row = 0; row < joint_rows->layout().n_owned(); ++row)
      {
        if (const auto unknown = joint_rows->unknown(row))
          {
            find_sources(matrix, *unknown, returned[*unknown], sources);
            append_row(sources);
          }
        else
          {
            nothing.push_back(left->columns.size());
            left->columns.push_back(row);
          }
        left->first[row + 1] = left->columns.size();
      }
    left->entries.resize(left->columns.size());
    ++n_patterns;
  }

  ListsByRank<BoundaryElimination::Place> BoundaryElimination::find_returns()
  {
    const JointRows         &rows = elimination->rows();
    const SparseMatrix      &rest = elimination->matrix();
    ListsByRank<Place>       places;
    ListsByRank<std::size_t> entries;
    for (unsigned int row = 0; row < rows.layout().n_owned(); ++row)
      if (const auto unknown = rows.unknown(row))
        {
          const int          global = globals[*unknown];
          const unsigned int rank   = before.layout.owner(global);
          for (std::size_t i = rest.first[row]; i < rest.first[row + 1]; ++i)
            {
              places[rank].push_back(
                {global, globals[*rows.unknown(rest.columns[i])]});
              entries[rank].push_back(i);
            }
        }
    entries_back = one_after_the_other(entries);
    return places;
  }

  void BoundaryElimination::choose_rows(const std::vector<Place> &returns)
  {
    std::vector<bool> comes_back(before.layout.n_owned(), false);
    std::vector<int>  columns;
    for (const Place &place : returns)
      {
        comes_back[before.layout.local(place.row)] = true;
        columns.push_back(place.column);
      }
    known = std::make_unique<Unknowns>(before);
    known->add_ghosts(columns);
    std::vector<int> taken;
    for (unsigned int row = 0; row < before.layout.n_owned(); ++row)
      if (before.kinds[row] != UnknownKind::prescribed &&
          (!pivots[row] || comes_back[row]))
        taken.push_back(row);
    joint_rows = std::make_unique<JointRows>(*known, taken);
  }

  void BoundaryElimination::find_sources(const SparseMatrix  &matrix,
                                         const unsigned int   unknown,
                                         const Returned      &returned,
                                         std::vector<Source> &row) const
  {
    row.clear();
    if (!pivots[unknown])
      for (std::size_t i = matrix.first[unknown]; i < matrix.first[unknown + 1];
           ++i)
        if (const int column = matrix.columns[i]; !pivots[column])
          row.push_back({*joint_rows->row(column), false, i});
    for (const auto &[column, number] : returned)
      row.push_back({*joint_rows->row(column), true, number});
    const auto is_before = [](const Source &a, const Source &b) {
      return a.column < b.column;
    };
    if (!std::is_sorted(row.begin(), row.end(), is_before))
      std::sort(row.begin(), row.end(), is_before);
  }

  void BoundaryElimination::append_row(const std::vector<Source> &row)
  {
    const std::size_t begin = left->columns.size();
    for (const Source &source : row)
      {
        if (left->columns.size() == begin ||
            left->columns.back() != static_cast<int>(source.column))
          left->columns.push_back(source.column);
        const std::size_t place = left->columns.size() - 1;
        if (source.comes_back)
          places_left[source.number] = place;
        else
          append_run(source.number, place);
      }
  }

  void BoundaryElimination::append_run(const std::size_t from,
                                       const std::size_t to)
  {
    if (!runs.empty() && runs.back().from + runs.back().n == from &&
        runs.back().to + runs.back().n == to)
      ++runs.back().n;
    else
      runs.push_back({from, to, 1});
  }

  void BoundaryElimination::fill_matrix(const SparseMatrix &matrix,
                                        const double        stiffness)
  {
    std::fill(left->entries.begin(), left->entries.end(), 0.);
    for (const Run &run : runs)
      std::copy_n(matrix.entries.begin() + run.from,
                  run.n,
                  left->entries.begin() + run.to);
    for (const std::size_t place : nothing)
      left->entries[place] = stiffness;

    std::vector<double> entries;
    entries.reserve(entries_back.size());
    for (const std::size_t i : entries_back)
      entries.push_back(elimination->matrix().entries[i]);
    auto place = places_left.begin();
    for (const double entry : return_entries.exchange(entries))
      left->entries[*place++] += entry;
    left->is_symmetric = matrix.is_symmetric;
  }

  void BoundaryElimination::reduce(const double *b, double *g)
  {
    std::vector<double> there;
    there.reserve(rows_there.size());
    for (const int row : rows_there)
      there.push_back(pivots[row] ? b[row] : 0.);
    there = send_values.exchange(there);

    const JointRows    &rows = elimination->rows();
    std::vector<double> reduced(rows.layout().n_owned());
    elimination->reduce(there.data(), reduced.data());
    std::fill(there.begin(), there.end(), 0.);
    for (unsigned int row = 0; row < reduced.size(); ++row)
      if (const auto unknown = rows.unknown(row))
        there[*unknown] = reduced[row];
    const std::vector<double> back = return_values.exchange(there);

    std::vector<double> sum(b, b + before.layout.n_owned());
    for (const int row : rows_there)
      if (pivots[row])
        sum[row] = 0;
    for (std::size_t k = 0; k < back.size(); ++k)
      sum[rows_there[k]] += back[k];
    for (unsigned int row = 0; row < joint_rows->layout().n_owned(); ++row)
      {
        const auto unknown = joint_rows->unknown(row);
        g[row]             = unknown ? sum[*unknown] : 0.;
      }
  }

  void BoundaryElimination::expand(const double *z, double *x)
  {
    std::fill_n(x, before.layout.n_owned(), 0.);
    for (unsigned int row = 0; row < joint_rows->layout().n_owned(); ++row)
      if (const auto unknown = joint_rows->unknown(row))
        x[*unknown] = z[row];
    std::vector<double> there;
    there.reserve(rows_there.size());
    for (const int row : rows_there)
      there.push_back(x[row]);
    there = send_values.exchange(there);

    const JointRows    &rows = elimination->rows();
    std::vector<double> reduced(rows.layout().n_owned(), 0.);
    for (unsigned int row = 0; row < reduced.size(); ++row)
      if (const auto unknown = rows.unknown(row))
        reduced[row] = there[*unknown];
    elimination->expand(reduced.data(), there.data());
    const std::vector<double> back = return_values.exchange(there);
    for (std::size_t k = 0; k < back.size(); ++k)
      if (pivots[rows_there[k]])
        x[rows_there[k]] = back[k];
  }

  std::size_t BoundaryElimination::memory() const
  {
    return entries_there.capacity() * sizeof(std::size_t) +
      runs.capacity() * sizeof(Run) +
      left->entries.capacity() * sizeof(double) +
      left->columns.capacity() * sizeof(int) + elimination->memory();
  }
} // namespace auxfem
