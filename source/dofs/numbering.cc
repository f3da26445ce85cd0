#include <auxfem/dofs/numbering.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <algorithm>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** For local DoF i of @p fe: its place node * components + component in our order. */
    std::vector<unsigned int>
    node_major_order(const dealii::FiniteElement<1, 3> &fe)
    {
      std::vector<unsigned int> order(fe.n_dofs_per_cell());
      for (unsigned int i = 0; i < order.size(); ++i)
        {
          const auto [component, node] = fe.system_to_component_index(i);
          order[i]                     = node * fe.n_components() + component;
        }
      return order;
    }

    /** Active cells of @p container on @p mesh, which may have none. */
    template <class Container>
    auto active_cells(const Container &container, const StrutMesh &mesh)
    {
      using Range = decltype(container.active_cell_iterators());
      return mesh.n_cells() > 0 ? container.active_cell_iterators()
                                : Range(container.end(), container.end());
    }
  } // namespace

  DofNumbering::DofNumbering(const Lattice     &lattice,
                             const StrutMesh   &mesh,
                             const unsigned int order,
                             const Ties        &ties,
                             const MPI_Comm     communicator)
    : lattice(lattice)
    , polynomial_order(order)
    , node_components(lattice.dimension == 2
                        ? std::vector<unsigned int>{0, 1, rotation_z}
                        : std::vector<unsigned int>{0, 1, 2, 3, 4, 5})
    , comm(communicator)
  {
    number_unknowns(mesh, ties);
    collect_local(mesh, ties);
  }

  void DofNumbering::number_unknowns(const StrutMesh &mesh, const Ties &ties)
  {
    const dealii::FESystem<1, 3> fe(dealii::FE_Q<1, 3>(polynomial_order),
                                    n_components());
    dealii::DoFHandler<1, 3>     dof_handler(mesh.triangulation());
    if (mesh.n_cells() > 0)
      dof_handler.distribute_dofs(fe);

    const std::vector<unsigned int> our_place = node_major_order(fe);
    const unsigned int              n         = our_place.size();

    // Every node gets the number its joint has, if it lies at one, else one of
    // its own. Numbers are first counted apart for each rank (the rank whose
    // cell touches the unknown first owns it), then shifted to rank ranges.
    struct Unknown
    {
      int owner = -1, number = -1;
    };
    std::vector<Unknown> of_dof(dof_handler.n_dofs());
    using Motion = std::array<Unknown, n_motion_components>;
    std::vector<Motion>                of_joint(lattice.joints.size());
    std::vector<std::array<Motion, 2>> of_end(lattice.struts.size());
    std::vector<const Unknown *>       of_cell(std::size_t(mesh.n_cells()) * n);
    std::vector<int>                   count(comm.NumProc(), 0);
    const auto claim = [&count](Unknown &unknown, const int rank) {
      if (unknown.owner < 0)
        unknown = {rank, count[rank]++};
      return &unknown;
    };

    std::vector<dealii::types::global_dof_index> dofs(n);
    for (const auto &cell : active_cells(dof_handler, mesh))
      {
        const unsigned int      c     = cell->active_cell_index();
        const StrutMesh::Place &place = mesh.place(c);
        const Strut            &strut = lattice.struts[place.strut];
        const int               rank  = cell->subdomain_id();
        cell->get_dof_indices(dofs);
        std::vector<dealii::types::global_dof_index> ordered(n);
        for (unsigned int i = 0; i < n; ++i)
          ordered[our_place[i]] = dofs[i];
        for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int node      = i / n_components(),
                               component = node_components[i % n_components()];
            const bool at_joint          = (node == 0 && place.begin == 0.) ||
              (node == 1 && place.end == 1.);
            Unknown *unknown = &of_dof[ordered[i]];
            if (at_joint && component >= first_rotation &&
                ties.released[place.strut][node])
              unknown = &of_end[place.strut][node][component];
            else if (at_joint)
              unknown = &of_joint[strut.joints[node]][component];
            of_cell[std::size_t(c) * n + i] = claim(*unknown, rank);
          }
      }
    const auto claim_displacements = [&](const unsigned int joint,
                                         const int          rank) {
      for (unsigned int component = 0; component < lattice.dimension;
           ++component)
        claim(of_joint[joint][component], rank);
    };
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      if (lattice.struts[s].is_rigid())
        for (const unsigned int joint : lattice.struts[s].joints)
          claim_displacements(joint, mesh.rank(s));
    // A joint without struts (a mass on connectors) has displacements only.
    for (unsigned int joint = 0; joint < of_joint.size(); ++joint)
      claim_displacements(joint, 0);

    std::vector<std::vector<Unknown>> of_part(lattice.rigid_parts.size());
    of_rigid_part.resize(lattice.rigid_parts.size());
    for (unsigned int p = 0; p < of_part.size(); ++p)
      {
        const RigidPart &part = lattice.rigid_parts[p];
        if (part.clamps_struts)
          for (const unsigned int joint : part.joints)
            if (of_joint[joint][rotation_z].owner >= 0)
              of_rigid_part[p].clamped_joints.push_back(joint);
        of_part[p].resize(2 * part.joints.size() - 3 +
                          of_rigid_part[p].clamped_joints.size());
        for (Unknown &multiplier : of_part[p])
          claim(multiplier, of_joint[part.joints[0]][0].owner);
      }

    first_owned.assign(1, 0);
    for (const int n_owned_by_rank : count)
      first_owned.push_back(first_owned.back() + n_owned_by_rank);
    const auto global = [this](const Unknown &unknown) {
      return unknown.owner < 0 ? -1
                               : first_owned[unknown.owner] + unknown.number;
    };

    cell_numbers.resize(of_cell.size());
    std::transform(of_cell.begin(),
                   of_cell.end(),
                   cell_numbers.begin(),
                   [&](const Unknown *unknown) { return global(*unknown); });
    const auto all_global = [&](const Motion &unknowns) {
      MotionNumbers numbers;
      std::transform(unknowns.begin(), unknowns.end(), numbers.begin(), global);
      return numbers;
    };
    for (const Motion &joint : of_joint)
      joint_numbers.push_back(all_global(joint));
    constexpr MotionNumbers nothing = {{-1, -1, -1, -1, -1, -1}};
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      {
        std::array<MotionNumbers, 2> numbers;
        for (unsigned int end = 0; end < 2; ++end)
          numbers[end] = lattice.struts[s].is_rigid() ? nothing
            : ties.released[s][end]
            ? all_global(of_end[s][end])
            : joint_numbers[lattice.struts[s].joints[end]];
        end_rotation_numbers.push_back(numbers);
      }
    for (unsigned int p = 0; p < of_part.size(); ++p)
      for (const Unknown &multiplier : of_part[p])
        of_rigid_part[p].multipliers.push_back(global(multiplier));
  }

  void DofNumbering::collect_local(const StrutMesh &mesh, const Ties &ties)
  {
    const int my_rank = comm.MyPID();
    const int begin = first_owned[my_rank], end = first_owned[my_rank + 1];
    const unsigned int n = (polynomial_order + 1) * n_components();
    const auto is_mine   = [=](const int g) { return g >= begin && g < end; };

    std::vector<int> rows(end - begin);
    for (int i = 0; i < end - begin; ++i)
      rows[i] = begin + i;
    owned = std::make_unique<Epetra_Map>(-1, rows.size(), rows.data(), 0, comm);

    std::vector<bool> is_known(n_unknowns(), false);
    const auto        keep = [&](const int g) {
      if (g >= 0 && !is_mine(g) && !is_known[g])
        {
          is_known[g] = true;
          rows.push_back(g);
        }
    };
    std::vector<std::size_t> kept_cells;
    for (const auto &cell : active_cells(mesh.triangulation(), mesh))
      {
        const std::size_t c       = cell->active_cell_index();
        const int        *numbers = &cell_numbers[c * n];
        if (std::none_of(numbers, numbers + n, is_mine))
          continue;
        std::for_each(numbers, numbers + n, keep);
        kept_cells.push_back(c);
        // The rank of the last node owns an unknown of the element, so it
        // keeps the element; the rank of the cell may not.
        const int last_rank = std::upper_bound(first_owned.begin(),
                                               first_owned.end(),
                                               numbers[n - 1]) -
          first_owned.begin() - 1;
        element_list.push_back(
          {mesh.place(c), static_cast<unsigned int>(last_rank)});
      }
    for (const JointPair &pair : ties.connected)
      for (const unsigned int mine : {pair.first, pair.second})
        if (mine != invalid_index && is_mine(joint_numbers[mine][0]))
          for (const unsigned int other : {pair.first, pair.second})
            if (other != invalid_index)
              for (unsigned int component = 0; component < lattice.dimension;
                   ++component)
                keep(joint_numbers[other][component]);
    const std::vector<std::vector<int>> coupled = coupled_rotations(ties);
    for (const std::vector<int> &numbers : coupled)
      if (std::any_of(numbers.begin(), numbers.end(), is_mine))
        std::for_each(numbers.begin(), numbers.end(), keep);

    for (unsigned int p = 0; p < of_rigid_part.size(); ++p)
      {
        const std::vector<int> numbers = rigid_part_numbers(p);
        if (std::none_of(numbers.begin(), numbers.end(), is_mine))
          continue;
        std::for_each(numbers.begin(), numbers.end(), keep);
        kept_rigid_parts.push_back(p);
      }

    local = std::make_unique<Epetra_Map>(-1, rows.size(), rows.data(), 0, comm);
    import = std::make_unique<Epetra_Import>(*local, *owned);
    kinds.assign(rows.size(), UnknownKind::translation);
    rotations.assign(rows.size(), false);
    const auto mark_rotation = [this](const int l) {
      kinds[l]     = UnknownKind::rotation;
      rotations[l] = true;
    };

    element_numbers.reserve(kept_cells.size() * n);
    for (const std::size_t c : kept_cells)
      for (unsigned int i = 0; i < n; ++i)
        {
          const int l = local->LID(cell_numbers[c * n + i]);
          element_numbers.push_back(l);
          if (node_components[i % n_components()] >= first_rotation)
            mark_rotation(l);
        }
    for (const std::vector<int> &numbers : coupled)
      for (const int g : numbers)
        if (const int l = local->LID(g); l >= 0)
          mark_rotation(l);
    cell_numbers.clear();
    cell_numbers.shrink_to_fit();
    index_rigid_parts();
    if (lattice.dimension == 3)
      index_rotations(coupled);
  }

  std::vector<int>
  DofNumbering::rigid_part_numbers(const unsigned int rigid_part) const
  {
    const RigidPartUnknowns &unknowns = of_rigid_part[rigid_part];
    std::vector<int>         numbers  = unknowns.multipliers;
    for (const unsigned int joint : lattice.rigid_parts[rigid_part].joints)
      for (unsigned int component = 0; component < 2; ++component)
        numbers.push_back(joint_numbers[joint][component]);
    for (const unsigned int joint : unknowns.clamped_joints)
      numbers.push_back(joint_numbers[joint][rotation_z]);
    return numbers;
  }

  void DofNumbering::index_rigid_parts()
  {
    for (const unsigned int p : kept_rigid_parts)
      {
        for (const int global : of_rigid_part[p].multipliers)
          {
            kept_multipliers.push_back(local->LID(global));
            kinds[kept_multipliers.back()] = UnknownKind::multiplier;
          }
        for (const unsigned int joint : of_rigid_part[p].clamped_joints)
          {
            const int rotation  = joint_unknown(joint, rotation_z);
            kinds[rotation]     = UnknownKind::rotation;
            rotations[rotation] = true;
          }
      }
  }

  std::vector<std::vector<int>>
  DofNumbering::coupled_rotations(const Ties &ties) const
  {
    if (ties.sprung_joints.empty())
      return {};
    std::vector<std::vector<int>> at_joint(lattice.joints.size());
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      for (unsigned int end = 0; end < 2; ++end)
        for (const unsigned int component : node_components)
          if (component >= first_rotation)
            at_joint[lattice.struts[s].joints[end]].push_back(
              end_rotation_numbers[s][end][component]);
    std::vector<std::vector<int>> coupled;
    for (const unsigned int joint : ties.sprung_joints)
      coupled.push_back(at_joint[joint]);
    return coupled;
  }

  void
  DofNumbering::index_rotations(const std::vector<std::vector<int>> &coupled)
  {
    rotation_of_unknown.assign(n_local(), -1);
    const auto add = [this](const std::array<int, 3> &spins) {
      if (spins[0] < 0 || rotation_of_unknown[spins[0]] >= 0)
        return;
      for (const int spin : spins)
        rotation_of_unknown[spin] = rotations_in_space.size();
      rotations_in_space.push_back(spins);
    };
    for (std::size_t i = 0; i < element_numbers.size(); i += n_components())
      add({{element_numbers[i + 3],
            element_numbers[i + 4],
            element_numbers[i + 5]}});
    for (const std::vector<int> &numbers : coupled)
      for (std::size_t i = 0; i < numbers.size(); i += 3)
        add({{local->LID(numbers[i]),
              local->LID(numbers[i + 1]),
              local->LID(numbers[i + 2])}});
  }

  unsigned int DofNumbering::order() const
  {
    return polynomial_order;
  }

  unsigned int DofNumbering::n_components() const
  {
    return node_components.size();
  }

  const std::vector<unsigned int> &DofNumbering::components() const
  {
    return node_components;
  }

  const std::vector<std::array<int, 3>> &DofNumbering::spatial_rotations() const
  {
    return rotations_in_space;
  }

  int DofNumbering::spatial_rotation(const unsigned int local_number) const
  {
    return rotation_of_unknown.empty() ? -1 : rotation_of_unknown[local_number];
  }

  unsigned int DofNumbering::n_unknowns() const
  {
    return first_owned.back();
  }

  unsigned int DofNumbering::n_owned() const
  {
    return owned->NumMyElements();
  }

  unsigned int DofNumbering::n_local() const
  {
    return local->NumMyElements();
  }

  unsigned int DofNumbering::rank() const
  {
    return comm.MyPID();
  }

  unsigned int DofNumbering::n_ranks() const
  {
    return comm.NumProc();
  }

  const Epetra_MpiComm &DofNumbering::communicator() const
  {
    return comm;
  }

  const Epetra_Map &DofNumbering::owned_map() const
  {
    return *owned;
  }

  const Epetra_Map &DofNumbering::local_map() const
  {
    return *local;
  }

  const Epetra_Import &DofNumbering::importer() const
  {
    return *import;
  }

  const std::vector<DofNumbering::Element> &DofNumbering::elements() const
  {
    return element_list;
  }

  bool DofNumbering::is_owned(const Element &element) const
  {
    return element.owner == rank();
  }

  bool DofNumbering::is_owned(const int local_number) const
  {
    return local_number >= 0 && local_number < static_cast<int>(n_owned());
  }

  bool DofNumbering::is_rotation(const unsigned int local_number) const
  {
    return rotations[local_number];
  }

  const int *DofNumbering::element_unknowns(const unsigned int e) const
  {
    return &element_numbers[std::size_t(e) * (polynomial_order + 1) *
                            n_components()];
  }

  int DofNumbering::joint_unknown(const unsigned int joint,
                                  const unsigned int component) const
  {
    const int global = joint_numbers[joint][component];
    return global < 0 ? -1 : local->LID(global);
  }

  bool DofNumbering::joint_has(const unsigned int joint,
                               const unsigned int component) const
  {
    return joint_numbers[joint][component] >= 0;
  }

  int DofNumbering::end_rotation(const unsigned int strut,
                                 const unsigned int end,
                                 const unsigned int component) const
  {
    const int global = end_rotation_numbers[strut][end][component];
    return global < 0 ? -1 : local->LID(global);
  }

  int DofNumbering::multiplier(const unsigned int rigid_part,
                               const unsigned int number) const
  {
    return local->LID(of_rigid_part[rigid_part].multipliers[number]);
  }

  unsigned int DofNumbering::n_multipliers(const unsigned int rigid_part) const
  {
    return of_rigid_part[rigid_part].multipliers.size();
  }

  const std::vector<unsigned int> &
  DofNumbering::clamped_joints(const unsigned int rigid_part) const
  {
    return of_rigid_part[rigid_part].clamped_joints;
  }

  const std::vector<unsigned int> &DofNumbering::rigid_parts() const
  {
    return kept_rigid_parts;
  }

  const std::vector<int> &DofNumbering::multipliers() const
  {
    return kept_multipliers;
  }

  unsigned int DofNumbering::n_multipliers() const
  {
    unsigned int sum = 0;
    for (const RigidPartUnknowns &part : of_rigid_part)
      sum += part.multipliers.size();
    return sum;
  }

  UnknownKind DofNumbering::kind(const unsigned int local_number) const
  {
    return kinds[local_number];
  }

  void DofNumbering::prescribe(const unsigned int local_number)
  {
    kinds[local_number] = UnknownKind::prescribed;
  }

  OwnedRows DofNumbering::owned_rows() const
  {
    OwnedRows rows;
    for (unsigned int i = 0; i < n_owned(); ++i)
      if (kinds[i] == UnknownKind::multiplier)
        rows.multipliers.push_back(i);
      else if (kinds[i] == UnknownKind::prescribed)
        (rotations[i] ? rows.prescribed_rotations
                      : rows.prescribed_translations)
          .push_back(i);
      else
        (rotations[i] ? rows.free_rotations : rows.free_translations)
          .push_back(i);
    return rows;
  }

  unsigned int DofNumbering::n_free() const
  {
    int mine = 0, all = 0;
    for (unsigned int i = 0; i < n_owned(); ++i)
      mine += (kinds[i] == UnknownKind::translation ||
               kinds[i] == UnknownKind::rotation);
    comm.SumAll(&mine, &all, 1);
    return all;
  }

} // namespace auxfem
