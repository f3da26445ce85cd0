#include <auxfem/output/energy_judgement.h>
#include <auxfem/output/verdict_limits.h>
#include <auxfem/parameters/rounded_text.h>
#include <auxfem/time/moment_text.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace auxfem
{
  namespace
  {} // namespace

  EnergyJudgement::EnergyJudgement(const Kind kind) : kind(kind)
  {}

  void EnergyJudgement::start(const Energies &energies)
  {
    zero    = energies.balance(0.);
    initial = std::abs(energies.total());
  }

  bool EnergyJudgement::is_off(const Energies &energies) const
  {
    const double moved =
      initial + std::max(work, std::abs(energies.external()));
    return !(std::abs(energies.balance(zero)) <= doubtful_error * moved);
  }

  void EnergyJudgement::add(const Energies &energies,
                            const double    time,
                            const double    round_off)
  {
    // What is moved is what came in; energies grow with the error itself.
    work = std::max(work, std::abs(energies.external()));
    if (const double size = std::abs(energies.balance(zero));
        !(size <= round_off))
      error.add(size, time);
    given.add(-energies.numerical(), time);
    taken.add(energies.numerical(), time);
  }

  std::vector<Finding> EnergyJudgement::findings() const
  {
    std::vector<Finding> found;
    const double         moved = initial + work;
    if (!(error.value <= doubtful_error * moved))
      found.push_back(error_finding(moved));
    // Without inertia it is what the rates at the ends of steps leave open.
    if (kind == Kind::static_steps || kind == Kind::static_path)
      return found;
    if (given.value > doubtful_error * moved)
      found.push_back({Verdict::doubtful,
                       "The time integration has given the structure " +
                         percentage_text(given.value / moved) +
                         " of the energy that came in, by " +
                         moment_text(kind == Kind::static_path, given.time) +
                         "; shorten the step, or use a scheme that damps.",
                       given.time,
                       ""});
    if (taken.value > unusable_error * moved)
      found.push_back({Verdict::doubtful,
                       "The time integration has taken " +
                         percentage_text(taken.value / moved) +
                         " of the energy that came in, by " +
                         moment_text(kind == Kind::static_path, taken.time) +
                         "; shorten the step.",
                       taken.time,
                       ""});
    return found;
  }

  std::string EnergyJudgement::advice() const
  {
    switch (kind)
      {
        case Kind::static_path:
          return "; reduce Path/Resolution.";
        case Kind::static_steps:
          return "; shorten the step. If that does not help, the structure "
                 "jumps from one equilibrium to another, which only a "
                 "simulation with inertia follows.";
        case Kind::motion:
          return "; shorten the step, or set Time/Scheme = energy-momentum, "
                 "which keeps the balance whatever the step, in impacts too.";
        case Kind::reduced_cell:
          return "; shorten the step.";
      }
    return "";
  }

  Finding EnergyJudgement::error_finding(const double moved) const
  {
    const bool  is_ruinous = !(error.value <= unusable_error * moved);
    std::string text       = "Energy error ";
    text += moved > 0
      ? percentage_text(error.value / moved) + " of the energy that came in"
      : "where no energy came in";
    text += ", at " + moment_text(kind == Kind::static_path, error.time) +
      ": these results are ";
    text += is_ruinous ? "not reliable" : "doubtful";
    text += advice();
    return {is_ruinous ? Verdict::not_to_be_used : Verdict::doubtful,
            text,
            error.time,
            ""};
  }

  void EnergyJudgement::serialize(CheckpointArchive &archive)
  {
    archive.values("watch: energies", zero, initial, work, error, given, taken);
  }
} // namespace auxfem
