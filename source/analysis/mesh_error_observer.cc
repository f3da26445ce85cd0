#include <auxfem/analysis/mesh_error_observer.h>
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
    /** In a run. */
    constexpr unsigned int n_instants = 64;

    const std::string mesh_error_record =
      "mesh error: largest error and energy, next look, parts of steps";
    const std::string division_record = "elements of the struts",
                      report_record   = "search of the elements of the struts";

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

    unsigned int n_stages(const Scene &scene)
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

  void ChosenElements::save(Records &records) const
  {
    std::vector<double> numbers;
    for (const StrutDivision &division : divisions)
      {
        numbers.push_back(division.order);
        numbers.push_back(division.n_elements);
      }
    records.keep(division_record, numbers);
    records.keep(report_record,
                 {report.tolerance,
                  report.predicted_error,
                  double(report.unknowns),
                  double(report.steps),
                  double(report.iterations),
                  report.cpu_seconds,
                  report.reached});
  }

  ChosenElements ChosenElements::saved(const Records &records)
  {
    const std::vector<double> numbers =
      records.values(division_record, records.values_per_item(division_record));
    const std::vector<double> values = records.values(report_record, 7);
    ChosenElements            chosen;
    for (std::size_t i = 0; i < numbers.size(); i += 2)
      chosen.divisions.push_back({static_cast<unsigned int>(numbers[i]),
                                  static_cast<unsigned int>(numbers[i + 1])});
    OrderReport &report    = chosen.report;
    report.tolerance       = values[0];
    report.predicted_error = values[1];
    report.unknowns        = values[2];
    report.steps           = values[3];
    report.iterations      = values[4];
    report.cpu_seconds     = values[5];
    report.reached         = values[6];
    return chosen;
  }

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

  MeshErrorObserver::MeshErrorObserver(const Scene        &scene,
                                       const LatticeModel &model,
                                       const OrderReport  &report)
    : distance(scene.time.end_time / n_instants)
    , parts_of_step(n_stages(scene))
    , report(report)
    , estimate(scene, model)
    , communicator(model.numbering.layout().communicator())
  {
    if (model.simulated.inertia)
      frequencies = own_frequencies(model.lattice, model.sections);
  }

  void MeshErrorObserver::start(const State &state)
  {
    const double before = cpu_seconds();
    estimate.look(state);
    next = (std::floor(state.time / distance * (1 + 1e-12)) + 1) * distance;
    seconds += cpu_seconds() - before;
  }

  void MeshErrorObserver::step(const State      &state,
                               const StepReport &step_report)
  {
    n_parts += step_report.substeps * parts_of_step;
    if (state.time >= next)
      start(state);
  }

  void MeshErrorObserver::add_to(RunResult &result) const
  {
    OrderReport of_run     = report;
    of_run.estimated_error = estimate.relative();
    of_run.cpu_seconds_of_estimates =
      dealii::Utilities::MPI::sum(seconds, communicator);
    // Estimates are good to a factor.
    if (*of_run.estimated_error > 2 * of_run.tolerance)
      result.findings.push_back(missed_tolerance(of_run, result.time));
    if (const unsigned int n = n_vibrating(result.time); n > 0)
      result.findings.push_back(own_vibrations(n));
    result.orders = of_run;
  }

  unsigned int MeshErrorObserver::n_vibrating(const double time) const
  {
    return std::count_if(frequencies.begin(),
                         frequencies.end(),
                         [&](const double frequency) {
                           return frequency * time < n_parts;
                         });
  }

  void MeshErrorObserver::save(Records &records) const
  {
    std::vector<double> saved = estimate.save();
    saved.push_back(next);
    saved.push_back(n_parts);
    records.keep(mesh_error_record, saved);
  }

  void MeshErrorObserver::resume(const Records &records)
  {
    const std::vector<double> saved = records.values(mesh_error_record, 4);
    estimate.resume({saved[0], saved[1]});
    next    = saved[2];
    n_parts = saved[3];
  }
} // namespace auxfem
