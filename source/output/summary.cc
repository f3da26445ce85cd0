#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/output/console.h>
#include <auxfem/output/figure_files.h>
#include <auxfem/output/summary.h>
#include <auxfem/parameters/text.h>
#include <auxfem/version.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    std::string current_date()
    {
      const std::time_t time = std::time(nullptr);
      std::tm           local{};
      localtime_r(&time, &local);
      char text[40];
      std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%S%z", &local);
      return text;
    }

    /** Number of elastic struts by a member of their division. */
    std::map<unsigned int, unsigned int>
    struts_by(unsigned int StrutDivision::*number, const Counts &counts)
    {
      std::map<unsigned int, unsigned int> result;
      for (const auto &[division, n] : counts.struts_of_division)
        result[division.*number] += n;
      return result;
    }

    Json json_of(const std::map<unsigned int, unsigned int> &struts)
    {
      Json json = Json::object();
      for (const auto &[number, n] : struts)
        json[std::to_string(number)] = n;
      return json;
    }

    Json json_of(const Counts &counts)
    {
      return {{"joints", counts.joints},
              {"struts", counts.struts},
              {"elements", counts.elements},
              {"struts_of_order",
               json_of(struts_by(&StrutDivision::order, counts))},
              {"struts_of_n_elements",
               json_of(struts_by(&StrutDivision::n_elements, counts))},
              {"connectors", counts.connectors},
              {"rigid_parts", counts.rigid_parts},
              {"unknowns", counts.unknowns},
              {"free_unknowns", counts.free_unknowns},
              {"constraints", counts.constraints},
              {"ranks", counts.ranks}};
    }

    /** Names of the sections in the file. */
    std::vector<std::string> names_of_sections(const Scene &scene)
    {
      std::vector<std::string> names;
      for (const SectionDefinition &section : scene.sections)
        if (section.number == names.size())
          names.push_back(section.name);
      return names;
    }

    Json json_of(const Work &totals)
    {
      return {{"steps", totals.steps},
              {"newton_iterations", totals.iterations},
              {"factorizations", totals.factorizations},
              {"shortened_increments", totals.shortened},
              {"linear_solutions", totals.linear_solutions},
              {"linear_iterations", totals.linear_iterations},
              {"retries", totals.retries},
              {"linear_solver", totals.linear_solver}};
    }

    Json wall_seconds(const Resources &resources)
    {
      return {{"program_start", resources.start.program},
              {"mpi_start", resources.start.mpi},
              {"setup", resources.wall.setup},
              {"residual", resources.wall.residual},
              {"tangent", resources.wall.tangent},
              {"factorize", resources.wall.factorize},
              {"solve", resources.wall.solve},
              {"contact_search", resources.wall.contact},
              {"output", resources.wall.output},
              {"checkpoints", resources.wall.checkpoints},
              {"total", resources.wall_seconds}};
    }

    std::string seconds(const double value)
    {
      char text[40];
      std::snprintf(text, sizeof(text), "%.2f s", value);
      return text;
    }

  } // namespace

  Counts count(const Equations &equations)
  {
    const DofNumbering         &numbering = equations.model().numbering;
    std::array<unsigned int, 2> local_counts{{0, 0}};
    for (const DofNumbering::Element &element : numbering.elements())
      local_counts[0] += element.is_owned;
    for (const ConnectorGroup &group : equations.reporting().connectors)
      local_counts[1] += group.forces->n_reported();
    MPI_Allreduce(MPI_IN_PLACE,
                  local_counts.data(),
                  local_counts.size(),
                  MPI_UNSIGNED,
                  MPI_SUM,
                  numbering.layout().communicator());

    Counts counts;
    counts.joints     = equations.model().lattice.n_structural_joints();
    counts.struts     = equations.model().lattice.struts.size();
    counts.elements   = local_counts[0];
    counts.connectors = local_counts[1];
    for (unsigned int s = 0; s < numbering.divisions().size(); ++s)
      if (!equations.model().lattice.struts[s].is_rigid())
        ++counts.struts_of_division[numbering.divisions()[s]];
    counts.rigid_parts   = equations.model().lattice.rigid_parts.size();
    counts.unknowns      = numbering.layout().n_global();
    counts.free_unknowns = numbering.unknowns().n_free();
    counts.constraints   = numbering.constraints().n_multipliers();
    counts.ranks         = numbering.layout().n_ranks();
    counts.mass_and_size =
      mass_and_size(equations.model().plan.scene, equations.model().lattice);
    return counts;
  }

  double cpu_seconds()
  {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return time.tv_sec + 1e-9 * time.tv_nsec;
  }

  unsigned long peak_memory()
  {
    dealii::Utilities::System::MemoryStats memory{};
    dealii::Utilities::System::get_memory_stats(memory);
    constexpr unsigned long kilobyte = 1024;
    return memory.VmHWM * kilobyte;
  }

  Resources gather_resources(const StartTimes &start,
                             const double      wall_seconds,
                             const PhaseTimes &wall,
                             const MPI_Comm    communicator)
  {
    namespace MPI = dealii::Utilities::MPI;

    const unsigned long peak = peak_memory();

    std::array<double, 11> times{{wall_seconds,
                                  wall.setup,
                                  wall.residual,
                                  wall.tangent,
                                  wall.factorize,
                                  wall.solve,
                                  wall.contact,
                                  wall.output,
                                  wall.checkpoints,
                                  start.program,
                                  start.mpi}};
    MPI_Allreduce(MPI_IN_PLACE,
                  times.data(),
                  times.size(),
                  MPI_DOUBLE,
                  MPI_MAX,
                  communicator);

    Resources resources;
    resources.largest_memory = MPI::max(peak, communicator);
    resources.memory         = MPI::sum(peak, communicator);
    resources.cpu_seconds    = MPI::sum(cpu_seconds(), communicator);
    resources.wall_seconds   = times[0];
    resources.wall           = {times[1],
                                times[2],
                                times[3],
                                times[4],
                                times[5],
                                times[6],
                                times[7],
                                times[8]};
    resources.start = {times[9], times[10], MPI::sum(start.cpu, communicator)};
    return resources;
  }

  std::string version_text()
  {
    const std::string revision = git_revision;
    return std::string(version) + " (" +
      (revision.empty() ? "" : revision + ", ") + build_type + ")";
  }

  Json json_of_run(const Scene       &scene,
                   const std::string &exit_state,
                   const double       time)
  {
    return {{"program", "auxfem"},
            {"version", version},
            {"git_revision", git_revision},
            {"build_type", build_type},
            {"date", current_date()},
            {"file", scene.file},
            {"title", scene.title},
            {"exit_state", exit_state},
            {"time_reached", time},
            {"end_time", scene.time.end_time}};
  }

  namespace
  {
    Json json_of(const std::vector<EffectDecision> &decisions,
                 const double                       tolerance)
    {
      Json list = Json::array();
      for (const EffectDecision &decision : decisions)
        {
          Json effect = {{"name", decision.name}, {"on", decision.on}};
          if (decision.measure)
            effect.update({{"change", decision.measure->change},
                           {"change_of", decision.measure->of},
                           {"tolerance", tolerance}});
          effect["verdict"] =
            decision.is_needed(tolerance) ? "called for" : "not called for";
          effect["reason"] = decision.reason;
          list.push_back(effect);
        }
      return list;
    }

    Json json_of(const LargestStrain &strain)
    {
      Json json = {{"time", strain.time()}, {"axis", axis_name(strain.axis())}};
      for (unsigned int axis = 0; axis < 3; ++axis)
        if (const std::optional<double> value = strain.along(axis))
          json[axis_name(axis)] = *value;
      for (unsigned int axis = 0; axis < 3; ++axis)
        if (const std::optional<double> ratio = strain.poissons_ratio(axis))
          json["poissons_ratio_" + axis_name(axis)] = *ratio;
      return json;
    }

    /** A line with effective Poisson's ratios; empty without any. */
    std::string poissons_ratio_text(const LargestStrain &strain)
    {
      const std::string  loaded = "strain." + axis_name(strain.axis());
      std::ostringstream ratios;
      for (unsigned int axis = 0; axis < 3; ++axis)
        if (const std::optional<double> ratio = strain.poissons_ratio(axis))
          ratios << (ratios.tellp() > 0 ? ", " : "") << "-strain."
                 << axis_name(axis) << "/" << loaded << " = "
                 << rounded_text(*ratio, 4);
      if (ratios.str().empty())
        return "";
      std::ostringstream line;
      line << "Effective Poisson's ratio " << ratios.str()
           << " at the largest |" << loaded << "|, " << loaded << " = "
           << *strain.along(strain.axis()) << '\n';
      return line.str();
    }
  } // namespace

  namespace
  {
    /** A line on the dissipated energy by cause; empty without any. */
    std::string dissipation_text(const Energies &energies)
    {
      std::string causes;
      for (const auto &[cause, share] : dissipated_shares(energies))
        causes +=
          (causes.empty() ? ": " : ", ") + cause + " " + percentage_text(share);
      return causes.empty() ? ""
                            : "Dissipated " +
          rounded_text(energies.dissipated()) + " J" + causes + '\n';
    }
  } // namespace

  std::string closing_energies_text(const EnergyRecord &record,
                                    const std::string  &folder)
  {
    char balance[80];
    std::snprintf(
      balance,
      sizeof(balance),
      "Energy balance holds to %.1e of the largest energy (%.3e J)\n",
      record.relative(record.largest_balance),
      record.largest_energy);
    return dissipation_text(record.latest) +
      (record.largest_energy > 0 ? balance : "") + ("Results are in " + folder);
  }

  Json json_of(const MassAndSize &found)
  {
    Json json = {{"size_metre", {found.size[0], found.size[1], found.size[2]}}};
    if (found.mass)
      json["mass_kilogram"] = *found.mass;
    if (found.relative_density)
      json["relative_density"] = *found.relative_density;
    for (const auto &[section, n_struts] : found.struts_of_section)
      json["struts_of_section"][section] = n_struts;
    return json;
  }

  std::string summary_json(const Scene &scene, const Summary &summary)
  {
    Json json = json_of_run(scene, summary.exit_state, summary.time);
    if (summary.path)
      {
        json.erase("time_reached");
        json.erase("end_time");
        json["arc_length"]  = summary.time;
        json["load_factor"] = summary.path->load_factor;
      }
    add_verdict(json, summary.findings);
    json["counts"] = json_of(summary.counts);
    json.update(json_of(summary.counts.mass_and_size));
    json["sections"]         = names_of_sections(scene);
    json["connector_groups"] = names_of_groups(scene.connectors);
    json["work"]             = json_of(summary.totals);
    if (summary.time_error)
      json["estimated_time_error"] = *summary.time_error;
    if (summary.small_displacement_error)
      json["estimated_error_of_small_displacements"] =
        *summary.small_displacement_error;
    if (summary.orders)
      json["order_choice"] = json_of(*summary.orders);
    json["wall_seconds"]            = wall_seconds(summary.resources);
    json["cpu_seconds"]             = summary.resources.cpu_seconds;
    json["cpu_seconds_of_start"]    = summary.resources.start.cpu;
    json["peak_memory_bytes"]       = {{"largest_rank",
                                        summary.resources.largest_memory},
                                       {"all_ranks", summary.resources.memory}};
    json["energies_joule"]          = json_of_energies(summary.energies);
    json["largest_rotation_radian"] = summary.largest_rotation;
    if (summary.largest_penetration)
      json["largest_penetration_over_thickness"] = *summary.largest_penetration;
    if (!summary.broken.empty())
      json["broken_struts"] = summary.broken.size();
    for (const auto &[group, number] : summary.broken_connectors)
      json["broken_connectors"][group] = number;
    json["effects"] = json_of(summary.decisions, scene.effects.tolerance);
    if (!summary.notes.empty())
      json["notes"] = summary.notes;
    if (summary.strain.along(summary.strain.axis()))
      json["largest_effective_strain"] = json_of(summary.strain);
    if (const Json figures = json_of(summary.figures); !figures.is_null())
      json["evaluation"] = figures;
    if (!summary.quantities.empty())
      json["quantities"] = json_of_quantities(summary.quantities);
    return json_text(json) + '\n';
  }

  namespace
  {
    std::string position_text(const Summary &summary)
    {
      std::ostringstream text;
      if (summary.path)
        text << " at load factor " << summary.path->load_factor << ": ";
      else
        text << " at t = " << summary.time << " s: ";
      return text.str();
    }
  } // namespace

  std::string closing_text(const Summary &summary, const std::string &folder)
  {
    const Work        &totals = summary.totals;
    const PhaseTimes  &wall   = summary.resources.wall;
    std::ostringstream stream;
    stream << (summary.exit_state == "completed" ? "Completed"
                                                 : "Stopped early")
           << position_text(summary) << totals.steps
           << (summary.path ? " points, " : " steps, ") << totals.iterations
           << " iterations, " << totals.factorizations << " factorizations, "
           << totals.retries << " rejected steps\n"
           << "Wall time " << seconds(summary.resources.wall_seconds)
           << ": set-up " << seconds(wall.setup) << ", residuals "
           << seconds(wall.residual) << ", tangents " << seconds(wall.tangent)
           << ", factorizations " << seconds(wall.factorize) << ", solutions "
           << seconds(wall.solve)
           << (summary.largest_penetration
                 ? ", search for contact " + seconds(wall.contact)
                 : "")
           << ", output " << seconds(wall.output)
           << (wall.checkpoints > 0
                 ? ", checkpoints " + seconds(wall.checkpoints)
                 : "")
           << '\n'
           << "Peak memory " << (summary.resources.memory >> 20) << " MiB\n";

    if (!totals.linear_solver.empty())
      stream << "Linear equations by " << totals.linear_solver << '\n';
    if (totals.linear_iterations > 0)
      stream << "Linear iterations a solution "
             << std::llround(double(totals.linear_iterations) /
                             totals.linear_solutions)
             << '\n';
    if (summary.orders)
      stream << order_search_text(*summary.orders) << '\n'
             << mesh_error_text(*summary.orders) << '\n';
    if (summary.largest_penetration)
      stream << "Largest penetration "
             << percentage_text(*summary.largest_penetration, 3)
             << " of the thickness\n";
    stream << failures_text(summary.broken, summary.broken_connectors)
           << poissons_ratio_text(summary.strain) << text_of(summary.figures)
           << summary.quantities_text
           << closing_energies_text(summary.energies, folder) << '\n'
           << verdict_text(summary.findings);
    return stream.str();
  }
} // namespace auxfem
