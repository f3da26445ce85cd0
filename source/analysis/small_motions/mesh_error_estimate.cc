#include <auxfem/analysis/discretization/order_choice.h>
#include <auxfem/analysis/small_motions/mesh_error_estimate.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/effects/clamped_strut_problems.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    /** Largest number of elements per strut that is tried. */
    constexpr unsigned int max_elements = 64;

    /**
     * Relative error above which frequencies are not to be used.
     * @tuned judgement: a frequency with this error is no result
     */
    constexpr double unusable_mode_error = 0.1;

    /** ((2 p)! / p!)^(1/p), to the power p. */
    double factorials(const unsigned int order)
    {
      double product = 1;
      for (unsigned int i = order + 1; i <= 2 * order; ++i)
        product *= i;
      return product;
    }

    /**
     * Relative error of the squared frequency of a wave with this phase along
     * an element.
     */
    double dispersion(const unsigned int order, const double phase)
    {
      return std::pow(std::pow(phase, order) / factorials(order), 2) /
        (2 * order + 1);
    }

    /** Phase along an element at which waves have this error. */
    double phase_with_dispersion(const unsigned int order, const double error)
    {
      return std::pow(std::sqrt(error * (2 * order + 1)) * factorials(order),
                      1. / order);
    }

    /**
     * Chooses the fewest unknowns for which waves have at most the error @p
     * tolerance, among divisions with more than @p n_inner_nodes per strut.
     * Returns false if there is none.
     */
    bool choose_division(const double       phase,
                         const double       tolerance,
                         const unsigned int n_inner_nodes,
                         const unsigned int least_elements,
                         RunPlan           &plan)
    {
      unsigned int best = invalid_index;
      for (unsigned int n_elements = least_elements;
           n_elements <= std::max(least_elements, max_elements);
           n_elements *= 2)
        for (unsigned int order = lowest_chosen_order;
             order <= highest_strut_order(plan.scene.context.dimension);
             ++order)
          {
            const StrutDivision division{order, n_elements};
            const unsigned int  n = division.n_inner_nodes();
            if (n > n_inner_nodes && n < best &&
                dispersion(order, phase / n_elements) <= tolerance)
              {
                best          = n;
                plan.division = division;
              }
          }
      return best != invalid_index;
    }

    /**
     * @p state with the displacement @p shape only, without large rotations.
     */
    State with_shape(State state, const Vector &shape)
    {
      state.displacement = shape;
      state.rotations.clear();
      state.velocity = state.acceleration = std::nullopt;
      return state;
    }

    /**
     * First element of each strut, for struts that this rank stores completely.
     */
    std::map<unsigned int, unsigned int>
    first_elements(const DofNumbering &numbering)
    {
      std::map<unsigned int, unsigned int> numbers, first;
      for (unsigned int e = 0; e < numbering.elements().size(); ++e)
        {
          const unsigned int strut = numbering.elements()[e].interval.strut;
          if (++numbers[strut] == 1)
            first[strut] = e;
        }
      for (const auto &[strut, number] : numbers)
        if (number < numbering.divisions()[strut].n_elements)
          first.erase(strut);
      return first;
    }

    std::string percent(const double part)
    {
      std::ostringstream text;
      text.precision(3);
      text << 100 * part << " %";
      return text.str();
    }

    std::string elements_text(const StrutDivision &division)
    {
      const unsigned int n = division.n_elements;
      return std::to_string(n) + (n == 1 ? " element" : " elements") +
        " of order " + std::to_string(division.order) + " a strut";
    }

    std::string advice(const Scene &scene)
    {
      return scene.discretization.tolerance
        ? "Raise Discretization/Global refinements, or Tolerance if this error "
          "is acceptable."
        : "Set Discretization/Order = auto, or raise Order or Global "
          "refinements.";
    }

    std::vector<double> clamped_frequencies(const Scene &scene)
    {
      std::vector<Section> sections;
      for (const SectionDefinition &definition : scene.sections)
        sections.push_back(definition.section);
      std::vector<double> all =
        auxfem::clamped_frequencies(designed_lattice(scene), sections);
      all.erase(std::remove(all.begin(), all.end(), 0.), all.end());
      return all;
    }
  } // namespace

  double MeshErrors::largest() const
  {
    double largest =
      unknown_reason.empty() ? 0. : std::numeric_limits<double>::infinity();
    for (const double error : relative)
      largest = std::isfinite(error) ? std::max(largest, error)
                                     : std::numeric_limits<double>::infinity();
    return largest;
  }

  double phase_of_modes(const Scene &scene, const unsigned int n)
  {
    const std::vector<double> first_frequencies = clamped_frequencies(scene);
    if (first_frequencies.empty())
      return clamped_phase;
    // Clamped modes have the phases (j + 1/2) pi within a percent.
    const auto count_below = [&](const double omega) {
      double sum = 0;
      for (const double first : first_frequencies)
        if (omega >= first)
          sum += std::floor((3 * std::sqrt(omega / first) - 1) / 2);
      return sum;
    };
    double omega =
      *std::min_element(first_frequencies.begin(), first_frequencies.end());
    while (count_below(omega) < n)
      omega *= 1.1;
    return phase_at(scene, omega);
  }

  double phase_of_buckling(const Scene &scene, const unsigned int n)
  {
    const Lattice      lattice = designed_lattice(scene);
    const unsigned int n_struts =
      std::count_if(lattice.struts.begin(),
                    lattice.struts.end(),
                    [](const Strut &strut) { return !strut.is_rigid(); });
    const unsigned int modes_per_strut =
      n_struts > 0 ? (n + n_struts - 1) / n_struts : 1;
    return (modes_per_strut + 1) * dealii::numbers::PI;
  }

  double phase_at(const Scene &scene, const double omega)
  {
    const std::vector<double> first_frequencies = clamped_frequencies(scene);
    return first_frequencies.empty() ? clamped_phase
                                     : clamped_phase *
        std::sqrt(omega /
                  *std::min_element(first_frequencies.begin(),
                                    first_frequencies.end()));
  }

  void
  choose_elements(const double phase, const double tolerance, RunPlan &plan)
  {
    const unsigned int least = plan.division.n_elements;
    // Users seldom need shorter waves.
    constexpr unsigned int most_at_first = 8;
    if (choose_division(phase, tolerance, 0, least, plan) &&
        plan.division.n_elements <= most_at_first * least)
      return;
    plan.division = {highest_strut_order(plan.scene.context.dimension),
                     most_at_first * least};
  }

  bool
  refine_elements(const RunPlan &first, const MeshErrors &errors, RunPlan &plan)
  {
    const StrutDivision division = plan.division;
    // Missing modes or large errors mean that waves are not resolved.
    const double error = errors.n_missing > 0 || errors.has_too_few
      ? 1.
      : std::min(errors.largest(), 1.);
    const double phase =
      division.n_elements * phase_with_dispersion(division.order, error);
    return choose_division(phase,
                           element_tolerance_fraction *
                             *plan.scene.discretization.tolerance,
                           division.n_inner_nodes(),
                           first.division.n_elements,
                           plan);
  }

  RunPlan with_finer_elements(RunPlan plan)
  {
    plan.division = {std::min(plan.division.order + 1,
                              highest_strut_order(
                                plan.scene.context.dimension)),
                     2 * plan.division.n_elements};
    return plan;
  }

  bool elements_accepted(const Scene &scene, const MeshErrors &errors)
  {
    const auto &tolerance = scene.discretization.tolerance;
    return !tolerance || !errors.unknown_reason.empty() ||
      (errors.largest() <= *tolerance && errors.n_missing == 0 &&
       !errors.has_too_few);
  }

  std::vector<Finding> mesh_findings(const RunPlan     &plan,
                                     const MeshErrors  &errors,
                                     const std::string &values)
  {
    std::vector<Finding> findings;
    const auto           add = [&](const Verdict verdict, std::string text) {
      findings.push_back({verdict, std::move(text), 0., ""});
    };
    const std::string elements = elements_text(plan.division);
    if (!errors.unknown_reason.empty())
      add(Verdict::doubtful,
          "The discretization error is unknown, because the comparison with "
          "finer elements failed: " +
            errors.unknown_reason);
    if (errors.n_missing > 0)
      add(Verdict::not_to_be_used,
          std::to_string(errors.n_missing) + " modes are missing with " +
            elements + ": finer elements have them below the last mode. " +
            advice(plan.scene));
    const double error = errors.largest();
    if (!errors.unknown_reason.empty())
      return findings;
    const double limit = plan.scene.discretization.tolerance
      ? *plan.scene.discretization.tolerance / element_tolerance_fraction
      : noticeable_fraction;
    if (error > limit)
      add(error > std::max(limit, unusable_mode_error) ? Verdict::not_to_be_used
                                                       : Verdict::doubtful,
          std::isfinite(error) ? "With " + elements + " the " + values +
              " have errors of up to " + percent(error) +
              ", by comparison with finer elements. " + advice(plan.scene)
                               : "With " + elements + " some " + values +
              " have no counterpart on finer elements. " + advice(plan.scene));
    return findings;
  }

  std::string mesh_text(const RunPlan &plan, const MeshErrors &errors)
  {
    std::ostringstream text;
    text.precision(2);
    text << "  " << elements_text(plan.division);
    if (std::isfinite(errors.largest()))
      text << ": largest error " << errors.largest()
           << ", by comparison with finer elements";
    if (plan.scene.discretization.tolerance)
      text << "; tolerance " << *plan.scene.discretization.tolerance;
    return text.str();
  }

  Json json_of(const RunPlan &plan, const MeshErrors &errors)
  {
    Json json = {{"order", plan.division.order},
                 {"elements_per_strut", plan.division.n_elements},
                 {"largest_error", errors.largest()},
                 {"missing_modes", errors.n_missing}};
    if (plan.scene.discretization.tolerance)
      json["tolerance"] = *plan.scene.discretization.tolerance;
    return json;
  }

  FinerRun::FinerRun(LatticeRun &coarse)
    : coarse(coarse)
    , run(with_finer_elements(coarse.model.plan),
          coarse.model.numbering.layout().communicator())
  {
    run.start();
  }

  FinerRun::~FinerRun()
  {
    coarse.add_effort(run.work());
  }

  Vector FinerRun::prolongated(const Vector &shape) const
  {
    const DofNumbering &from = coarse.model.numbering,
                       &to   = run.model.numbering;
    State coarse_state       = with_shape(coarse.solution.state, shape);
    State finer =
      with_shape(run.solution.state,
                 Vector(run.solution.state.displacement.size(), 0.));
    const std::map<unsigned int, unsigned int> coarse_elements =
                                                 first_elements(from),
                                               finer_elements =
                                                 first_elements(to);
    for (const unsigned int strut : owned_struts(to))
      // Without inner nodes (order 1) a strut may be absent from this rank.
      if (const auto first = coarse_elements.find(strut);
          first != coarse_elements.end())
        set_motion_of_strut(
          to,
          finer_elements.at(strut),
          interpolated(motion_of_strut(from, coarse_state, first->second),
                       to.divisions()[strut]),
          finer);
    // Joints, rigid parts and hinges have equal serial numbers on all meshes.
    const Unknowns &coarse_unknowns = coarse.equations.unknowns(),
                   &finer_unknowns  = run.equations.unknowns();
    const UnknownRecords coarse_numbers(from, coarse_unknowns.layout),
      finer_numbers(to, finer_unknowns.layout);
    std::map<unsigned int, double> values;
    for (unsigned int i = 0; i < coarse_unknowns.layout.n_local(); ++i)
      if (!coarse_unknowns.strut[i])
        values[coarse_numbers.serial_number(i)] = shape[i];
    for (unsigned int i = 0; i < finer_unknowns.layout.n_owned(); ++i)
      if (!finer_unknowns.strut[i])
        finer.displacement[i] = values.at(finer_numbers.serial_number(i));
    finer_unknowns.layout.update_ghosts(finer.displacement.data());
    return finer.displacement;
  }
} // namespace auxfem
