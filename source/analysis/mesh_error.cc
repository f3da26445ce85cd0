#include <auxfem/analysis/mesh_error.h>
#include <auxfem/elements/strut_order.h>
#include <auxfem/output/summary.h>
#include <auxfem/time/runge_kutta.h>

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

    /** Errors (J) of the struts of @p coarse in @p motions, not finite where
     * they cannot be found. What is out of balance still counts. */
    std::vector<double> errors_of(HeldStruts                     &coarse,
                                  HeldStruts                     &finer,
                                  const std::vector<StrutMotion> &motions)
    {
      const std::vector<unsigned int> &struts = coarse.struts();
      std::vector<double>              errors(struts.size(),
                                 std::numeric_limits<double>::infinity());
      for (unsigned int i = 0; i < struts.size(); ++i)
        coarse.move(struts[i], motions[i]);
      if (!coarse.settle())
        return errors;
      for (const unsigned int strut : struts)
        finer.move(strut, coarse.motion(strut));
      if (!finer.settle())
        return errors;
      for (unsigned int i = 0; i < struts.size(); ++i)
        if (const double error = finer.difference(struts[i], coarse) +
              coarse.out_of_balance(struts[i]) +
              finer.out_of_balance(struts[i]);
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

  void MeshError::look(const State &state)
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

  std::vector<double> errors_of_division(const LatticeModel              &model,
                                         const MeshError                 &seen,
                                         const std::vector<unsigned int> &which,
                                         const StrutDivision division)
  {
    if (which.empty())
      return {};
    std::vector<unsigned int> struts;
    std::vector<StrutMotion>  motions;
    for (const unsigned int i : which)
      {
        struts.push_back(seen.struts()[i]);
        motions.push_back(seen.most_demanding()[i]);
      }
    const std::vector<StrutDivision> divisions(model.lattice.struts.size(),
                                               division);
    HeldStruts                       divided(model, divisions, struts),
      finer(model, finer_than(model, divisions), struts);
    return errors_of(divided, finer, motions);
  }

  namespace
  {
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

    unsigned int n_stages(const TimeParameters &time)
    {
      const ButcherTableau *const stages = time.implicit_scheme().stages();
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

  MeshErrorObserver::MeshErrorObserver(const LatticeModel &model,
                                       const OrderReport  &report)
    : distance(model.plan.time.end_time / n_instants_of_mesh_error)
    , parts_of_step(n_stages(model.plan.time))
    , report(report)
    , estimate(model)
    , communicator(model.numbering.layout().communicator())
  {
    if (model.plan.simulated.inertia)
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
    OrderReport final_report     = report;
    final_report.estimated_error = estimate.relative();
    final_report.cpu_seconds_of_estimates =
      dealii::Utilities::MPI::sum(seconds, communicator);
    // Estimates are good to a factor.
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
} // namespace auxfem
