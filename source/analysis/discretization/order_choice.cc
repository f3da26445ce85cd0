#include <auxfem/analysis/discretization/order_choice.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/output/history.h>
#include <auxfem/output/summary.h>
#include <auxfem/output/verdict.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/effects/struts.h>
#include <auxfem/time/schemes/runge_kutta.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    std::vector<StrutDivision> finer_than(const LatticeModel        &model,
                                          std::vector<StrutDivision> divisions)
    {
      for (StrutDivision &division : divisions)
        division = {std::min(division.order + 1,
                             highest_strut_order(model.lattice.dimension)),
                    2 * division.n_elements};
      return divisions;
    }

    /**
     * Errors (J) of the struts of @p coarse in @p motions; not finite without
     * a solution. Remaining imbalance counts as error.
     */
    std::vector<double> errors_of(ClampedStrutProblems           &coarse,
                                  ClampedStrutProblems           &finer,
                                  const std::vector<StrutMotion> &motions)
    {
      const std::vector<unsigned int> &struts = coarse.struts();
      std::vector<double>              errors(struts.size(),
                                 std::numeric_limits<double>::infinity());
      for (unsigned int i = 0; i < struts.size(); ++i)
        coarse.move(struts[i], motions[i]);
      if (!coarse.solve_equilibrium())
        return errors;
      for (const unsigned int strut : struts)
        finer.move(strut, coarse.motion(strut));
      if (!finer.solve_equilibrium())
        return errors;
      for (unsigned int i = 0; i < struts.size(); ++i)
        if (const double error = finer.difference(struts[i], coarse) +
              coarse.last_correction_work(struts[i]) +
              finer.last_correction_work(struts[i]);
            std::isfinite(error))
          errors[i] = error;
      return errors;
    }
  } // namespace

  MeshError::MeshError(const LatticeModel &model)
    : model(model)
    , same(model, model.numbering.divisions(), owned_struts(model.numbering))
    , finer(model,
            finer_than(model, model.numbering.divisions()),
            owned_struts(model.numbering))
    , largest(same.struts().size(), -1.)
    , motions(same.struts().size())
  {
    const auto &elements = model.numbering.elements();
    for (unsigned int e = 0; e < elements.size(); ++e)
      if (elements[e].is_owned && elements[e].interval.begin == 0)
        first_elements.push_back(e);
  }

  void MeshError::sample(const State &state)
  {
    std::vector<StrutMotion> now;
    now.reserve(first_elements.size());
    for (const unsigned int element : first_elements)
      now.push_back(motion_of_strut(model.numbering, state, element));
    const std::vector<double> errors = errors_of(same, finer, now);
    double                    sum    = 0;
    for (unsigned int i = 0; i < errors.size(); ++i)
      {
        sum += errors[i];
        if (errors[i] > largest[i])
          {
            largest[i] = errors[i];
            motions[i] = std::move(now[i]);
          }
      }
    error  = std::max(error, model.numbering.layout().sum(sum));
    energy = std::max(energy, 2 * state.energies.strain());
  }

  double MeshError::relative() const
  {
    return energy > 0 ? std::sqrt(error / energy) : 0.;
  }

  void MeshError::serialize(CheckpointArchive &archive)
  {
    archive.values("mesh error: energies of error and motion", error, energy);
  }

  std::vector<double> division_errors(const LatticeModel              &model,
                                      const MeshError                 &seen,
                                      const std::vector<unsigned int> &which,
                                      const StrutDivision              division)
  {
    if (which.empty())
      return {};
    std::vector<unsigned int> struts;
    std::vector<StrutMotion>  motions;
    for (const unsigned int i : which)
      {
        struts.push_back(seen.struts()[i]);
        motions.push_back(seen.critical_motions()[i]);
      }
    const std::vector<StrutDivision> divisions(model.lattice.struts.size(),
                                               division);
    ClampedStrutProblems             divided(model, divisions, struts),
      finer(model, finer_than(model, divisions), struts);
    return errors_of(divided, finer, motions);
  }

  namespace
  {
    /** Reports elements with an excessive error. */
    Finding missed_tolerance(const OrderReport &report, const double time)
    {
      std::ostringstream text;
      text.precision(2);
      text
        << "The elements make an error of " << *report.estimated_error
        << " in the motion of the joints, by estimate, more than "
           "Discretization/Tolerance = "
        << report.tolerance
        << ": the motion differs from that of the search run, or no elements "
           "are accurate enough for some struts. Reduce the tolerance by the "
           "same factor, or set it to that error if the error is acceptable.";
      return {Verdict::doubtful, text.str(), time, ""};
    }

    unsigned int n_stages(const TimeParameters &time)
    {
      const ButcherTableau *const stages = time.implicit_scheme().stages();
      return stages == nullptr ? 1 : stages->n_stages() - 1;
    }

    Finding own_vibrations(const unsigned int n_struts)
    {
      return {
        Verdict::doubtful,
        "Steps are short enough to resolve vibrations of " +
          std::to_string(n_struts) + (n_struts == 1 ? " strut" : " struts") +
          " between the joints. Their errors accumulate over time and are "
          "not in the estimated error of the elements. Where such "
          "vibrations matter, set Discretization/Order to a number and "
          "compare with the next one, or use Analysis = study.",
        0.,
        ""};
    }
  } // namespace

  std::vector<double> clamped_frequencies(const Lattice              &lattice,
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

  MeshErrorObserver::MeshErrorObserver(const LatticeModel &model,
                                       const OrderReport  &report)
    : distance(model.plan.time.end_time / n_mesh_error_samples)
    , parts_of_step(n_stages(model.plan.time))
    , report(report)
    , estimate(model)
    , communicator(model.numbering.layout().communicator())
  {
    if (model.plan.simulated.inertia)
      frequencies = clamped_frequencies(model.lattice, model.sections);
  }

  void MeshErrorObserver::start(const State &state)
  {
    const double before = cpu_seconds();
    estimate.sample(state);
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
    OrderReport final_report     = report;
    final_report.estimated_error = estimate.relative();
    final_report.cpu_seconds_of_estimates =
      dealii::Utilities::MPI::sum(seconds, communicator);
    // Estimates are good to a factor of two.
    if (*final_report.estimated_error > 2 * final_report.tolerance)
      result.findings.push_back(missed_tolerance(final_report, result.time));
    if (const unsigned int n = n_vibrating(result.time); n > 0)
      result.findings.push_back(own_vibrations(n));
    result.orders = final_report;
  }

  unsigned int MeshErrorObserver::n_vibrating(const double time) const
  {
    return std::count_if(frequencies.begin(),
                         frequencies.end(),
                         [&](const double frequency) {
                           return frequency * time < n_parts;
                         });
  }

  void MeshErrorObserver::serialize(CheckpointArchive &archive)
  {
    estimate.serialize(archive);
    archive.values("mesh error: next sample, number of parts", next, n_parts);
  }

  namespace
  {
    namespace mpi = dealii::Utilities::MPI;

    /**
     * Step length of a search run over that of the run; the search finds the
     * instants that need the highest orders.
     * @tuned judgement
     */
    constexpr double search_step_factor = 4;

    /** Largest number of search runs. */
    constexpr unsigned int max_searches = 6;

    /** Reports the progress of a search run to a recorder. */
    class SearchProgress : public Recorder
    {
    public:
      SearchProgress(const RunPlan &search, Recorder &listener)
        : search(search)
        , listener(listener)
      {}

      void step(const Solution &solution, const StepReport &report) override
      {
        listener.search_step(search, solution.state, report);
      }

    private:
      const RunPlan &search;
      Recorder      &listener;
    };

    /** Plan of the search run, with fewer steps. */
    RunPlan search_plan(const RunPlan &plan)
    {
      RunPlan search        = plan;
      search.division.order = lowest_chosen_order;
      TimeParameters &time  = search.time;
      if (time.relative_tolerance)
        time.relative_tolerance =
          std::max(*time.relative_tolerance, noticeable_fraction);
      else
        time.step =
          std::min(search_step_factor * time.step,
                   std::max(time.step, time.end_time / n_mesh_error_samples));
      return search;
    }

    /** Multiples of the number of elements that all struts have. */
    constexpr unsigned int multiples[] =
      {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};

    /**
     * Successive numbers of elements without improvement after which a strut's
     * search ends.
     */
    constexpr unsigned int max_failed = 2;

    /**
     * Best elements of a strut: the fewest nodes with an allowed error, else
     * the smallest error.
     */
    struct BestElements
    {
      StrutDivision division{lowest_chosen_order, 1};
      double        error = std::numeric_limits<double>::infinity(); ///< J
      bool          meets_tolerance = false;
      unsigned int  n_failed        = 0;
    };

    /** Tries elements for each strut in its motion with the largest error. */
    class ElementSearch
    {
    public:
      /** @param allowed error (J) of one strut */
      ElementSearch(const LatticeModel &model,
                    const MeshError    &seen,
                    const double        allowed)
        : model(model)
        , seen(seen)
        , allowed(allowed)
        , best(seen.struts().size())
      {}

      /** Indexed as MeshError::struts(). */
      const std::vector<BestElements> &find()
      {
        for (const unsigned int multiple : multiples)
          {
            const std::vector<BestElements> before = best;
            for (unsigned int order = lowest_chosen_order;
                 order <= highest_strut_order(model.lattice.dimension);
                 ++order)
              try_division({order, multiple * model.plan.division.n_elements});
            for (std::size_t i = 0; i < best.size(); ++i)
              best[i].n_failed =
                best[i].error < before[i].error ? 0 : best[i].n_failed + 1;
          }
        return best;
      }

    private:
      void try_division(const StrutDivision &division)
      {
        std::vector<unsigned int> tried;
        for (unsigned int i = 0; i < best.size(); ++i)
          if (best[i].meets_tolerance
                ? division.n_inner_nodes() < best[i].division.n_inner_nodes()
                : best[i].n_failed < max_failed)
            tried.push_back(i);
        const std::vector<double> errors =
          division_errors(model, seen, tried, division);
        for (std::size_t k = 0; k < tried.size(); ++k)
          {
            BestElements &best_elements = best[tried[k]];
            const bool    is_allowed    = errors[k] <= allowed;
            // Smaller improvements may be round-off.
            if (is_allowed || errors[k] <= best_elements.error / 4)
              best_elements = {division,
                               errors[k],
                               is_allowed,
                               best_elements.n_failed};
          }
      }

      const LatticeModel       &model;
      const MeshError          &seen;
      const double              allowed;
      std::vector<BestElements> best;
    };

    /**
     * Chooses elements for the motion of @p run; each strut has an equal share
     * in the error.
     */
    void choose_divisions(const LatticeRun &run,
                          const MeshError  &error,
                          ChosenElements   &chosen)
    {
      const MPI_Comm communicator = run.model.numbering.layout().communicator();
      const double   n_struts =
                     mpi::sum(double(error.struts().size()), communicator),
                   allowed_error = std::pow(element_tolerance_fraction *
                                              chosen.report.tolerance,
                                            2) *
        error.largest_energy();
      ElementSearch find(run.model, error, allowed_error / n_struts);
      const std::vector<BestElements> &best = find.find();
      // Each strut is counted by one rank; the others have zeros.
      std::vector<unsigned int> numbers(2 * chosen.divisions.size(), 0);
      double                    sum = 0;
      for (std::size_t i = 0; i < best.size(); ++i)
        {
          const unsigned int strut = error.struts()[i];
          numbers[2 * strut]       = best[i].division.order;
          numbers[2 * strut + 1]   = best[i].division.n_elements;
          sum += best[i].error;
        }
      mpi::max(numbers, communicator, numbers);
      for (unsigned int s = 0; s < chosen.divisions.size(); ++s)
        if (numbers[2 * s] > 0)
          chosen.divisions[s] = {numbers[2 * s], numbers[2 * s + 1]};
      chosen.report.predicted_error =
        std::sqrt(mpi::sum(sum, communicator) / error.largest_energy());
    }

    /**
     * Makes a search run and chooses elements for its motion. Returns whether
     * its own elements are accurate enough for that.
     */
    bool search_elements(RunPlan         search,
                         const MPI_Comm  communicator,
                         Recorder       &listener,
                         ChosenElements &chosen)
    {
      search.elements = chosen;
      LatticeRun run(search, communicator);
      // Scenes that the run refuses at its start must not cost a search.
      require_existing_columns(search.scene, run.lattice);
      SearchProgress progress(search, listener);
      try
        {
          run.run(progress);
        }
      catch (const ComputationError &)
        {
          // The motion so far must suffice; the run itself reports the
          // failure.
        }
      const MeshError *const error = run.mesh_error();
      chosen.divisions.assign(run.lattice.struts.size(),
                              {lowest_chosen_order,
                               search.division.n_elements});
      // Without motion there is nothing to choose for.
      if (error != nullptr && error->largest_energy() > 0)
        choose_divisions(run, *error, chosen);
      OrderReport &report = chosen.report;
      report.unknowns     = run.model.numbering.layout().n_global();
      report.steps += run.work().steps;
      report.iterations += run.work().iterations;
      report.reached = run.solution.state.time;
      return error == nullptr || error->relative() <= unusable_error;
    }
  } // namespace

  ChosenElements choose_elements(const RunPlan &plan,
                                 const MPI_Comm communicator,
                                 Recorder      &recorder)
  {
    const double   cpu_start = cpu_seconds();
    const RunPlan  search    = search_plan(plan);
    ChosenElements chosen;
    chosen.report.tolerance = *plan.scene.discretization.tolerance;
    for (unsigned int i = 0; i < max_searches; ++i)
      {
        // Even a motion with large errors identifies the demanding struts.
        const std::vector<StrutDivision> former = chosen.divisions;
        if (search_elements(search, communicator, recorder, chosen) ||
            chosen.divisions == former)
          break;
      }
    chosen.report.cpu_seconds =
      mpi::sum(cpu_seconds() - cpu_start, communicator);
    return chosen;
  }
} // namespace auxfem
