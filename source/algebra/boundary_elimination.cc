#include <auxfem/algebra/boundary_elimination.h>
#include <auxfem/algebra/boundary_pivots.h>

#include <algorithm>
#include <utility>

namespace auxfem
{
  BoundaryElimination::BoundaryElimination(const SparseMatrix &matrix,
                                           const Unknowns     &unknowns,
                                           const unsigned int  most_neighbours)
    : before(unknowns)
    , pivots(boundary_pivots(matrix, unknowns))
    , front(matrix, unknowns, pivots, most_neighbours)
  {}

  bool BoundaryElimination::factorize(const SparseMatrix &matrix,
                                      const double        stiffness)
  {
    if (!front.factorize(matrix))
      return false;
    if (n_patterns != front.elimination().version())
      make_pattern(matrix);
    n_patterns = front.elimination().version();

    std::fill(left->entries.begin(), left->entries.end(), 0.);
    for (const Run &run : runs)
      std::copy_n(matrix.entries.begin() + run.from,
                  run.n,
                  left->entries.begin() + run.to);
    for (const std::size_t place : nothing)
      left->entries[place] = stiffness;
    auto place = places_of_returns.begin();
    for (const double entry : front.returns())
      left->entries[*place++] += entry;
    left->is_symmetric = matrix.is_symmetric;
    return true;
  }

  void BoundaryElimination::make_pattern(const SparseMatrix &matrix)
  {
    const std::vector<EliminationFront::Place> returns =
      front.places_of_returns();
    choose_rows(returns);
    std::vector<std::vector<Source>> coming(before.layout.n_owned());
    for (std::size_t number = 0; number < returns.size(); ++number)
      {
        const int column = known->layout.local(returns[number].column);
        coming[before.layout.local(returns[number].row)].push_back(
          {*joint_rows->row(column), true, number});
      }

    left = std::make_unique<SparseMatrix>(joint_rows->layout());
    left->columns.reserve(matrix.columns.size() + returns.size());
    runs.clear();
    nothing.clear();
    places_of_returns.resize(returns.size());
    std::vector<Source> sources;
    for (unsigned int row = 0; row < joint_rows->layout().n_owned(); ++row)
      {
        if (const auto unknown = joint_rows->unknown(row))
          {
            sources = coming[*unknown];
            complete_sources(matrix, *unknown, sources);
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
  }

  void BoundaryElimination::choose_rows(
    const std::vector<EliminationFront::Place> &returns)
  {
    std::vector<bool> comes_back(before.layout.n_owned(), false);
    std::vector<int>  columns;
    for (const EliminationFront::Place &place : returns)
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

  void BoundaryElimination::complete_sources(const SparseMatrix  &matrix,
                                             const unsigned int   unknown,
                                             std::vector<Source> &row) const
  {
    if (!pivots[unknown])
      for (std::size_t i = matrix.first[unknown]; i < matrix.first[unknown + 1];
           ++i)
        if (const int column = matrix.columns[i]; !pivots[column])
          row.push_back({*joint_rows->row(column), false, i});
    sort_by_column(row);
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
          places_of_returns[source.number] = place;
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

  void BoundaryElimination::reduce(const double *b, double *g)
  {
    std::vector<double> all(b, b + before.layout.n_owned()), values;
    for (const int row : front.rows_in_fronts())
      values.push_back(pivots[row] ? std::exchange(all[row], 0.) : 0.);
    front.reduce(values);
    auto value = values.begin();
    for (const int row : front.rows_in_fronts())
      all[row] += *value++;
    for (unsigned int row = 0; row < joint_rows->layout().n_owned(); ++row)
      {
        const auto unknown = joint_rows->unknown(row);
        g[row]             = unknown ? all[*unknown] : 0.;
      }
  }

  void BoundaryElimination::expand(const double *z, double *x)
  {
    std::fill_n(x, before.layout.n_owned(), 0.);
    for (unsigned int row = 0; row < joint_rows->layout().n_owned(); ++row)
      if (const auto unknown = joint_rows->unknown(row))
        x[*unknown] = z[row];
    std::vector<double> values;
    for (const int row : front.rows_in_fronts())
      values.push_back(x[row]);
    front.expand(values);
    auto value = values.begin();
    for (const int row : front.rows_in_fronts())
      x[row] = *value++;
  }

  std::size_t BoundaryElimination::memory() const
  {
    return front.memory() + runs.capacity() * sizeof(Run) +
      left->entries.capacity() * sizeof(double) +
      left->columns.capacity() * sizeof(int);
  }
} // namespace auxfem
