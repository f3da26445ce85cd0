#include <auxfem/algebra/strut_condensation.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Positions of the unknowns of two consecutive nodes. */
    constexpr int in_order[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  } // namespace

  StrutCondensation::StrutCondensation(const TangentMatrix &matrix)
    : tangent(matrix)
  {}

  const SparseMatrix &StrutCondensation::matrix() const
  {
    return system->matrix();
  }

  const Unknowns &StrutCondensation::joints() const
  {
    return system->unknowns();
  }

  void StrutCondensation::update_pattern()
  {
    const TangentPattern &pattern = tangent.pattern();
    if (system && built_version == tangent.version())
      return;
    system.reset();
    struts        = find_strut_elements(pattern);
    system        = std::make_unique<JointSystem>(pattern, struts);
    built_version = tangent.version();

    const Unknowns &unknowns = pattern.unknowns();
    prescribed_unknowns.clear();
    for (unsigned int i = 0; i < unknowns.layout.n_owned(); ++i)
      if (unknowns.kinds[i] == UnknownKind::prescribed)
        prescribed_unknowns.push_back(i);
    prescribed_blocks.clear();
    for (std::size_t b = 0; b < pattern.n_blocks(); ++b)
      if (std::any_of(pattern.begin(b), pattern.end(b), [&](const int i) {
            return i >= 0 && unknowns.kinds[i] == UnknownKind::prescribed;
          }))
        prescribed_blocks.push_back(b);
  }

  std::size_t StrutCondensation::node_size(const StrutElements &elements) const
  {
    return elements.node->factor_size(symmetry_of_nodes());
  }

  std::size_t
  StrutCondensation::factors_size(const StrutElements &elements) const
  {
    std::size_t size = 0;
    if (elements.between_nodes != nullptr)
      size +=
        elements.n_elements * elements.between_nodes->factor_size(symmetry);
    if (elements.n_elements > 1)
      size += (elements.n_elements - 1) * node_size(elements);
    return size;
  }

  FactorizationOutcome
  StrutCondensation::condense(const Symmetry requested_symmetry)
  {
    update_pattern();
    symmetry = requested_symmetry;
    system->reset(symmetry);
    first_factor.assign(1, 0);
    for (const StrutElements &elements : struts)
      first_factor.push_back(first_factor.back() + factors_size(elements));
    factors.resize(first_factor.back());

    Room                 room;
    unsigned long        n_negative = 0, n_inner = 0;
    const StrutElements *failed = nullptr;
    for (std::size_t s = 0; s < struts.size() && failed == nullptr; ++s)
      {
        if (!condense_strut(struts[s],
                            factors.data() + first_factor[s],
                            room,
                            n_negative))
          failed = &struts[s];
        else
          system->add_strut(s, room.strut.data());
        n_inner += struts[s].n_elements * struts[s].n_between_nodes() +
          (struts[s].n_elements - 1) * struts[s].n_node_unknowns;
      }

    // All ranks report the last of the failed struts.
    const UnknownLayout &layout = tangent.pattern().unknowns().layout;
    const double last = layout.largest(failed != nullptr ? failed->strut : -1.);
    inertia.reset();
    failure_place.clear();
    if (last >= 0)
      {
        failure_place = "the inside of strut " +
          std::to_string(static_cast<unsigned int>(last));
        const bool is_finite = failed == nullptr || has_finite_entries(*failed);
        return layout.largest(is_finite ? 0. : 1.) > 0
          ? FactorizationOutcome::not_finite
          : FactorizationOutcome::singular;
      }
    system->add_others(tangent);
    keep_prescribed_entries();
    const std::vector<double> sums =
      layout.sum(std::vector<double>{double(n_negative), double(n_inner)});
    Inertia total;
    total.negative = sums[0];
    determinant    = determinant_sign(total);
    // Without symmetry n_negative has only the parity of the determinant's
    // sign.
    if (symmetry != Symmetry::none)
      {
        total.positive = sums[1] - sums[0];
        inertia        = total;
      }
    return FactorizationOutcome::done;
  }

  bool
  StrutCondensation::has_finite_entries(const StrutElements &elements) const
  {
    const std::size_t   n = elements.n_element_unknowns;
    std::vector<double> room;
    const auto          are_finite = [](const double *begin, std::size_t size) {
      return std::all_of(begin, begin + size, [](const double value) {
        return std::isfinite(value);
      });
    };
    for (unsigned int e = 0; e < elements.n_elements; ++e)
      {
        const std::size_t  block    = elements.first_block + e;
        const int *const   unknowns = tangent.pattern().begin(block);
        const unsigned int c        = elements.n_node_unknowns;
        if (!are_finite(tangent.values(block), n * n))
          return false;
        // Another rank may own the strut's first node.
        const double *added_values = e > 0 ? added(unknowns, c, room) : nullptr;
        if (added_values != nullptr && !are_finite(added_values, c))
          return false;
        added_values = added(unknowns + 2 * c, n - 2 * c, room);
        if (added_values != nullptr && !are_finite(added_values, n - 2 * c))
          return false;
      }
    return true;
  }

  const double *StrutCondensation::added(const int           *unknowns,
                                         const unsigned int   n,
                                         std::vector<double> &room) const
  {
    if (tangent.added_diagonal().empty())
      return nullptr;
    room.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      room[i] = tangent.added_diagonal()[unknowns[i]];
    return room.data();
  }

  bool StrutCondensation::condense_strut(const StrutElements &elements,
                                         double              *strut_factors,
                                         Room                &room,
                                         unsigned long       &n_negative) const
  {
    for (unsigned int e = 0; e < elements.n_elements; ++e)
      {
        const std::size_t block = elements.first_block + e;
        EliminationResult result =
          condense_element(elements, block, strut_factors, room);
        n_negative += result.n_negative;
        if (!result.is_regular)
          return false;
        if (elements.between_nodes != nullptr)
          strut_factors += elements.between_nodes->factor_size(symmetry);
        if (e == 0)
          room.strut = room.element;
        else
          {
            result = eliminate_node(elements, block, strut_factors, room);
            n_negative += result.n_negative;
            if (!result.is_regular)
              return false;
            strut_factors += node_size(elements);
          }
      }
    return true;
  }

  EliminationResult
  StrutCondensation::condense_element(const StrutElements &elements,
                                      const std::size_t    block,
                                      double              *element_factors,
                                      Room                &room) const
  {
    const unsigned int n_ends  = 2 * elements.n_node_unknowns,
                       n       = elements.n_element_unknowns;
    const double *const values = tangent.values(block);
    room.element.resize(n_ends * n_ends);
    if (elements.between_nodes != nullptr)
      return elements.between_nodes->eliminate(
        values,
        added(tangent.pattern().begin(block) + n_ends, n - n_ends, room.inner),
        symmetry,
        element_factors,
        room.element.data());
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        room.element[i * n + j] = symmetry == Symmetry::enforced
          ? (values[i * n + j] + values[j * n + i]) / 2
          : values[i * n + j];
    return {};
  }

  EliminationResult
  StrutCondensation::eliminate_node(const StrutElements &elements,
                                    const std::size_t    block,
                                    double              *node_factors,
                                    Room                &room) const
  {
    // Order of the nodes around the eliminated one: first node of the strut,
    // last node of the element, this node. The strut so far couples the first
    // and third, the element the third and second.
    const unsigned int c = elements.n_node_unknowns, n = 3 * c;
    room.around_node.assign(n * n, 0.);
    const auto spread = [&](const std::vector<double>         &part,
                            const std::array<unsigned int, 2> &nodes) {
      for (unsigned int i = 0; i < 2 * c; ++i)
        for (unsigned int j = 0; j < 2 * c; ++j)
          room.around_node[(nodes[i / c] * c + i % c) * n + nodes[j / c] * c +
                           j % c] += part[i * 2 * c + j];
    };
    spread(room.strut, {{0, 2}});
    spread(room.element, {{2, 1}});
    return elements.node->eliminate(room.around_node.data(),
                                    added(tangent.pattern().begin(block),
                                          c,
                                          room.inner),
                                    symmetry_of_nodes(),
                                    node_factors,
                                    room.strut.data());
  }

  void StrutCondensation::keep_prescribed_entries()
  {
    prescribed_entries.clear();
    for (const std::size_t b : prescribed_blocks)
      {
        const std::size_t n = tangent.pattern().size(b);
        prescribed_entries.insert(prescribed_entries.end(),
                                  tangent.values(b),
                                  tangent.values(b) + n * n);
      }
  }

  void StrutCondensation::move_prescribed(std::vector<double> &values) const
  {
    const Unknowns      &unknowns      = tangent.pattern().unknowns();
    const UnknownLayout &layout        = unknowns.layout;
    const auto           is_prescribed = [&](const int unknown) {
      return unknown >= 0 && unknowns.kinds[unknown] == UnknownKind::prescribed;
    };
    const bool moves = std::any_of(prescribed_unknowns.begin(),
                                   prescribed_unknowns.end(),
                                   [&](const int i) { return values[i] != 0; });
    if (layout.largest(moves) == 0)
      return;
    std::vector<double> prescribed(layout.n_local(), 0.);
    for (const int i : prescribed_unknowns)
      prescribed[i] = values[i];
    layout.update_ghosts(prescribed.data());
    const double *block = prescribed_entries.data();
    for (const std::size_t b : prescribed_blocks)
      {
        const int *const  block_unknowns = tangent.pattern().begin(b);
        const std::size_t n              = tangent.pattern().size(b);
        for (unsigned int i = 0; i < n; ++i)
          if (layout.is_owned(block_unknowns[i]) &&
              !is_prescribed(block_unknowns[i]))
            for (unsigned int j = 0; j < n; ++j)
              if (is_prescribed(block_unknowns[j]))
                values[block_unknowns[i]] -=
                  block[i * n + j] * prescribed[block_unknowns[j]];
        block += n * n;
      }
  }

  void StrutCondensation::reduce(std::vector<double> &values,
                                 std::vector<double> &g) const
  {
    move_prescribed(values);
    g.assign(system->unknowns().layout.n_local(), 0.);
    Room room;
    for (std::size_t s = 0; s < struts.size(); ++s)
      {
        const StrutElements &elements      = struts[s];
        const double *const  strut_factors = factors.data() + first_factor[s];
        if (elements.n_elements > 1)
          reduce_chain(elements,
                       strut_factors,
                       values,
                       system->ends(s),
                       g,
                       room);
        else if (elements.between_nodes != nullptr)
          elements.between_nodes->reduce(strut_factors,
                                         symmetry,
                                         inner_unknowns(elements, 0),
                                         values.data(),
                                         system->ends(s),
                                         g.data());
      }
    system->add_ghosts_to_owners(g);
    const std::vector<int> &retained = system->retained_unknowns();
    const int               n_owned  = system->unknowns().layout.n_owned();
    for (int k = 0; k < n_owned; ++k)
      g[k] += values[retained[k]];
    for (const int k : system->prescribed())
      if (k < n_owned)
        g[k] = values[retained[k]];
  }

  const int *StrutCondensation::inner_unknowns(const StrutElements &elements,
                                               const unsigned int   e) const
  {
    return tangent.pattern().begin(elements.first_block + e) +
      2 * elements.n_node_unknowns;
  }

  void StrutCondensation::reduce_chain(const StrutElements &elements,
                                       const double        *strut_factors,
                                       std::vector<double> &values,
                                       const int           *ends,
                                       std::vector<double> &g,
                                       Room                &room) const
  {
    const unsigned int c = elements.n_node_unknowns;
    room.strut.assign(2 * c, 0.);
    for (unsigned int e = 0; e < elements.n_elements; ++e)
      {
        room.element.assign(2 * c, 0.);
        if (elements.between_nodes != nullptr)
          {
            elements.between_nodes->reduce(strut_factors,
                                           symmetry,
                                           inner_unknowns(elements, e),
                                           values.data(),
                                           in_order,
                                           room.element.data());
            strut_factors += elements.between_nodes->factor_size(symmetry);
          }
        if (e == 0)
          {
            room.strut = room.element;
            continue;
          }
        const int *const node =
          tangent.pattern().begin(elements.first_block + e);
        for (unsigned int i = 0; i < c; ++i)
          {
            values[node[i]] += room.strut[c + i] + room.element[i];
            room.strut[c + i] = room.element[c + i];
          }
        elements.node->reduce(strut_factors,
                              symmetry_of_nodes(),
                              node,
                              values.data(),
                              in_order,
                              room.strut.data());
        strut_factors += node_size(elements);
      }
    for (unsigned int i = 0; i < 2 * c; ++i)
      g[ends[i]] += room.strut[i];
  }

  void StrutCondensation::expand(std::vector<double> &z,
                                 std::vector<double> &values) const
  {
    system->unknowns().layout.update_ghosts(z.data());
    const std::vector<int> &retained = system->retained_unknowns();
    for (std::size_t k = 0; k < retained.size(); ++k)
      values[retained[k]] = z[k];
    // The right-hand side of the inside already contains the motion of
    // prescribed ends.
    for (const int k : system->prescribed())
      z[k] = 0;

    Room room;
    for (std::size_t s = 0; s < struts.size(); ++s)
      {
        const StrutElements &elements      = struts[s];
        const double *const  strut_factors = factors.data() + first_factor[s];
        if (elements.n_elements > 1)
          expand_chain(elements,
                       strut_factors,
                       values,
                       system->ends(s),
                       z,
                       room);
        else if (elements.between_nodes != nullptr)
          elements.between_nodes->expand(strut_factors,
                                         inner_unknowns(elements, 0),
                                         values.data(),
                                         system->ends(s),
                                         z.data());
      }
    tangent.pattern().unknowns().layout.update_ghosts(values.data());
  }

  void StrutCondensation::expand_chain(const StrutElements       &elements,
                                       const double              *strut_factors,
                                       std::vector<double>       &values,
                                       const int                 *ends,
                                       const std::vector<double> &z,
                                       Room                      &room) const
  {
    const unsigned int c                = elements.n_node_unknowns,
                       n_elements       = elements.n_elements;
    const std::size_t n_element_factors = elements.between_nodes != nullptr
      ? elements.between_nodes->factor_size(symmetry)
      : 0;
    const std::size_t n_node_factors    = node_size(elements);
    // Substitutes in reverse order of elimination.
    std::vector<double> &node_values = room.around_node;
    node_values.resize((n_elements + 1) * c);
    for (unsigned int i = 0; i < c; ++i)
      {
        node_values[i]                  = z[ends[i]];
        node_values[n_elements * c + i] = z[ends[c + i]];
      }
    room.element.resize(2 * c);
    for (unsigned int e = n_elements - 1; e > 0; --e)
      {
        const int *const node =
          tangent.pattern().begin(elements.first_block + e);
        std::copy_n(node_values.begin(), c, room.element.begin());
        std::copy_n(node_values.begin() + (e + 1) * c,
                    c,
                    room.element.begin() + c);
        elements.node->expand(strut_factors + (e + 1) * n_element_factors +
                                (e - 1) * n_node_factors,
                              node,
                              values.data(),
                              in_order,
                              room.element.data());
        for (unsigned int i = 0; i < c; ++i)
          node_values[e * c + i] = values[node[i]];
      }
    if (elements.between_nodes == nullptr)
      return;
    for (unsigned int e = 0; e < n_elements; ++e)
      elements.between_nodes->expand(strut_factors + e * n_element_factors +
                                       (e > 0 ? (e - 1) * n_node_factors : 0),
                                     inner_unknowns(elements, e),
                                     values.data(),
                                     in_order,
                                     &node_values[e * c]);
  }
} // namespace auxfem
