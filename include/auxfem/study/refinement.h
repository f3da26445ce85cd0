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
  /** Parameter that is refined from one simulation to the next. */
  enum class RefinedParameter
  {
    mesh,
    time_step,
    time_tolerance,
    newton_tolerance,
    mesh_and_time_step
  };

  /** Name of the parameter, e.g. `time step`. */
  const std::string &name_of(RefinedParameter refined);

  /**
   * Simulations that differ in one refined parameter, from coarse to fine, and
   * two finer references, the finest last. There are no references if the exact
   * values of all quantities are known.
   */
  struct Refinement
  {
    RefinedParameter refined;
    /** Common property of the runs, e.g. `order 2`. */
    std::string           title;
    std::vector<Settings> runs;
    std::vector<Settings> references;
  };

  /**
   * Refinements that the study of @p scene requests: mesh for each order, time
   * step for each scheme, tolerances.
   */
  std::vector<Refinement> refinements_of(const Scene &scene);

  /**
   * Value of the refined parameter of @p settings, proportional to element
   * length, time step or tolerance.
   */
  double coarseness(RefinedParameter refined, const Settings &settings);

  /** The error of one quantity in one run of a refinement. */
  struct RunError
  {
    /** Relative error; empty for a failed run. */
    std::optional<double> error;
    /**
     * Convergence order relative to the previous run; empty unless both errors
     * clearly exceed that of the reference.
     */
    std::optional<double> order;
    /**
     * Grid convergence index: error bound relative to the value, estimated from
     * this run and the two before, without a reference (P. J. Roache,
     * Verification and Validation in Computational Science and Engineering,
     * 1998, eq. 5.6.1, with the safety factor 1.25 of three meshes).
     */
    std::optional<double> convergence_index;
    /** Value of a scalar quantity. */
    std::optional<double> value;
  };

  /** One quantity in all runs of a refinement. */
  struct RefinementErrors
  {
    std::vector<RunError> runs;
    /**
     * Relative error of the reference, estimated from both references; empty if
     * the value is exact or a reference failed.
     */
    std::optional<double> reference_error;

    /**
     * Whether the reference is usable. It is not if the quantity is zero up to
     * round-off, for example by symmetry.
     */
    bool is_resolved() const
    {
      return reference_error.value_or(0) < unresolved_error;
    }
  };

  /**
   * Errors of @p quantity.
   * @param runs results in the order of Refinement::runs, then references
   * @param extrapolates whether the Richardson limit is the reference
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
    /** Remark for the user, printed in brackets. */
    std::string remark;
  };

  /**
   * Returns the cheapest settings for a relative error of at most @p target, if
   * any.
   */
  using Recommender =
    std::function<std::optional<Recommendation>(double target)>;

  /**
   * Lines with the results of @p recommend for errors from 10 % to 0.0001 %, as
   * command line options; each with the smallest error that it meets.
   */
  std::string recommendations_text(const Scene       &scene,
                                   const Recommender &recommend);
} // namespace auxfem

#endif
