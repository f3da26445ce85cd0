#ifndef auxfem_equations_element_batches_h
#define auxfem_equations_element_batches_h

#include <auxfem/mathematics/lanes.h>
#include <auxfem/state/state.h>

#include <algorithm>
#include <utility>

namespace auxfem
{
  /** Elements computed together in SIMD lanes. */
  struct ElementBatch
  {
    /** Element per lane; the last element fills unused lanes. */
    LaneArray<unsigned int> elements;
    /** Number of distinct elements. */
    unsigned int size;

    /** Number of the batch, from 0. */
    unsigned int number() const
    {
      return elements[0] / n_lanes;
    }

    /** Values of @p value_of, a function of an element, per lane. */
    template <class ElementFunction>
    auto each(const ElementFunction &value_of) const
    {
      LaneArray<decltype(value_of(0u))> results;
      for (std::size_t lane = 0; lane < n_lanes; ++lane)
        results[lane] = value_of(elements[lane]);
      return results;
    }

    /** As each(), for a number. */
    template <class ElementFunction>
    Lanes numbers(const ElementFunction &value_of) const
    {
      return make_lanes(
        [&](const auto lane) { return value_of(elements[lane]); });
    }
  };

  /** Calls @p action with consecutive batches of @p n_elements elements. */
  template <class Action>
  void for_each_batch(const unsigned int n_elements, const Action &action)
  {
    for (unsigned int first = 0; first < n_elements; first += n_lanes)
      {
        ElementBatch batch;
        batch.size = std::min<unsigned int>(n_lanes, n_elements - first);
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
          batch.elements[lane] = first + std::min(lane, batch.size - 1);
        action(batch);
      }
  }

  /** @name Gather and scatter between local unknowns and elements. */
  ///@{
  /** Value at unknown @p i of an element with @p unknowns. */
  inline double value_at(const double *values, const int *unknowns, const int i)
  {
    return values[unknowns[i]];
  }

  inline Lanes value_at(const double                 *values,
                        const LaneArray<const int *> &unknowns,
                        const int                     i)
  {
    return make_lanes(
      [&](const auto lane) { return values[unknowns[lane][i]]; });
  }

  /** double or Lanes. */
  template <class Unknowns>
  using NumberAt =
    decltype(value_at(nullptr, std::declval<const Unknowns &>(), 0));

  /**
   * Displacement of unknown @p i relative to unknown @p other. The compensation
   * of @p state keeps all digits of the difference.
   */
  inline Lanes relative_displacement(const State                  &state,
                                     const LaneArray<const int *> &unknowns,
                                     const int                     i,
                                     const int                     other)
  {
    const double *u = state.displacement.data(),
                 *c = state.compensation->data();
    return (value_at(u, unknowns, i) - value_at(u, unknowns, other)) +
      (value_at(c, unknowns, i) - value_at(c, unknowns, other));
  }

  /** Adds one @p lane of @p lane_values to @p values. */
  template <std::size_t n>
  void add_lane(const Lanes (&lane_values)[n],
                const std::size_t lane,
                const int        *unknowns,
                double           *values)
  {
    for (std::size_t i = 0; i < n; ++i)
      values[unknowns[i]] += lane_value(lane_values[i], lane);
  }
  ///@}
} // namespace auxfem

#endif
