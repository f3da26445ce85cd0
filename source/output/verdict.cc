#include <auxfem/contact/effects/contact.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/supports.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/output/console.h>
#include <auxfem/output/verdict.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/step_ends.h>
#include <auxfem/state/step_report.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  Finding nothing_computed(const double time)
  {
    return {
      Verdict::not_to_be_used,
      "The run ended before its first step was done: only the initial state "
      "exists.",
      time,
      ""};
  }

  Finding incomplete(const double time)
  {
    return {Verdict::doubtful,
            "The run is incomplete: it ended early. All results, "
            "including largest values, cover only the computed part.",
            time,
            ""};
  }

  Verdict verdict_of(const std::vector<Finding> &findings)
  {
    Verdict worst = Verdict::sound;
    for (const Finding &finding : findings)
      worst = std::max(worst, finding.verdict);
    return worst;
  }

  const std::string &name_of(const Verdict verdict)
  {
    static const std::array<std::string, 3> names = {
      {"sound", "doubtful", "not to be used"}};
    return names[static_cast<unsigned int>(verdict)];
  }

  void add_verdict(Json &summary, const std::vector<Finding> &findings)
  {
    Json warnings = Json::array();
    for (const Finding &finding : findings)
      {
        Json warning = {{"verdict", name_of(finding.verdict)},
                        {"text", finding.text},
                        {"time", finding.time}};
        if (!finding.location.empty())
          warning["location"] = finding.location;
        warnings.push_back(warning);
      }
    summary["verdict"]  = name_of(verdict_of(findings));
    summary["warnings"] = warnings;
  }

  std::string verdict_text(const std::vector<Finding> &findings)
  {
    std::string text = "Verdict: " + name_of(verdict_of(findings));
    for (const Finding &finding : findings)
      text += '\n' + indented(finding.text);
    return text;
  }

  EnergyJudgement::EnergyJudgement(const Kind kind) : kind(kind)
  {}

  void EnergyJudgement::start(const Energies &energies)
  {
    zero    = energies.balance(0.);
    initial = std::abs(energies.total());
  }

  bool EnergyJudgement::exceeds_balance_limit(const Energies &energies) const
  {
    const double energy_input =
      initial + std::max(work, std::abs(energies.external()));
    return !(std::abs(energies.balance(zero)) <= doubtful_error * energy_input);
  }

  void EnergyJudgement::add(const Energies &energies,
                            const double    time,
                            const double    round_off)
  {
    // The energy input is the reference, because energies grow with the error.
    work = std::max(work, std::abs(energies.external()));
    if (const double size = std::abs(energies.balance(zero));
        !(size <= round_off))
      error.add(size, time);
    energy_gain.add(-energies.numerical(), time);
    energy_loss.add(energies.numerical(), time);
  }

  std::vector<Finding> EnergyJudgement::findings() const
  {
    std::vector<Finding> found;
    const double         energy_input = initial + work;
    if (!(error.value <= doubtful_error * energy_input))
      found.push_back(error_finding(energy_input));
    // Without inertia numerical energy only reflects the rates at step ends.
    if (kind == Kind::static_steps || kind == Kind::static_path)
      return found;
    if (energy_gain.value > doubtful_error * energy_input)
      found.push_back(
        {Verdict::doubtful,
         "The time integration has added " +
           percentage_text(energy_gain.value / energy_input) +
           " of the energy that came in, by " +
           moment_text(kind == Kind::static_path, energy_gain.time) +
           "; shorten the step, or use a scheme that damps.",
         energy_gain.time,
         ""});
    if (energy_loss.value > unusable_error * energy_input)
      found.push_back(
        {Verdict::doubtful,
         "The time integration has taken " +
           percentage_text(energy_loss.value / energy_input) +
           " of the energy that came in, by " +
           moment_text(kind == Kind::static_path, energy_loss.time) +
           "; shorten the step.",
         energy_loss.time,
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

  Finding EnergyJudgement::error_finding(const double energy_input) const
  {
    const bool  is_unusable = !(error.value <= unusable_error * energy_input);
    std::string text        = "Energy error ";
    text += energy_input > 0 ? percentage_text(error.value / energy_input) +
        " of the energy that came in"
                             : "where no energy came in";
    text += ", at " + moment_text(kind == Kind::static_path, error.time) +
      ": these results are ";
    text += is_unusable ? "not reliable" : "doubtful";
    text += advice();
    return {is_unusable ? Verdict::not_to_be_used : Verdict::doubtful,
            text,
            error.time,
            ""};
  }

  void EnergyJudgement::serialize(CheckpointArchive &archive)
  {
    archive.values("watch: energies",
                   zero,
                   initial,
                   work,
                   error,
                   energy_gain,
                   energy_loss);
  }
} // namespace auxfem
