#include <auxfem/contact/effects/contact.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/supports.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/output/console.h>
#include <auxfem/output/verdict.h>
#include <auxfem/output/verdict_limits.h>
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

  namespace
  {
    /**
     * Thickness of a strut over its length above which a note is given.
     * @tuned judgement
     */
    constexpr double max_slender_ratio = 0.25;

    /**
     * Height (m) of the rectangle with equal area and second moment; in space
     * the larger one.
     */
    double thickness(const Section &section, const unsigned int dimension)
    {
      const double second_moment = dimension == 2
        ? section.second_moment_3
        : std::max(section.second_moment_2, section.second_moment_3);
      return std::sqrt(12 * second_moment / section.area);
    }

    /** The shortest elastic strut of a section. */
    struct ShortestStrut
    {
      unsigned int strut  = 0;
      double       length = std::numeric_limits<double>::infinity(); ///< m
    };

    std::vector<ShortestStrut> shortest_struts(const Lattice    &lattice,
                                               const std::size_t n_sections)
    {
      std::vector<ShortestStrut> shortest(n_sections);
      for (unsigned int i = 0; i < lattice.struts.size(); ++i)
        {
          const Strut &strut = lattice.struts[i];
          if (strut.is_rigid())
            continue;
          ShortestStrut &shortest_strut = shortest[strut.section];
          if (const double length = lattice.length(strut);
              length < shortest_strut.length)
            shortest_strut = {i, length};
        }
      return shortest;
    }

    void add_imperfections(const Lattice            &lattice,
                           std::vector<std::string> &notes)
    {
      if (!lattice.as_designed)
        return;
      double largest = 0;
      for (unsigned int i = 0; i < lattice.n_structural_joints(); ++i)
        largest =
          std::max(largest,
                   lattice.joints[i].distance(lattice.as_designed->joints[i]));
      std::ostringstream text;
      text << "Imperfections move joints of the stress-free lattice by up to "
           << largest << " m from the designed one.";
      notes.push_back(text.str());
    }

    /**
     * Adds notes on loads on prescribed unknowns, which only change reactions.
     */
    void add_loads_on_supports(const RunPlan            &plan,
                               const Lattice            &lattice,
                               std::vector<std::string> &notes)
    {
      std::set<std::pair<unsigned int, unsigned int>> prescribed;
      for (const JointMotion &motion : prescribed_motions(plan.scene, lattice))
        prescribed.insert({motion.joint, motion.component});
      for (const JointLoadDefinition &load : plan.joint_loads())
        {
          const auto joints = joints_of(load, lattice, plan.scene.context);
          const auto is_prescribed = [&](const unsigned int c) {
            return std::all_of(joints.begin(),
                               joints.end(),
                               [&](const unsigned int joint) {
                                 return prescribed.count({joint, c}) > 0;
                               });
          };
          for (unsigned int c = 0; c < load.components.size(); ++c)
            if (!load.components[c].is_zero() && !load.follows_joint &&
                is_prescribed(c))
              notes.push_back(
                load.components[c].origin() +
                " does nothing: supports prescribe the " +
                motion_name(c, lattice.dimension) +
                " of all its joints, so it only changes their reactions. Load "
                "joints that are free to move, or remove the load.");
        }
    }

    /** Adds a note if results are written among the user's scenes. */
    void add_inputs_beside_results(const std::string        &folder,
                                   std::vector<std::string> &notes)
    {
      namespace fs = std::filesystem;
      std::error_code ignored;
      std::string     inputs;
      for (const fs::directory_entry &entry :
           fs::directory_iterator(folder, ignored))
        if (const std::string name = entry.path().filename().string();
            entry.path().extension() == ".prm" && name != "original.prm" &&
            name != "parameters.prm")
          inputs += (inputs.empty() ? "" : ", ") + name;
      if (!inputs.empty())
        notes.push_back("Results are written among input files: the folder " +
                        folder + " has " + inputs +
                        ". Give the results their own folder with "
                        "Output/Directory or --output.");
    }

    void add_thick_sections(const Scene              &scene,
                            const LatticeModel       &model,
                            std::vector<std::string> &notes)
    {
      const Lattice                   &lattice = model.lattice;
      const std::vector<ShortestStrut> shortest =
        shortest_struts(lattice, scene.sections.size());
      for (unsigned int s = 0; s < scene.sections.size(); ++s)
        {
          const auto [strut, length] = shortest[s];
          const double found =
            thickness(scene.sections[s].section, lattice.dimension);
          if (found <= max_slender_ratio * length)
            continue;
          std::ostringstream note;
          note << scene.sections[s].path << ": the struts are about " << found
               << " m thick, but strut " << strut << " is only " << length
               << " m long; beam theory requires slender struts. ";
          if (found / 1000 <= max_slender_ratio * length)
            note << "A number without a unit is in m; if you meant " << found
                 << " mm, add the unit. Otherwise check";
          else
            note << "If this is unintended, check";
          note << " the dimensions of the section and the size of the "
                  "lattice.";
          notes.push_back(note.str());
        }
    }

    void add_fixed_spins(const LatticeModel       &model,
                         std::vector<std::string> &notes)
    {
      const bool is_static = !model.plan.simulated.inertia ||
        model.plan.time.static_start ||
        model.plan.analysis != Analysis::simulation;
      if (model.free_spins.empty() || !is_static)
        return;
      std::ostringstream text;
      text << "Between ball hinges ";
      for (std::size_t i = 0; i < std::min(n_listed, model.free_spins.size());
           ++i)
        text << (i > 0 ? ", " : "") << "strut "
             << model.free_spins[i].struts.front();
      if (model.free_spins.size() > n_listed)
        text << " and " << model.free_spins.size() - n_listed << " more";
      text << " could turn about "
           << (model.free_spins.size() > 1 ? "their own axes" : "its own axis")
           << " without resistance. Without inertia this rotation is fixed; it "
              "transmits no moment.";
      notes.push_back(text.str());
    }

    void add_unknown_fibres(const Scene &scene, std::vector<std::string> &notes)
    {
      for (const SectionDefinition &definition : scene.sections)
        {
          const Section &section = definition.section;
          if (!section.yield_strain || section.fibre_distances[1] > 0)
            continue;
          std::ostringstream text;
          text.precision(3);
          text
            << definition.path
            << ": the Yield strain is compared with the bending strain at the "
               "radius of gyration, "
            << section.radii_of_gyration()[1]
            << " m from the axis. The outermost fibre is further away and "
               "yields earlier. Give its distance as Extreme fibre.";
          notes.push_back(text.str());
        }
    }

    /** First pairs of struts and the number of further ones. */
    std::string
    pairs_text(const std::vector<std::array<unsigned int, 2>> &pairs)
    {
      std::ostringstream text;
      for (std::size_t i = 0; i < std::min(n_listed, pairs.size()); ++i)
        text << (i > 0 ? ", " : "") << pairs[i][0] << " and " << pairs[i][1];
      if (pairs.size() > n_listed)
        text << " and " << pairs.size() - n_listed << " more pairs";
      return text.str();
    }

    void add_overlaps(const StrutContact       &contact,
                      std::vector<std::string> &notes)
    {
      std::vector<std::array<unsigned int, 2>> passing, others;
      for (const StrutOverlap &overlap : contact.overlaps())
        (overlap.is_passing ? passing : others).push_back(overlap.struts);
      if (!passing.empty())
        notes.push_back("Struts " + pairs_text(passing) +
                        " cross at rest without a common joint, so they pass "
                        "each other freely, as if side by side. If they are "
                        "connected, give them a joint there.");
      if (!others.empty())
        notes.push_back(
          "Struts " + pairs_text(others) +
          " overlap at rest: their distance is below their thickness. They "
          "exert no contact forces where they overlap. If this is unintended, "
          "check their sections and their distance.");
    }
  } // namespace

  std::vector<std::string> notes_on(const Equations &equations)
  {
    const LatticeModel      &model = equations.model();
    const RunPlan           &plan  = model.plan;
    const Scene             &scene = plan.scene;
    std::vector<std::string> notes = model.lattice.notes;
    for (const std::string &note : plan.time.values_without_effect)
      notes.push_back(note);
    if (const std::optional<std::string> on_scheme =
          plan.time.scheme->note_on_rigid_parts();
        on_scheme && model.numbering.constraints().n_multipliers() > 0)
      notes.push_back(*on_scheme);
    for (const std::string &note : time_function_notes(plan))
      notes.push_back(note);
    add_imperfections(model.lattice, notes);
    add_thick_sections(scene, model, notes);
    add_loads_on_supports(plan, model.lattice, notes);
    add_inputs_beside_results(scene.output.directory, notes);
    add_fixed_spins(model, notes);
    add_unknown_fibres(scene, notes);
    if (equations.reporting().strut_contact != nullptr)
      add_overlaps(*equations.reporting().strut_contact, notes);
    return notes;
  }
} // namespace auxfem
