#include <auxfem/algebra/joint_system.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** Marks the unknowns that no rank eliminates. Collective. */
    std::vector<bool> find_retained(const TangentPattern             &pattern,
                                    const std::vector<StrutElements> &struts)
    {
      const Unknowns     &unknowns = pattern.unknowns();
      std::vector<double> is_retained(unknowns.layout.n_local(), 1.);
      for (const StrutElements &elements : struts)
        for (std::size_t b = elements.first_block;
             b < elements.first_block + elements.n_elements;
             ++b)
          for (const int *i = pattern.begin(b); i != pattern.end(b); ++i)
            if (unknowns.strut[*i])
              is_retained[*i] = 0;
      unknowns.layout.update_ghosts(is_retained.data());
      return std::vector<bool>(is_retained.begin(), is_retained.end());
    }
  } // namespace

  JointSystem::JointSystem(const TangentPattern             &pattern,
                           const std::vector<StrutElements> &struts)
    : struts(struts)
    , selection(
        std::make_unique<UnknownSelection>(pattern.unknowns().layout,
                                           find_retained(pattern, struts)))
    , joint_unknowns(selection->layout)
    , n_ends(2 * pattern.unknowns().components.size())
  {
    for (const StrutElements &elements : struts)
      {
        const int *const first = pattern.begin(elements.first_block);
        const int *const last =
          pattern.begin(elements.first_block + elements.n_elements - 1);
        for (unsigned int i = 0; i < elements.n_node_unknowns; ++i)
          end_unknowns.push_back(selection->number[first[i]]);
        for (unsigned int i = 0; i < elements.n_node_unknowns; ++i)
          end_unknowns.push_back(
            selection->number[last[elements.n_node_unknowns + i]]);
      }
    positions_to_send.resize(struts.size());
    if (selection->layout.n_ranks() > 1)
      {
        find_neighbours();
        share_struts();
        share_ends();
      }
    make_unknowns(pattern.unknowns());
    make_assembly(pattern);
  }

  void JointSystem::find_neighbours()
  {
    const UnknownLayout &layout = selection->layout;
    for (std::size_t s = 0; s < struts.size(); ++s)
      for (std::size_t i = 0; i < n_ends; ++i)
        {
          const int end = ends(s)[i];
          if (layout.is_owned(end))
            continue;
          Neighbour &neighbour = neighbours[layout.owner(layout.global(end))];
          if (neighbour.struts.empty() || neighbour.struts.back() != s)
            neighbour.struts.push_back(s);
          neighbour.ghosts.push_back(end);
        }
    for (auto &[rank, neighbour] : neighbours)
      {
        std::vector<int> &ghosts = neighbour.ghosts;
        std::sort(ghosts.begin(), ghosts.end());
        ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
      }
  }

  void JointSystem::share_struts()
  {
    UnknownLayout   &layout = selection->layout;
    ListsByRank<int> unknowns;
    std::size_t      n_to_send = 0;
    for (const auto &[rank, neighbour] : neighbours)
      for (const std::size_t s : neighbour.struts)
        {
          for (std::size_t i = 0; i < n_ends; ++i)
            unknowns[rank].push_back(layout.global(ends(s)[i]));
          positions_to_send[s].push_back(n_to_send);
          n_to_send += n_ends * n_ends;
        }
    to_send.resize(n_to_send);
    const auto received_lists = exchange_lists(unknowns, layout.communicator());
    block_exchange            = NeighbourExchange(layout.communicator(),
                                       lengths(unknowns, n_ends),
                                       lengths(received_lists, n_ends));

    // Joints at the far ends may be new ghosts.
    const std::vector<int> globals = concatenated(received_lists);
    layout.add_ghosts(globals);
    for (const int global : globals)
      received_unknowns.push_back(layout.local(global));
  }

  void JointSystem::share_ends()
  {
    const UnknownLayout &layout = selection->layout;
    ListsByRank<int>     globals;
    for (const auto &[rank, neighbour] : neighbours)
      for (const int ghost : neighbour.ghosts)
        globals[rank].push_back(layout.global(ghost));
    const auto received_lists = exchange_lists(globals, layout.communicator());
    end_exchange              = NeighbourExchange(layout.communicator(),
                                     lengths(globals),
                                     lengths(received_lists));
    for (const int global : concatenated(received_lists))
      received_ends.push_back(layout.local(global));
  }

  void JointSystem::make_unknowns(const Unknowns &all)
  {
    const UnknownLayout &layout = selection->layout;
    // New ghosts are missing in the pattern's layout: exchange the properties
    // as values.
    const auto fill = [&](const auto &value, const auto &assign) {
      std::vector<double> values(layout.n_local());
      for (unsigned int i = 0; i < layout.n_owned(); ++i)
        values[i] = static_cast<double>(value(selection->unknowns[i]));
      layout.update_ghosts(values.data());
      for (unsigned int i = 0; i < layout.n_local(); ++i)
        assign(i, static_cast<unsigned int>(values[i]));
    };
    joint_unknowns = Unknowns(layout);
    fill([&](const int i) { return all.kinds[i]; },
         [&](const unsigned int i, const unsigned int value) {
           joint_unknowns.kinds[i] = static_cast<UnknownKind>(value);
         });
    fill([&](const int i) { return all.is_rotation[i]; },
         [&](const unsigned int i, const unsigned int value) {
           joint_unknowns.is_rotation[i] = value != 0;
         });
    // Zero means none.
    fill([&](const int i) { return all.strut[i] ? *all.strut[i] + 1. : 0.; },
         [&](const unsigned int i, const unsigned int value) {
           if (value > 0)
             joint_unknowns.strut[i] = value - 1;
         });
    fill([&](const int i) { return all.joint[i]; },
         [&](const unsigned int i, const unsigned int value) {
           joint_unknowns.joint[i] = value;
         });
    fill([&](const int i) { return all.component[i]; },
         [&](const unsigned int i, const unsigned int value) {
           joint_unknowns.component[i] = value;
         });
    joint_unknowns.positions  = all.positions;
    joint_unknowns.components = all.components;
    joint_unknowns.length     = all.length;
    for (unsigned int i = 0; i < layout.n_local(); ++i)
      if (joint_unknowns.kinds[i] == UnknownKind::prescribed)
        prescribed_unknowns.push_back(i);
  }

  void JointSystem::make_assembly(const TangentPattern &pattern)
  {
    std::vector<std::size_t> first(1, 0);
    std::vector<int>         unknowns;
    const auto               append = [&](const int unknown) {
      unknowns.push_back(
        unknown >= 0 && joint_unknowns.kinds[unknown] != UnknownKind::prescribed
          ? unknown
          : -1);
    };
    const auto append_struts = [&](const std::vector<int> &all_ends) {
      for (std::size_t i = 0; i < all_ends.size(); i += n_ends)
        {
          for (std::size_t k = 0; k < n_ends; ++k)
            append(all_ends[i + k]);
          first.push_back(unknowns.size());
        }
    };
    append_struts(end_unknowns);
    append_struts(received_unknowns);

    const auto is_retained = [&](const int unknown) {
      return unknown < 0 || selection->number[unknown] >= 0;
    };
    for (std::size_t b = 0; b < pattern.n_blocks(); ++b)
      if (std::all_of(pattern.begin(b), pattern.end(b), is_retained))
        {
          other_blocks.push_back(b);
          for (const int *i = pattern.begin(b); i != pattern.end(b); ++i)
            append(*i < 0 ? -1 : selection->number[*i]);
          first.push_back(unknowns.size());
        }
    assembly =
      std::make_unique<SparseAssembly>(selection->layout, first, unknowns);
  }

  const SparseMatrix &JointSystem::matrix() const
  {
    return assembly->matrix();
  }

  const std::vector<int> &JointSystem::retained_unknowns() const
  {
    return selection->unknowns;
  }

  void JointSystem::reset(const Symmetry symmetry)
  {
    assembly->reset(symmetry);
    for (unsigned int i = 0; i < selection->layout.n_owned(); ++i)
      if (joint_unknowns.kinds[i] == UnknownKind::prescribed)
        assembly->add_to_diagonal(i, 1.);
  }

  void JointSystem::add_strut(const std::size_t number, const double *block)
  {
    assembly->add(number, block);
    for (const std::size_t position : positions_to_send[number])
      std::copy(block, block + n_ends * n_ends, to_send.begin() + position);
  }

  void JointSystem::add_others(const TangentMatrix &matrix)
  {
    std::size_t next = struts.size();
    if (selection->layout.n_ranks() > 1)
      {
        const std::vector<double> received = block_exchange.exchange(to_send);
        for (std::size_t i = 0; i < received.size(); i += n_ends * n_ends)
          assembly->add(next++, received.data() + i);
      }
    for (const std::size_t block : other_blocks)
      assembly->add(next++, matrix.values(block));
    if (!matrix.added_diagonal().empty())
      for (unsigned int i = 0; i < selection->layout.n_owned(); ++i)
        if (joint_unknowns.kinds[i] != UnknownKind::prescribed)
          assembly->add_to_diagonal(
            i,
            matrix.added_diagonal()[selection->unknowns[i]]);
  }

  void JointSystem::add_ghosts_to_owners(std::vector<double> &values) const
  {
    if (selection->layout.n_ranks() == 1)
      return;
    std::vector<double> ghost_values;
    for (const auto &[rank, neighbour] : neighbours)
      for (const int ghost : neighbour.ghosts)
        ghost_values.push_back(values[ghost]);
    const std::vector<double> received = end_exchange.exchange(ghost_values);
    for (std::size_t i = 0; i < received.size(); ++i)
      values[received_ends[i]] += received[i];
  }
} // namespace auxfem
