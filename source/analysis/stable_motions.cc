#include <auxfem/analysis/stable_motions.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    const std::string stable_record =
                        "error of small displacements, stable motions",
                      strut_record = stable_record + " by strut";

    /** By which nothing buckles: a thousand struts in a row. */
    constexpr double no_compression = 1e-6;
  } // namespace

  StableMotions::StableMotions(const SmallDisplacementEstimate &estimate,
                               const UnknownLayout             &layout)
    : estimate(estimate)
    , layout(layout)
    , compressions(estimate.struts().size(), 0.)
  {}

  bool StableMotions::have(const double                  size,
                           const SmallDisplacementError &now) const
  {
    if (!(size <= largest_size && now.compression <= largest_compression))
      return false;
    bool are_mine = true;
    for (std::size_t i = 0; i < compressions.size() && are_mine; ++i)
      are_mine =
        now.compressions[i] <= std::max(compressions[i], little_compression);
    return layout.largest(are_mine ? 0. : 1.) == 0;
  }

  void StableMotions::trust(const double                  times,
                            const double                  size,
                            const SmallDisplacementError &looked_at)
  {
    largest_size = times * size;
    largest_compression =
      times * std::max(looked_at.compression, no_compression);
    for (std::size_t i = 0; i < compressions.size(); ++i)
      compressions[i] = times * looked_at.compressions[i];
  }

  void StableMotions::save(Records &records) const
  {
    records.keep(stable_record, {largest_size, largest_compression});
    records.keep(strut_record, estimate.struts(), 1, compressions);
  }

  void StableMotions::resume(const Records &records)
  {
    const std::vector<double> values = records.values(stable_record, 2);
    largest_size                     = values[0];
    largest_compression              = values[1];
    compressions = records.values(strut_record, estimate.struts(), 1);
  }
} // namespace auxfem
