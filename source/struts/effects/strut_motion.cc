#include <auxfem/model/load_history.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/effects/strut_motion.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** Gauss-Lobatto points in [-1, 1], ascending, by order. */
    const std::vector<double> &nodes_of(const unsigned int order)
    {
      static const std::vector<std::vector<double>> nodes_by_order = [] {
        std::vector<std::vector<double>> nodes;
        for (int p = 1; p <= std::max(largest_plane_order, largest_space_order);
             ++p)
          {
            nodes.push_back(LineRule(p).nodes);
            std::sort(nodes.back().begin(), nodes.back().end());
          }
        return nodes;
      }();
      return nodes_by_order[order - 1];
    }

    /** Lagrange polynomials through @p nodes at @p x. */
    std::vector<double> shape_values(const std::vector<double> &nodes,
                                     const double               x)
    {
      std::vector<double> values(nodes.size(), 1.);
      for (unsigned int a = 0; a < nodes.size(); ++a)
        for (unsigned int b = 0; b < nodes.size(); ++b)
          if (b != a)
            values[a] *= (x - nodes[b]) / (nodes[a] - nodes[b]);
      return values;
    }

    /** Calls @p act(node along the strut, local unknowns) for the nodes of a
     * strut; nodes between elements come twice. */
    template <class Act>
    void for_each_node(const DofNumbering &numbering,
                       const unsigned int  first_element,
                       const unsigned int  n_elements,
                       const Act          &act)
    {
      const unsigned int order = numbering.elements()[first_element].order;
      for (unsigned int i = 0; i < n_elements; ++i)
        for (unsigned int a = 0; a <= order; ++a)
          act(i * order + position_along(a, order),
              numbering.element_unknowns(first_element + i) +
                a * numbering.n_components());
    }

    /** Calls @p act with each pair of nodal values and state vector that both
     * have. */
    template <class Motion, class StateType, class Act>
    void for_each_field(Motion &motion, StateType &state, const Act &act)
    {
      act(motion.displacement, state.displacement);
      if (state.velocity)
        act(motion.velocity, *state.velocity);
      if (state.acceleration)
        act(motion.acceleration, *state.acceleration);
    }

    /** Rotation at a point with shape values @p N of an element whose nodes
     * begin at @p first. */
    Quaternion rotation_at(const Quaternion          *first,
                           const std::vector<double> &N)
    {
      const SpaceVector from_end_to_end =
        rotation_vector(conjugate(first[0]) * first[N.size() - 1]);
      const Quaternion middle = first[0] * exponential(0.5 * from_end_to_end);
      SpaceVector      psi;
      for (unsigned int a = 0; a < N.size(); ++a)
        psi += N[a] * rotation_vector(conjugate(middle) * first[a]);
      return normalized(middle * exponential(psi));
    }
  } // namespace

  StrutMotion motion_of_strut(const DofNumbering &numbering,
                              const State        &state,
                              const unsigned int  first_element)
  {
    const DofNumbering::Element &element = numbering.elements()[first_element];
    const unsigned int           n       = numbering.n_components();
    StrutMotion                  motion;
    motion.order = element.order;
    motion.n_elements =
      numbering.divisions()[element.interval.strut].n_elements;
    motion.time = time_of_loads(state);
    for_each_field(motion, state, [&](auto &node_values, const auto & /*all*/) {
      node_values.resize(std::size_t(n) * motion.n_nodes());
    });
    if (!state.rotations.empty())
      motion.rotations.resize(motion.n_nodes());
    for_each_node(
      numbering,
      first_element,
      motion.n_elements,
      [&](const unsigned int node, const int *unknowns) {
        for_each_field(motion, state, [&](auto &node_values, const auto &all) {
          for (unsigned int c = 0; c < n; ++c)
            node_values[node * n + c] = all[unknowns[c]];
        });
        if (!state.rotations.empty())
          motion.rotations[node] =
            state
              .rotations[numbering.rotations().with(unknowns[first_rotation])];
      });
    return motion;
  }

  StrutMotion interpolated(const StrutMotion  &motion,
                           const StrutDivision division)
  {
    const auto [order, n_elements] = division;
    StrutMotion result             = motion;
    result.order                   = order;
    result.n_elements              = n_elements;
    const unsigned int n = motion.displacement.size() / motion.n_nodes();
    using Field          = std::vector<double> StrutMotion::*;
    const std::vector<Field>          fields = {&StrutMotion::displacement,
                                                &StrutMotion::velocity,
                                                &StrutMotion::acceleration};
    for (const Field field : fields)
      if (!(motion.*field).empty())
        (result.*field).assign(std::size_t(n) * result.n_nodes(), 0.);
    if (!motion.rotations.empty())
      result.rotations.resize(result.n_nodes());

    const std::vector<double> &new_nodes = nodes_of(order);
    for (unsigned int node = 0; node < result.n_nodes(); ++node)
      {
        const unsigned int new_element = std::min(node / order, n_elements - 1);
        // Position in units of the old element length.
        const double place =
          (new_element + (1 + new_nodes[node - new_element * order]) / 2) *
          motion.n_elements / n_elements;
        const unsigned int old_element =
          std::min<unsigned int>(place, motion.n_elements - 1);
        const std::vector<double> N =
          shape_values(nodes_of(motion.order), 2 * (place - old_element) - 1);
        const unsigned int first = old_element * motion.order;
        for (const Field field : fields)
          if (!(motion.*field).empty())
            for (unsigned int a = 0; a < N.size(); ++a)
              for (unsigned int c = 0; c < n; ++c)
                (result.*field)[node * n + c] +=
                  N[a] * (motion.*field)[(first + a) * n + c];
        if (!motion.rotations.empty())
          result.rotations[node] = rotation_at(&motion.rotations[first], N);
      }
    return result;
  }

  void set_motion_of_strut(const DofNumbering &numbering,
                           const unsigned int  first_element,
                           const StrutMotion  &motion,
                           State              &state)
  {
    const unsigned int n = numbering.n_components();
    AssertDimension(numbering.elements()[first_element].order, motion.order);
    for_each_node(
      numbering,
      first_element,
      motion.n_elements,
      [&](const unsigned int node, const int *unknowns) {
        for_each_field(motion, state, [&](const auto &node_values, auto &all) {
          for (unsigned int c = 0; c < n; ++c)
            all[unknowns[c]] = node_values[node * n + c];
        });
        if (!state.rotations.empty())
          state
            .rotations[numbering.rotations().with(unknowns[first_rotation])] =
            motion.rotations[node];
      });
  }
} // namespace auxfem
