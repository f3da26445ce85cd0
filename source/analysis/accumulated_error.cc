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

  void AccumulatedError::serialize(const std::string &name,
                                   CheckpointArchive &archive)
  {
    archive.values(name, sum, slow, unbounded, largest);
    std::vector<double> values;
    for (const auto &[exponent, octave] : octaves)
      values.insert(values.end(),
                    {double(exponent), octave.error, octave.largest_amplitude});
    archive.list(name + ", octaves", values);
    octaves.clear();
    for (std::size_t i = 0; i < values.size(); i += 3)
      octaves[values[i]] = {values[i + 1], values[i + 2]};
  }
} // namespace auxfem
