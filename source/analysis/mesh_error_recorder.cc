#include <auxfem/analysis/mesh_error_recorder.h>
#include <auxfem/output/summary.h>
#include <auxfem/time/runge_kutta.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** How often a run is looked at. */
    constexpr unsigned int n_looks = 64;

    const std::string mesh_error_record =
      "mesh error: largest error and energy, next look, parts of steps";

    /** A run whose elements are not good enough. */
    Finding missed_tolerance(const OrderReport &report, const double time)
    {
      std::ostringstream text;
      text.precision(2);
      text << "The elements make an error of " << *report.estimated_error
           << " in the motion of the joints, by estimate, more than "
              "Discretization/Tolerance = "
           << report.tolerance
           << ": the motion is not that of the search run, or no elements are "
              "good enough for some struts. Lower the tolerance by as much, or "
              "raise it to that error if it may stay.";
      return {Verdict::doubtful, text.str(), time, ""};
    }

    /** Each stage of a step follows a motion by itself. */
    unsigned int parts_of_step(const Scene &scene)
    {
      const ButcherTableau *const stages =
        scene.time.implicit_scheme().stages();
      return stages == nullptr ? 1 : stages->n_stages() - 1;
    }

    Finding own_vibrations(const unsigned int n_struts)
    {
      return {Verdict::doubtful,
              "Steps are short enough to resolve vibrations of " +
                std::to_string(n_struts) +
                (n_struts == 1 ? " strut" : " struts") +
                " between the joints. Errors of these add up over the time and "
                "are not in the estimated error of the elements: where such "
                "vibrations matter, give Discretization/Order a number and "
                "compare it with the next, or ask Analysis = study.",
              0.,
              ""};
    }
  } // namespace

  std::vector<double> own_frequencies(const Lattice              &lattice,
                                      const std::vector<Section> &sections)
  {
    std::vector<double> frequencies;
    for (unsigned int i = 0; i < lattice.struts.size(); ++i)
      {
        const Strut &strut = lattice.struts[i];
        if (strut.is_rigid())
          continue;
        const Section &section     = sections[strut.section];
        const double   mass        = section.mass_per_length();
        const double   stiffness   = std::min(section.bending_stiffness_2(),
                                          section.bending_stiffness_3());
        const double   wave_number = clamped_phase / lattice.length(strut);
        if (mass > 0)
          frequencies.push_back(wave_number * wave_number *
                                std::sqrt(stiffness / mass));
      }
    return frequencies;
  }

  MeshErrorRecorder::MeshErrorRecorder(const Scene       &scene,
                                       Recorder          &recorder,
                                       const OrderReport &report)
    : ForwardingRecorder(recorder)
    , scene(scene)
    , report(report)
  {}

  RunResult MeshErrorRecorder::completed(RunResult result) const
  {
    OrderReport of_run = report;
    if (estimate)
      {
        of_run.estimated_error = estimate->relative();
        of_run.cpu_seconds_of_estimates =
          dealii::Utilities::MPI::sum(seconds, communicator);
        // Estimates are good to a factor.
        if (*of_run.estimated_error > 2 * of_run.tolerance)
          result.findings.push_back(missed_tolerance(of_run, result.time));
      }
    if (const unsigned int n = n_vibrating(result.time); n > 0)
      result.findings.push_back(own_vibrations(n));
    result.orders = of_run;
    return result;
  }

  unsigned int MeshErrorRecorder::n_vibrating(const double time) const
  {
    return std::count_if(frequencies.begin(),
                         frequencies.end(),
                         [&](const double frequency) {
                           return frequency * time < n_parts;
                         });
  }

  void MeshErrorRecorder::look(const State &state)
  {
    const double before = cpu_seconds();
    estimate->look(state);
    const double distance = scene.time.end_time / n_looks;
    next = (std::floor(state.time / distance * (1 + 1e-12)) + 1) * distance;
    seconds += cpu_seconds() - before;
  }

  void MeshErrorRecorder::begin(const Equations &equations)
  {
    const double before = cpu_seconds();
    communicator        = equations.model().numbering.layout().communicator();
    estimate            = std::make_unique<MeshError>(scene, equations.model());
    if (equations.model().simulated.inertia)
      frequencies =
        own_frequencies(equations.model().lattice, equations.model().sections);
    seconds += cpu_seconds() - before;
    ForwardingRecorder::begin(equations);
  }

  void MeshErrorRecorder::start(const Solution &solution)
  {
    look(solution.state);
    ForwardingRecorder::start(solution);
  }

  void MeshErrorRecorder::resume(const Solution &solution,
                                 const Records  &records)
  {
    const std::vector<double> saved = records.values(mesh_error_record, 4);
    estimate->resume({saved[0], saved[1]});
    next    = saved[2];
    n_parts = saved[3];
    ForwardingRecorder::resume(solution, records);
  }

  void MeshErrorRecorder::save(Records &records) const
  {
    std::vector<double> saved = estimate->save();
    saved.push_back(next);
    saved.push_back(n_parts);
    records.keep(mesh_error_record, saved);
    ForwardingRecorder::save(records);
  }

  void MeshErrorRecorder::step(const Solution   &solution,
                               const StepReport &step_report)
  {
    n_parts += step_report.substeps * parts_of_step(scene);
    if (solution.state.time >= next)
      look(solution.state);
    ForwardingRecorder::step(solution, step_report);
  }

  void MeshErrorRecorder::finish(const Solution &last, const RunResult &result)
  {
    ForwardingRecorder::finish(last, completed(result));
  }
} // namespace auxfem
