#include <auxfem/analysis/watched_part.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** Fewer do not stand for all. */
    constexpr unsigned int least_unknowns = 2048, most_parts = 16;

    unsigned int number_of_parts(const Equations &equations)
    {
      return equations.is_linear()
        ? std::clamp<unsigned int>(equations.unknowns().layout.n_global() /
                                     least_unknowns,
                                   1,
                                   most_parts)
        : 1;
    }

    std::string record_of(const std::string &name)
    {
      return name + ", part of the unknowns";
    }
  } // namespace

  WatchedPart::WatchedPart(const Equations   &equations,
                           const unsigned int n_steps)
    : layout(equations.unknowns().layout)
    , n(number_of_parts(equations))
    , n_steps(n_steps)
  {}

  bool WatchedPart::passes_on()
  {
    if (n == 1 || n_done++ < n_steps)
      return false;
    n_done = 1;
    part   = (part + 1) % n;
    return true;
  }

  void WatchedPart::save(const std::string &name, Records &records) const
  {
    records.keep(record_of(name),
                 {double(part), double(n_done), double(layout.n_ranks())});
  }

  bool WatchedPart::resume(const std::string &name, const Records &records)
  {
    const std::vector<double> values = records.values(record_of(name), 3);
    part                             = values[0];
    n_done                           = values[1];
    return values[2] == layout.n_ranks();
  }
} // namespace auxfem
