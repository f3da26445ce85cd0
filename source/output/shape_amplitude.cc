#include <auxfem/algebra/row_sums.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/output/shape_amplitude.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Largest extension of the lattice along an axis (m). */
    double extension(const Lattice &lattice)
    {
      const auto [lower, upper] = bounding_box(lattice);
      double largest            = 0;
      for (unsigned int d = 0; d < 3; ++d)
        largest = std::max(largest, upper[d] - lower[d]);
      return largest;
    }
  } // namespace

  double shape_amplitude(const Scene     &scene,
                         const Equations &equations,
                         const Vector    &shape)
  {
    const LatticeModel &model   = equations.model();
    const double        largest = model.numbering.layout().largest(
      largest_size(shape.data(), model.rows.free_translations));
    return largest > 0
      ? scene.modes.amplitude * extension(model.lattice) / largest
      : 1.;
  }
} // namespace auxfem
