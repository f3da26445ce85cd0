#include <auxfem/model/claimed_unknowns.h>
#include <auxfem/model/rigid_parts.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
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
    , is_of_rigid_part(joints_of_rigid_parts(lattice))
  {
    number_unknowns(mesh, ties);
    collect_local(mesh, ties);
  }

  void DofNumbering::number_unknowns(const StrutMesh &mesh, const Ties &ties)
  {
    const dealii::FE_Q<1> fe(polynomial_order);
    dealii::DoFHandler<1> nodes(mesh.triangulation());
    if (mesh.n_cells() > 0)
      nodes.distribute_dofs(fe);

    // Every node gets the numbers its joint has, if it lies at one, else those
    // of its own. Numbers are first counted apart for each rank (the rank whose
    // cell touches the unknown first owns it), then shifted to rank ranges.
    using Unknown = ClaimedUnknowns::Unknown;
    ClaimedUnknowns      claimed(lattice, ties, comm.NumProc());
    std::vector<Unknown> of_node(std::size_t(nodes.n_dofs()) * n_components());
    std::vector<const Unknown *> of_cell;
    of_cell.reserve(std::size_t(mesh.n_cells()) * fe.n_dofs_per_cell() *
                    n_components());

    std::vector<dealii::types::global_dof_index> of_this(fe.n_dofs_per_cell());
    for (const auto &cell : active_cells(nodes, mesh))
      {
        const StrutMesh::Place place = StrutMesh::place(cell);
        const int              rank  = cell->subdomain_id();
        cell->get_dof_indices(of_this);
        for (unsigned int node = 0; node < of_this.size(); ++node)
          {
            const bool at_joint = (node == 0 && place.begin == 0.) ||
              (node == 1 && place.end == 1.);
            Unknown *own =
              &of_node[std::size_t(of_this[node]) * n_components()];
            for (const unsigned int component : node_components)
              of_cell.push_back(
                at_joint ? claimed.claim_end(place.strut, node, component, rank)
                         : claimed.claim(*own++, rank));
          }
      }
    claimed.claim_joints(mesh);
    claimed.claim_rigid_parts();
    claimed.claim_hinges();
    take_numbers(claimed);

    cell_numbers.resize(of_cell.size());
    std::transform(of_cell.begin(),
                   of_cell.end(),
                   cell_numbers.begin(),
                   [&](const Unknown *unknown) {
                     return first_owned[unknown->owner] + unknown->number;
                   });
    for (unsigned int h = 0; h < of_hinge.size(); ++h)
      of_hinge[h].joint = ties.hinged[h].joint;
  }

  void DofNumbering::take_numbers(const ClaimedUnknowns &claimed)
  {
    first_owned.assign(1, 0);
    for (const int n_owned_by_rank : claimed.counts())
      first_owned.push_back(first_owned.back() + n_owned_by_rank);
    const auto global = [this](const ClaimedUnknowns::Unknown &unknown) {
      return unknown.owner < 0 ? -1
                               : first_owned[unknown.owner] + unknown.number;
    };
    const auto all_global = [&](const ClaimedUnknowns::Motion &unknowns) {
      MotionNumbers numbers;
      std::transform(unknowns.begin(), unknowns.end(), numbers.begin(), global);
      return numbers;
    };
    joint_numbers.reserve(lattice.joints.size());
    for (unsigned int joint = 0; joint < lattice.joints.size(); ++joint)
      joint_numbers.push_back(all_global(claimed.joint(joint)));
    for (const auto &[end, rotation] : claimed.released_ends())
      released_end_numbers[end] = all_global(rotation);
    for (const ClaimedUnknowns::RigidPartClaims &part : claimed.rigid_parts())
      {
        of_rigid_part.push_back(
          {part.clamped_joints, all_global(part.motion), {}});
        for (const ClaimedUnknowns::Unknown &multiplier : part.multipliers)
          of_rigid_part.back().multipliers.push_back(global(multiplier));
      }
    for (const auto &hinge : claimed.hinges())
      of_hinge.push_back(
        {invalid_index, {{global(hinge[0]), global(hinge[1])}}});
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
          {StrutMesh::place(cell), static_cast<unsigned int>(last_rank)});
      }
    for (const JointPair &pair : ties.connected)
      for (const unsigned int mine : {pair.first, pair.second})
        if (mine != invalid_index && is_mine(joint_numbers[mine][0]))
          for (const unsigned int other : {pair.first, pair.second})
            if (other != invalid_index)
              for (unsigned int component = 0; component < lattice.dimension;
                   ++component)
                keep(joint_numbers[other][component]);
    for (const std::vector<int> &numbers : coupled_numbers(ties))
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

    element_numbers.reserve(kept_cells.size() * n);
    for (const std::size_t c : kept_cells)
      for (unsigned int i = 0; i < n; ++i)
        element_numbers.push_back(local->LID(cell_numbers[c * n + i]));
    cell_numbers.clear();
    cell_numbers.shrink_to_fit();
    mark_rotations();
    index_multipliers();
    mark_prescribed(ties.prescribed);
    if (lattice.dimension == 3)
      index_rotations();
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

  unsigned int DofNumbering::spin_axis(const unsigned int local_number) const
  {
    const std::array<int, 3> &spins =
      rotations_in_space[rotation_of_unknown[local_number]];
    return std::find(spins.begin(), spins.end(), int(local_number)) -
      spins.begin();
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

  int DofNumbering::global_number(const unsigned int joint,
                                  const unsigned int component) const
  {
    return joint_numbers[joint][component];
  }

  int DofNumbering::end_rotation(const unsigned int strut,
                                 const unsigned int end,
                                 const unsigned int component) const
  {
    if (lattice.struts[strut].is_rigid())
      return -1;
    const auto           released = released_end_numbers.find({strut, end});
    const MotionNumbers &numbers  = released == released_end_numbers.end()
       ? joint_numbers[lattice.struts[strut].joints[end]]
       : released->second;
    return numbers[component] < 0 ? -1 : local->LID(numbers[component]);
  }

  UnknownKind DofNumbering::kind(const unsigned int local_number) const
  {
    return kinds[local_number];
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
