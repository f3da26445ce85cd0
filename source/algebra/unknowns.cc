#include <auxfem/algebra/unknowns.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace auxfem
{
  namespace MPI = dealii::Utilities::MPI;

  UnknownLayout::UnknownLayout(const MPI_Comm          communicator,
                               const unsigned int      n_owned,
                               const std::vector<int> &ghost_numbers)
    : comm(communicator)
    , my_rank(MPI::this_mpi_process(communicator))
    , first(1, 0)
  {
    for (const unsigned int n : MPI::all_gather(communicator, n_owned))
      first.push_back(first.back() + n);
    for (const int global : ghost_numbers)
      {
        local_of_ghost[global] = n_local();
        ghosts.push_back(global);
      }
    make_exchange();
  }

  void UnknownLayout::make_exchange()
  {
    // deal.II would divide by zero unknowns.
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
    // Numbers are exchanged as doubles, exact below 2^53; zero means none.
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

  Unknowns::Unknowns(const UnknownLayout &layout)
    : layout(layout)
    , kinds(layout.n_local(), UnknownKind::translation)
    , is_rotation(layout.n_local(), false)
    , strut(layout.n_local())
    , joint(layout.n_local(), 0)
    , component(layout.n_local(), 0)
  {}

  bool Unknowns::add_ghosts(const std::vector<int> &globals)
  {
    if (!layout.add_ghosts(globals))
      return false;
    const auto exchange =
      [this](auto &values, const auto &from, const auto &to) {
        std::vector<double> all(layout.n_local());
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          all[i] = from(values[i]);
        layout.update_ghosts(all.data());
        const std::size_t n_before = values.size();
        values.resize(all.size());
        for (std::size_t i = n_before; i < all.size(); ++i)
          values[i] = to(all[i]);
      };
    const auto as_number = [](const auto value) {
      return static_cast<double>(value);
    };
    exchange(kinds, as_number, [](const double value) {
      return static_cast<UnknownKind>(std::lround(value));
    });
    exchange(is_rotation, as_number, [](const double value) {
      return value > 0;
    });
    exchange(joint, as_number, [](const double value) {
      return static_cast<unsigned int>(std::lround(value));
    });
    exchange(component, as_number, [](const double value) {
      return static_cast<unsigned char>(std::lround(value));
    });
    strut.resize(layout.n_local());
    layout.update_ghosts(strut);
    return true;
  }

  OwnedRows Unknowns::owned_rows() const
  {
    OwnedRows rows;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (kinds[i] == UnknownKind::multiplier)
        rows.multipliers.push_back(i);
      else if (kinds[i] == UnknownKind::prescribed)
        (is_rotation[i] ? rows.prescribed_rotations
                        : rows.prescribed_translations)
          .push_back(i);
      else
        (is_rotation[i] ? rows.free_rotations : rows.free_translations)
          .push_back(i);
    return rows;
  }

  unsigned int Unknowns::n_free() const
  {
    double mine = 0;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      mine += (kinds[i] == UnknownKind::translation ||
               kinds[i] == UnknownKind::rotation);
    return std::lround(layout.sum(mine));
  }

  unsigned long Unknowns::n_of_kind(const UnknownKind kind) const
  {
    const auto first = kinds.begin();
    return std::lround(
      layout.sum(double(std::count(first, first + layout.n_owned(), kind))));
  }

  namespace
  {
    UnknownLayout layout_of(const UnknownLayout     &all,
                            const std::vector<bool> &is_selected)
    {
      const unsigned int n_owned =
        std::count(is_selected.begin(),
                   is_selected.begin() + all.n_owned(),
                   true);
      UnknownLayout layout(all.communicator(), n_owned, {});
      if (all.n_ranks() == 1)
        return layout;

      // Exchange the selection's numbers as values.
      std::vector<double> globals(all.n_local(), -1.);
      unsigned int        number = 0;
      for (unsigned int i = 0; i < all.n_owned(); ++i)
        if (is_selected[i])
          globals[i] = layout.global(number++);
      all.update_ghosts(globals.data());
      std::vector<int> ghosts;
      for (unsigned int i = all.n_owned(); i < all.n_local(); ++i)
        if (is_selected[i])
          ghosts.push_back(static_cast<int>(globals[i]));
      layout.add_ghosts(ghosts);
      return layout;
    }
  } // namespace

  UnknownSelection::UnknownSelection(const UnknownLayout     &all,
                                     const std::vector<bool> &is_selected)
    : layout(layout_of(all, is_selected))
    , number(all.n_local(), -1)
  {
    for (unsigned int i = 0; i < all.n_local(); ++i)
      if (is_selected[i])
        {
          number[i] = unknowns.size();
          unknowns.push_back(i);
        }
  }
} // namespace auxfem
