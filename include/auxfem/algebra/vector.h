#ifndef auxfem_algebra_vector_h
#define auxfem_algebra_vector_h

#include <vector>

namespace auxfem
{
  /** Values at all local unknowns of an UnknownLayout: owned, then ghosts. */
  using Vector = std::vector<double>;

  /** Adds @p factor times @p x to @p y. */
  inline void add_multiple(const double factor, const Vector &x, Vector &y)
  {
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] += factor * x[i];
  }
} // namespace auxfem

#endif
