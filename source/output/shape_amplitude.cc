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
      dealii::Point<3> lower = lattice.joints.front(), upper = lower;
      for (const dealii::Point<3> &joint : lattice.joints)
        for (unsigned int d = 0; d < 3; ++d)
          {
            lower[d] = std::min(lower[d], joint[d]);
            upper[d] = std::max(upper[d], joint[d]);
          }
      double largest = 0;
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
    double              largest = 0;
    for (const int i : model.rows.free_translations)
      largest = std::max(largest, std::abs(shape[i]));
    largest = model.numbering.layout().largest(largest);
    return largest > 0
      ? scene.modes.amplitude * extension(model.lattice) / largest
      : 1.;
  }
} // namespace auxfem
