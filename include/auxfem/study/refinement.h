#ifndef auxfem_study_refinement_h
#define auxfem_study_refinement_h

#include <auxfem/study/quantities.h>
#include <auxfem/study/settings.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** What becomes finer from one simulation to the next. */
  enum class Refined
  {
    mesh,
    time_step,
    time_tolerance,
    newton_tolerance,
    mesh_and_time_step
  };

  /** E.g. `time step`. */
  const std::string &name_of(Refined refined);

  /**
   * Simulations that differ in what is refined, from coarse to fine, and two
   * that are finer than all of them, the finest last, which they are measured
   * against; none where exact values are known of all quantities.
   */
  struct Refinement
  {
    Refined refined;
    /** What the runs have in common, e.g. `order 2`. */
    std::string           title;
    std::vector<Settings> runs;
    std::vector<Settings> references;
  };

  /**
   * The refinements that the study of @p scene asks for: of the mesh for each
   * order, of the time step for each scheme, of Newton's tolerance.
   */
  std::vector<Refinement> refinements_of(const Scene &scene);

  /** How far @p settings are refined: halves when elements, time step or
   * tolerance do. */
  double coarseness(Refined refined, const Settings &settings);

  /** The error of one quantity in one run of a refinement. */
  struct RunError
  {
    /** Relative; none for a run that failed. */
    std::optional<double> error;
    /** Of the fall of the error from the run before; none where either error is
     * not well above that of the reference. */
    std::optional<double> order;
    /**
     * Grid convergence index: error bound relative to the value, estimated from
     * this run and the two before, without a reference (P. J. Roache,
     * Verification and Validation in Computational Science and Engineering,
     * 1998, eq. 5.6.1, with the safety factor 1.25 of three meshes).
     */
    std::optional<double> convergence_index;
    /** The value, of quantities that are one number. */
    std::optional<double> value;
  };

  /** One quantity in all runs of a refinement. */
  struct RefinementErrors
  {
    std::vector<RunError> runs;
    /** Relative, estimated from both references; none if the value is exact, a
     * reference failed or there is none. */
    std::optional<double> of_reference;

    /** Whether the reference is better than a guess; it is not where the
     * quantity is zero but for round-off, as by symmetry. */
    bool is_resolved() const
    {
      return of_reference.value_or(0) < unresolved_error;
    }
  };

  /**
   * Errors of @p quantity.
   * @param runs in the order of Refinement::runs, then references.
   * @param extrapolates whether the reference is the limit that both point to.
   */
  RefinementErrors errors_of(const Refinement               &refinement,
                             const QuantityDefinition       &quantity,
                             const std::vector<MeasuredRun> &runs,
                             double                          end_time,
                             bool                            extrapolates);

  /** Settings that a study recommends for an error. */
  struct Recommendation
  {
    Settings settings;
    /** What the user should know of them, in brackets after them. */
    std::string remark;
  };

  /** The cheapest for a relative error of at most @p target, if there is one. */
  using Recommend = std::function<std::optional<Recommendation>(double target)>;

  /**
   * Lines of what @p recommend says for errors from 10 % down to a ten-thousandth
   * of a percent, ready for the command line; each recommendation with the
   * smallest error that it serves for.
   */
  std::string recommendations_text(const Scene     &scene,
                                   const Recommend &recommend);
} // namespace auxfem

#endif
