#ifndef auxfem_loads_table_history_h
#define auxfem_loads_table_history_h

#include <auxfem/loads/time_function.h>

#include <vector>

namespace auxfem
{
  /**
   * Cubic interpolation spline with not-a-knot end conditions (de Boor, A
   * Practical Guide to Splines, ch. IV), of fourth order up to the ends. Two
   * points are joined by a line, three by a parabola.
   */
  class CubicSpline
  {
  public:
    /** @param abscissas in ascending order, as many as @p values, at least one */
    CubicSpline(std::vector<double> abscissas, std::vector<double> values);

    /** Value and derivatives at @p x; the end cubics extend beyond the points. */
    Jet operator()(double x) const;

  private:
    std::vector<double> x, y;
    std::vector<double> slopes; ///< first derivatives at the points
  };
} // namespace auxfem

#endif
