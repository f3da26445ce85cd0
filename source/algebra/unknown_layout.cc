#include <auxfem/algebra/unknown_layout.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>

namespace auxfem
{
  namespace MPI = dealii::Utilities::MPI;

  UnknownLayout::UnknownLayout(const MPI_Comm          communicator,
                               const unsigned int      n_owned,
                               const std::vector<int> &of_others)
    : comm(communicator)
    , my_rank(MPI::this_mpi_process(communicator))
    , first(1, 0)
  {
    for (const unsigned int n : MPI::all_gather(communicator, n_owned))
      first.push_back(first.back() + n);
    for (const int global : of_others)
      {
        local_of_ghost[global] = n_local();
        ghosts.push_back(global);
      }
    make_exchange();
  }

  void UnknownLayout::make_exchange()
  {
    // deal.II divides by the number of unknowns.
    if (n_ranks() == 1 || n_global() == 0)
      return;
    std::vector<dealii::types::global_dof_index> owned(n_owned());
    std::iota(owned.begin(), owned.end(), first[my_rank]);
    exchange = std::make_shared<const MPI::NoncontiguousPartitioner>(
      owned,
      std::vector<dealii::types::global_dof_index>(ghosts.begin(),
                                                   ghosts.end()),
      comm);
  }

  unsigned int UnknownLayout::owner(const int global) const
  {
    return std::upper_bound(first.begin(), first.end(), global) -
      first.begin() - 1;
  }

  int UnknownLayout::local(const int global) const
  {
    if (global < 0)
      return -1;
    if (global >= first[my_rank] && global < first[my_rank + 1])
      return global - first[my_rank];
    const auto ghost = local_of_ghost.find(global);
    return ghost == local_of_ghost.end() ? -1 : ghost->second;
  }

  void UnknownLayout::update_ghosts(double *values) const
  {
    if (exchange)
      exchange->export_to_ghosted_array(
        dealii::ArrayView<const double>(values, n_owned()),
        dealii::ArrayView<double>(values + n_owned(), ghosts.size()));
  }

  void UnknownLayout::update_ghosts(
    std::vector<std::optional<unsigned int>> &numbers) const
  {
    // Numbers go the way values go; below 2^53 they come whole. Zero: none.
    std::vector<double> values(n_local());
    for (unsigned int i = 0; i < n_owned(); ++i)
      values[i] = numbers[i] ? 1. + *numbers[i] : 0.;
    update_ghosts(values.data());
    for (unsigned int i = n_owned(); i < n_local(); ++i)
      if (values[i] > 0)
        numbers[i] = static_cast<unsigned int>(values[i] - 1);
      else
        numbers[i].reset();
  }

  bool UnknownLayout::add_ghosts(const std::vector<int> &globals)
  {
    const unsigned int n_before = ghosts.size();
    for (const int global : globals)
      if (local(global) < 0)
        {
          local_of_ghost[global] = n_local();
          ghosts.push_back(global);
        }
    const bool has_grown =
      MPI::max(static_cast<unsigned int>(ghosts.size() > n_before), comm) > 0;
    if (has_grown)
      make_exchange();
    return has_grown;
  }

  double UnknownLayout::sum(const double mine) const
  {
    return n_ranks() == 1 ? mine : MPI::sum(mine, comm);
  }

  std::vector<double> UnknownLayout::sum(const std::vector<double> &mine) const
  {
    if (n_ranks() == 1)
      return mine;
    std::vector<double> all(mine.size());
    MPI::sum(mine, comm, all);
    return all;
  }

  double UnknownLayout::largest(const double mine) const
  {
    return n_ranks() == 1 ? mine : MPI::max(mine, comm);
  }
} // namespace auxfem
