#ifndef auxfem_analysis_paths_path_stepper_h
#define auxfem_analysis_paths_path_stepper_h

#include <auxfem/analysis/paths/arc_length.h>
#include <auxfem/equations/equations.h>
#include <auxfem/equations/mode_space.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/time/schemes/static.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

namespace auxfem
{
  /** A point on an equilibrium path with the tangent for the next predictor. */
  struct PathPoint
  {
    Solution    solution;
    PathTangent tangent;

    double load_factor() const
    {
      return solution.state.path->load_factor;
    }

    double arc_length() const
    {
      return solution.state.time;
    }

    const PathPosition &position() const
    {
      return *solution.state.path;
    }
  };

  /** Outcome of one step along the path. */
  struct PathStep
  {
    /** Empty if the step has failed. */
    std::optional<PathPoint> point;
    std::string              failure_reason;
    unsigned int             iterations        = 0;
    double                   relative_residual = 0;
    /** Distance of the point from the tangent (m, 1). */
    double deviation = 0, load_deviation = 0;
  };

  /**
   * Arc-length continuation from one equilibrium to the next. All functions are
   * collective.
   */
  class PathStepper
  {
  public:
    /** @p solver must outlive the object. */
    PathStepper(TangentSolver &solver, const NewtonParameters &parameters);

    /**
     * First point of the path, at the equilibrium @p solution. The load factor
     * increases from there, or decreases if @p is_reversed. Throws InputError
     * if no load acts, ComputationError if there is no tangent.
     */
    PathPoint start(const Solution &solution, bool is_reversed);

    /** The point at the distance @p length (m) along @p prediction of @p from. */
    PathStep
    step(const PathPoint &from, const PathTangent &prediction, double length);

    /** The point with @p load_factor, which lies about @p length (m) from
     * @p from. */
    PathStep
    step_to_load(const PathPoint &from, double length, double load_factor);

    /**
     * Eigenvector of the smallest eigenvalue in magnitude of the stiffness at
     * the point last found, and that magnitude (N/m). It has unit length and a
     * positive largest entry. Empty if the stiffness is exactly singular.
     */
    std::optional<std::pair<Vector, double>> softest_mode();

    /**
     * Whether the eigenvalue of softest_mode() is below 1e-12 of the largest
     * stiffness, so that its sign is round-off. An example is a buckled column
     * of round section, which can turn about its axis.
     */
    bool is_neutral();

    /**
     * Cosine between the loads at @p point, the point last found, and the null
     * vector of the transposed stiffness; moments are divided by the mean strut
     * length. It is zero at a bifurcation, not at a limit point. Empty if the
     * stiffness is exactly singular.
     */
    std::optional<double> load_projection(const PathPoint &point);

    /** As Newton::restart(). */
    void restart()
    {
      newton.restart();
    }

    const PathMetric &metric() const
    {
      return path_metric;
    }

  private:
    /**
     * As softest_mode() for the current matrix, before conversion to a shape.
     */
    std::optional<double> find_softest_vector(Vector &mode);
    /**
     * Loads in free rows at @p point, including those from prescribed motions.
     */
    Vector loads_at(const PathPoint &point) const;
    /** Writes the predictor of a step to its end. */
    void predict(const Evaluation  &step,
                 const PathTangent &prediction,
                 double             length) const;
    /**
     * Tangent at the equilibrium evaluation.to in the sense of @p sense; also
     * sets the stiffness data of PathPosition. Empty on failure.
     */
    std::optional<PathTangent> find_tangent(const Evaluation        &evaluation,
                                            const EvaluationResults &results,
                                            const Vector            *sense);
    /**
     * Solves the predicted step.
     * @param end state at its end, moved from
     * @param sense direction that fixes the sense of the new tangent
     */
    PathStep solve(const Evaluation &step,
                   Solution         &end,
                   const Vector     &sense,
                   AddedEquation    *arc_length);

    TangentSolver      &solver;
    const Equations    &equations;
    Newton              newton;
    ModeSpace           space;
    const PathMetric    path_metric;
    const NodeRotations rotations;
    const QuasiStatic   rule;
  };

  /**
   * Step-size controller of a path. It keeps the deviation from the tangent
   * below the resolution and the number of Newton iterations low.
   */
  class PathStepLength
  {
  public:
    /** @param resolution as PathDefinition::resolution
     * @param first length (m) */
    PathStepLength(double resolution, double first);

    double length() const ///< of the next step (m)
    {
      return next_length;
    }

    /** Limits the next step to @p most (m). */
    void limit(const double most)
    {
      next_length = std::min(next_length, most);
    }

    /**
     * Records a point of the path by its distance from rest (m) and its load
     * factor.
     */
    void reached(double distance, double load_factor);

    /**
     * Whether to accept @p step to a point at @p distance (m) from rest; also
     * sets the length of the next attempt.
     * @param turn inner product of the directions at both ends
     */
    bool judge(const PathStep &step, double distance, double turn);

    /** Restarts on another branch with the step length @p first (m). */
    void restart_branch(double first);

    /** Shortens the next attempt after a step without solution. */
    void failed();

    /** Whether the next attempt would be too short. */
    bool is_exhausted() const
    {
      return next_length < min_length;
    }

    void serialize(CheckpointArchive &archive);

  private:
    const double resolution;
    double       next_length, min_length;
    /** Shortest length of failed steps (m). */
    double length_limit     = std::numeric_limits<double>::infinity();
    double largest_distance = 0, largest_load = 0;
  };
} // namespace auxfem

#endif
