#include <auxfem/contact/effects/contact.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/supports.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/output/console.h>
#include <auxfem/output/notes.h>
#include <auxfem/output/verdict.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/step_ends.h>
#include <auxfem/state/step_report.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace auxfem
{
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

    /** The elastic strut of a section that is the thickest for its length. */
    struct ThickestStrut
    {
      unsigned int strut     = 0;
      double       thickness = 0, length = 1; ///< m

      double ratio() const
      {
        return thickness / length;
      }
    };

    /** By the number of the section in the file. */
    std::map<unsigned int, ThickestStrut>
    thickest_struts(const Scene &scene, const Lattice &lattice)
    {
      std::map<unsigned int, ThickestStrut> thickest;
      for (unsigned int i = 0; i < lattice.struts.size(); ++i)
        {
          const Strut &strut = lattice.struts[i];
          if (strut.is_rigid())
            continue;
          const SectionDefinition &definition = scene.sections[strut.section];
          const ThickestStrut      here       = {i,
                                                 thickness(definition.section,
                                                lattice.dimension),
                                                 lattice.length(strut)};
          if (ThickestStrut &known = thickest[definition.number];
              here.ratio() > known.ratio())
            known = here;
        }
      return thickest;
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
      for (const auto &[number, found] : thickest_struts(scene, model.lattice))
        {
          if (found.ratio() <= max_slender_ratio)
            continue;
          std::ostringstream note;
          note << scene.sections[number].path << ": strut " << found.strut
               << " is about " << found.thickness << " m thick, but only "
               << found.length
               << " m long; beam theory requires slender struts. ";
          if (found.ratio() / 1000 <= max_slender_ratio)
            note << "A number without a unit is in m; if you meant "
                 << found.thickness << " mm, add the unit. Otherwise check";
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
      for (std::size_t i = 0;
           i < std::min(max_listed_items, model.free_spins.size());
           ++i)
        text << (i > 0 ? ", " : "") << "strut "
             << model.free_spins[i].struts.front();
      if (model.free_spins.size() > max_listed_items)
        text << " and " << model.free_spins.size() - max_listed_items
             << " more";
      text << " could turn about "
           << (model.free_spins.size() > 1 ? "their own axes" : "its own axis")
           << " without resistance. Without inertia this rotation is fixed; it "
              "transmits no moment.";
      notes.push_back(text.str());
    }

    void add_unknown_fibres(const Scene &scene, std::vector<std::string> &notes)
    {
      std::set<unsigned int> seen;
      for (const SectionDefinition &definition : scene.sections)
        {
          const Section &section = definition.section;
          if (!seen.insert(definition.number).second)
            continue;
          if (!section.yield_strain || !section.outer_fibres.empty())
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

    void add_default_elements(const RunPlan            &plan,
                              std::vector<std::string> &notes)
    {
      if (plan.simulated.plasticity && plan.scene.discretization.is_default &&
          plan.analysis == Analysis::simulation)
        notes.push_back(
          "The struts have two elements of order 4 each, because the material "
          "yields: hinges form at the Gauss points next to the joints, and "
          "longer or lower elements overestimate the loads at which struts "
          "collapse. Discretization/Order and Global refinements change it.");
    }

    /** First pairs of struts and the number of further ones. */
    std::string
    pairs_text(const std::vector<std::array<unsigned int, 2>> &pairs)
    {
      std::ostringstream text;
      for (std::size_t i = 0; i < std::min(max_listed_items, pairs.size()); ++i)
        text << (i > 0 ? ", " : "") << pairs[i][0] << " and " << pairs[i][1];
      if (pairs.size() > max_listed_items)
        text << " and " << pairs.size() - max_listed_items << " more pairs";
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
                        " lie in each other at rest by more than half their "
                        "thickness, so they pass each other freely, as if "
                        "side by side. If this is unintended, check their "
                        "sections and their distance.");
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
    for (const MaterialDefinition &material : scene.materials)
      if (const std::string note = material.law ? material.law->note() : "";
          !note.empty())
        notes.push_back("Materials/" + material.name + ": " + note + ".");
    add_default_elements(plan, notes);
    if (equations.reporting().strut_contact != nullptr)
      add_overlaps(*equations.reporting().strut_contact, notes);
    return notes;
  }
} // namespace auxfem
