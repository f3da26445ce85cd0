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
                           const unsigned int n_steps,
                           const double       time)
    : layout(equations.unknowns().layout)
    , n(number_of_parts(equations))
    , n_steps(n_steps)
    , time(time)
  {}

  bool WatchedPart::passes_on(const double dt)
  {
    if (n == 1)
      return false;
    const bool passes = n_done >= n_steps && elapsed >= time;
    if (passes)
      {
        n_done  = 0;
        elapsed = 0;
        part    = (part + 1) % n;
      }
    ++n_done;
    elapsed += dt;
    return passes;
  }

  void WatchedPart::save(const std::string &name, Records &records) const
  {
    records.keep(
      record_of(name),
      {double(part), double(n_done), elapsed, double(layout.n_ranks())});
  }

  bool WatchedPart::resume(const std::string &name, const Records &records)
  {
    const std::vector<double> values = records.values(record_of(name), 4);
    part                             = values[0];
    n_done                           = values[1];
    elapsed                          = values[2];
    return values[3] == layout.n_ranks();
  }
} // namespace auxfem
