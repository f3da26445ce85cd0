#ifndef auxfem_equations_element_batches_h
#define auxfem_equations_element_batches_h

#include <auxfem/mathematics/lanes.h>
#include <auxfem/state/state.h>

#include <algorithm>
#include <utility>

namespace auxfem
{
  /** Elements that are computed at a time. */
  struct ElementBatch
  {
    /** Behind the last element this one again. */
    EachLane<unsigned int> elements;
    /** How many there are without the repeated ones. */
    unsigned int size;

    /** From 0 on in the order of the elements. */
    unsigned int number() const
    {
      return elements[0] / n_lanes;
    }

    /** What @p value_of, a function of an element, gives for each. */
    template <class ElementFunction>
    auto each(const ElementFunction &value_of) const
    {
      EachLane<decltype(value_of(0u))> results;
      for (std::size_t lane = 0; lane < n_lanes; ++lane)
        results[lane] = value_of(elements[lane]);
      return results;
    }

    /** The same of a number. */
    template <class ElementFunction>
    Lanes numbers(const ElementFunction &value_of) const
    {
      return each_lane(
        [&](const auto lane) { return value_of(elements[lane]); });
    }
  };

  /** Calls @p action with batches of @p n_elements elements in their order. */
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

  /** @name Values of all local unknowns at those of an element, or of several. */
  ///@{
  /** Of unknown @p i of an element with @p unknowns. */
  inline double value_at(const double *values, const int *unknowns, const int i)
  {
    return values[unknowns[i]];
  }

  inline Lanes value_at(const double                *values,
                        const EachLane<const int *> &unknowns,
                        const int                    i)
  {
    return each_lane(
      [&](const auto lane) { return values[unknowns[lane][i]]; });
  }

  /** double or Lanes. */
  template <class Unknowns>
  using NumberAt =
    decltype(value_at(nullptr, std::declval<const Unknowns &>(), 0));

  /** By how much the displacement of unknown @p i is more than that of unknown
   * @p other, to the last digit of the difference, at a @p state with
   * compensation. */
  inline Lanes relative_displacement(const State                 &state,
                                     const EachLane<const int *> &unknowns,
                                     const int                    i,
                                     const int                    other)
  {
    const double *u = state.displacement.data(),
                 *c = state.compensation->data();
    return (value_at(u, unknowns, i) - value_at(u, unknowns, other)) +
      (value_at(c, unknowns, i) - value_at(c, unknowns, other));
  }

  /** Adds those of one @p lane of @p lane_values to @p values. */
  template <std::size_t n>
  void add_lane(const Lanes (&lane_values)[n],
                const std::size_t lane,
                const int        *unknowns,
                double           *values)
  {
    for (std::size_t i = 0; i < n; ++i)
      values[unknowns[i]] += number_in(lane_values[i], lane);
  }
  ///@}
} // namespace auxfem

#endif
