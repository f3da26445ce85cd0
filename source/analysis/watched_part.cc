#include <auxfem/analysis/watched_part.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** Fewer do not stand for all. */
    constexpr unsigned int least_unknowns = 512, least_turns = 4;

    constexpr double most_parts = 16;

    /** @param n_turns in the run */
    unsigned int number_of_parts(const Equations &equations,
                                 const double     n_turns)
    {
      if (!equations.is_linear())
        return 1;
      const double of_unknowns =
        equations.unknowns().layout.n_global() / least_unknowns;
      return std::clamp(std::min(of_unknowns, n_turns / least_turns),
                        1.,
                        most_parts);
    }

    std::string record_of(const std::string &name)
    {
      return name + ", part of the unknowns";
    }
  } // namespace

  WatchedPart::WatchedPart(const Scene       &scene,
                           const Equations   &equations,
                           const unsigned int n_steps,
                           const double       time)
    : layout(equations.unknowns().layout)
    , n(number_of_parts(equations,
                        scene.time.end_time /
                          std::max(n_steps * scene.time.step, time)))
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
    records.keep(record_of(name),
                 {double(part),
                  double(n_done),
                  elapsed,
                  double(layout.n_ranks()),
                  double(n)});
  }

  bool WatchedPart::resume(const std::string &name, const Records &records)
  {
    const std::vector<double> values = records.values(record_of(name), 5);
    // There may be more of them now that the run shall go on for longer.
    if (values[4] != n)
      return false;
    part    = values[0];
    n_done  = values[1];
    elapsed = values[2];
    return values[3] == layout.n_ranks();
  }
} // namespace auxfem
