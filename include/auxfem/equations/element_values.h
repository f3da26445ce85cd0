#ifndef auxfem_equations_element_values_h
#define auxfem_equations_element_values_h

#include <auxfem/elements/lanes.h>

namespace auxfem
{
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
    return Lanes([&](const auto lane) { return values[unknowns[lane][i]]; });
  }

  /** double or Lanes. */
  template <class Unknowns>
  using NumberAt =
    decltype(value_at(nullptr, std::declval<const Unknowns &>(), 0));
  ///@}
} // namespace auxfem

#endif
