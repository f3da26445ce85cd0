#ifndef auxfem_loads_table_history_h
#define auxfem_loads_table_history_h

#include <auxfem/loads/time_function.h>

#include <vector>

namespace auxfem
{
  /**
   * The cubic spline through given points, with two continuous derivatives. Its
   * third derivative is continuous at the second point and the last but one,
   * too ("not a knot"; de Boor, A Practical Guide to Splines, ch. IV): it is of
   * fourth order up to the ends. Two points are joined by a line, three by a
   * parabola.
   */
  class CubicSpline
  {
  public:
    /** @param abscissas rising, as many as @p values; at least one. */
    CubicSpline(std::vector<double> abscissas, std::vector<double> values);

    /** Value and derivatives at @p x; beyond the points the last cubic. */
    Jet operator()(double x) const;

  private:
    std::vector<double> x, y;
    std::vector<double> slopes; ///< first derivatives at the points
  };
} // namespace auxfem

#endif
