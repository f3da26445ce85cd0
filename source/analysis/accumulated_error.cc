#include <auxfem/analysis/accumulated_error.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  void AccumulatedError::add(const LocalError &step)
  {
    sum = step.amplification * sum + step.size;
    slow += step.slow;
    if (step.oscillation)
      {
        Octave &octave = octaves[std::ilogb(step.oscillation->frequency)];
        octave.error += step.size;
        octave.largest_amplitude =
          std::max(octave.largest_amplitude, step.oscillation->amplitude);
      }
    else
      unbounded += step.size;
    largest = std::max(largest, total());
  }

  double AccumulatedError::total() const
  {
    double bounded = slow + unbounded;
    for (const auto &[exponent, octave] : octaves)
      bounded += std::min(octave.error, 2 * octave.largest_amplitude);
    return std::min(sum, bounded);
  }

  std::vector<double> AccumulatedError::values() const
  {
    std::vector<double> values = {sum, slow, unbounded, largest};
    for (const auto &[exponent, octave] : octaves)
      values.insert(values.end(),
                    {double(exponent), octave.error, octave.largest_amplitude});
    return values;
  }

  void AccumulatedError::restore(const std::vector<double> &values)
  {
    sum       = values.at(0);
    slow      = values.at(1);
    unbounded = values.at(2);
    largest   = values.at(3);
    octaves.clear();
    for (std::size_t i = 4; i + 2 < values.size(); i += 3)
      octaves[values[i]] = {values[i + 1], values[i + 2]};
  }
} // namespace auxfem
