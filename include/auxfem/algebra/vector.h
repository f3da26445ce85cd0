#ifndef auxfem_algebra_vector_h
#define auxfem_algebra_vector_h

#include <algorithm>
#include <cmath>
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

  /** Multiplies all @p values by @p factor. */
  inline void scale(const double factor, Vector &values)
  {
    for (double &value : values)
      value *= factor;
  }

  /** Largest |value|; zero if there are none. */
  inline double largest_size(const Vector &x)
  {
    double result = 0;
    for (const double value : x)
      result = std::max(result, std::abs(value));
    return result;
  }
} // namespace auxfem

#endif
