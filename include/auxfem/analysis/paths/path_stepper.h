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
  /** A point on a path of equilibria with what the way on from it needs. */
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

  /** What came of one step along the path. */
  struct PathStep
  {
    /** Nothing: the step has failed. */
    std::optional<PathPoint> point;
    std::string              why_failed;
    unsigned int             iterations        = 0;
    double                   relative_residual = 0;
    /** How far the point lies off the tangent (m, 1). */
    double deviation = 0, deviation_of_load = 0;
  };

  /**
   * Steps from one equilibrium to another on a path. All functions are
   * collective.
   */
  class PathStepper
  {
  public:
    /** @p solver must outlive the object. */
    PathStepper(TangentSolver &solver, const NewtonParameters &parameters);

    /**
     * The point at @p solution, an equilibrium, from which the path goes on with
     * rising load factor or, if @p is_reversed, with falling one. Throws
     * InputError where no load acts, ComputationError where there is no
     * tangent.
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
     * The direction that the stiffness at the point last found resists least,
     * of unit length and with its largest entry positive, and its eigenvalue's
     * size (N/m); nothing where the stiffness is singular to the last digit.
     */
    std::optional<std::pair<Vector, double>> softest();

    /**
     * Whether the eigenvalue of softest() is round-off, below 1e-12 of the
     * largest stiffness, so that its sign says nothing: as in the direction in
     * which a buckled column with a round section goes round its axis.
     */
    bool is_neutral();

    /**
     * How much of the loads at @p point, which was found last, works on the
     * null vector of the transposed stiffness: the cosine of the angle between
     * both, moments measured by the mean strut length. Zero where another
     * branch crosses, not where the load factor turns round. Nothing where the
     * stiffness is singular to the last digit.
     */
    std::optional<double> part_of_loads(const PathPoint &point);

    /** As Newton::restart(). */
    void restart()
    {
      newton.restart();
    }

    const PathMetric &metric() const
    {
      return of_path;
    }

  private:
    /** softest(), before it is made a shape; of the matrix that is there. */
    std::optional<double> find_softest(Vector &mode);
    /** Loads in free rows at @p point, those of prescribed motions too. */
    Vector loads_at(const PathPoint &point) const;
    /** Puts the first guess of a step into its end. */
    void predict(const Evaluation  &step,
                 const PathTangent &prediction,
                 double             length) const;
    /** Of the equilibrium at evaluation.to, in the sense of @p way; also finds
     * what PathPosition says of the stiffness. Nothing if that fails. */
    std::optional<PathTangent> find_tangent(const Evaluation        &evaluation,
                                            const EvaluationResults &results,
                                            const Vector            *way);
    /** Solves the step that has been predicted. @param end of it, is moved from
     * @param way in whose sense the path goes on */
    PathStep solve(const Evaluation &step,
                   Solution         &end,
                   const Vector     &way,
                   AddedEquation    *arc_length);

    TangentSolver      &solver;
    const Equations    &equations;
    Newton              newton;
    ModeSpace           space;
    const PathMetric    of_path;
    const NodeRotations rotations;
    const QuasiStatic   rule;
  };

  /**
   * How far the next point of a path lies: such that it is off the tangent by
   * no more than the resolution, and that Newton's method finds it soon.
   */
  class PathStepLength
  {
  public:
    /** @param resolution as PathDefinition::resolution
     * @param first length (m) */
    PathStepLength(double resolution, double first);

    double length() const ///< of the next step (m)
    {
      return next;
    }


    /** Makes the next step no longer than @p most (m). */
    void limit(const double most)
    {
      next = std::min(next, most);
    }

    /** Takes note of a point of the path: its distance from rest (m), its load
     * factor. */
    void reached(double distance, double load_factor);

    /**
     * Whether @p step, to a point at @p distance (m) from rest, is to be accepted;
     * sets the length of the next attempt either way.
     * @param turn product of the directions at both ends
     */
    bool judge(const PathStep &step, double distance, double turn);

    /** On another branch, where @p first is the next length (m). */
    void begin_anew(double first);

    /** No point was found; sets the length of the next attempt. */
    void failed();

    /** Whether the next attempt is too short to be made. */
    bool is_exhausted() const
    {
      return next < smallest;
    }

    void serialize(CheckpointArchive &archive);

  private:
    const double resolution;
    double       next, smallest;
    /** As far as is known from steps that have failed (m). */
    double too_long         = std::numeric_limits<double>::infinity();
    double largest_distance = 0, largest_load = 0;
  };
} // namespace auxfem

#endif
