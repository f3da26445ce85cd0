#include <auxfem/algebra/backward_error.h>
#include <auxfem/algebra/full_precision.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** By local unknown the largest |x| in its unit, over all ranks. */
    std::vector<double> largest_by_unit(const Unknowns            &unknowns,
                                        const std::vector<double> &x)
    {
      const auto is_multiplier = [&unknowns](const unsigned int i) {
        return unknowns.kinds[i] == UnknownKind::multiplier;
      };
      double motion = 0, force = 0;
      for (unsigned int i = 0; i < unknowns.layout.n_owned(); ++i)
        if (is_multiplier(i))
          force = std::max(force, std::abs(x[i]));
        else
          motion = std::max(motion, std::abs(x[i]) / unknowns.unit(i));
      motion = unknowns.layout.largest(motion);
      force  = unknowns.layout.largest(force);
      std::vector<double> result(unknowns.layout.n_local());
      for (unsigned int i = 0; i < result.size(); ++i)
        result[i] = is_multiplier(i) ? force : motion * unknowns.unit(i);
      return result;
    }
  } // namespace

  double backward_error(const TangentMatrix       &matrix,
                        const std::vector<double> &x,
                        const std::vector<double> &b,
                        const Symmetry             symmetry)
  {
    const TangentPattern     &pattern = matrix.pattern();
    const UnknownLayout      &layout  = pattern.unknowns().layout;
    std::vector<double>       image(layout.n_owned()), sizes(layout.n_owned());
    const std::vector<double> of_unit = largest_by_unit(pattern.unknowns(), x);
    matrix.multiply(x.data(), image.data(), symmetry);
    for (std::size_t block = 0; block < pattern.n_blocks(); ++block)
      {
        const int *const    of_block = pattern.begin(block);
        const unsigned int  n        = pattern.size(block);
        const double *const values   = matrix.values(block);
        for (unsigned int i = 0; i < n; ++i)
          if (layout.is_owned(of_block[i]))
            for (unsigned int j = 0; j < n; ++j)
              if (of_block[j] >= 0)
                sizes[of_block[i]] +=
                  std::abs(values[i * n + j]) * of_unit[of_block[j]];
      }
    double largest = 0;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      {
        double size = sizes[i] + std::abs(b[i]);
        if (pattern.unknowns().kinds[i] == UnknownKind::prescribed)
          size = std::abs(x[i]) + std::abs(b[i]);
        else if (!matrix.added_diagonal().empty())
          size += std::abs(matrix.added_diagonal()[i]) * of_unit[i];
        const double difference = std::abs(image[i] - b[i]);
        if (difference == 0)
          continue;
        const double error = difference / (size + least_of_full_precision);
        if (!std::isfinite(error))
          largest = std::numeric_limits<double>::infinity();
        largest = std::max(largest, error);
      }
    return layout.largest(largest);
  }
} // namespace auxfem
