#ifndef auxfem_tests_verification_vertex_h
#define auxfem_tests_verification_vertex_h

#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** Extremum of a curve. */
    struct Vertex
    {
      double position, height;
    };

    /**
     * Vertex of the parabola through the three @p values at @p middle - @p step,
     * @p middle and @p middle + @p step.
     */
    inline Vertex vertex_of_parabola(const double               middle,
                                     const double               step,
                                     const std::vector<double> &values)
    {
      const double slope     = (values.at(2) - values.at(0)) / 2;
      const double curvature = values.at(2) - 2 * values.at(1) + values.at(0);
      const double x         = -slope / curvature;
      return {middle + x * step, values.at(1) + slope / 2 * x};
    }
  } // namespace testing_support
} // namespace auxfem

#endif
