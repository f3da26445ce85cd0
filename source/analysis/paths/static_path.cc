#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/paths/path_stepper.h>
#include <auxfem/analysis/paths/singular_points.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/output/overview.h>
#include <auxfem/output/run_output.h>
#include <auxfem/output/singular_point_files.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/state/interruption.h>
#include <auxfem/time/schemes/static.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace auxfem
{
  namespace
  {
    /** Plan of a path; viscous processes are relaxed. */
    RunPlan plan_of_path(const Scene &scene)
    {
      RunPlan plan(scene);
      plan.time.scheme             = std::make_shared<QuasiStatic>();
      plan.time.relative_tolerance = std::nullopt;
      // A fresh tangent needs few iterations, which permits long steps.
      plan.newton.keep_factorization = false;
      plan.solver.needs_inertia      = true;
      plan.effects.inertia           = Switch::automatic;
      plan.effects.large_rotation    = Switch::on;
      plan.has_initial_velocities    = false;
      return plan;
    }

    /** Traces the equilibria of a run that has started. */
    class EquilibriumPath
    {
    public:
      /** Starts the path; throws as PathStepper::start(). */
      explicit EquilibriumPath(LatticeRun &run)
        : run(run)
        , path(run.scene.path)
        , stepper(run.solver(), run.model.plan.newton)
        , point(stepper.start(run.solution, path.reversed_loads))
        // The load hardly changes along the tangent of a straight cable.
        , lengths(path.resolution,
                  std::min(path.first_increment /
                             std::abs(point.tangent.load_rate),
                           run.model.mean_strut_length))
      {}

      /** Continues a run from @p checkpoint. */
      EquilibriumPath(LatticeRun &run, const CheckpointData &checkpoint)
        : run(run)
        , path(run.scene.path)
        , stepper(run.solver(), run.model.plan.newton)
        , point{{run.solution.state, run.equations.make_results()}, {}}
        , lengths(path.resolution, 0)
      {
        CheckpointArchive archive =
          CheckpointArchive::restoring(checkpoint,
                                       run.model.numbering.layout());
        serialize(archive);
      }

      /**
       * Traces the path to the end set by the scene. Throws Interrupted after a
       * signal.
       */
      void follow(Recorder &recorder)
      {
        const MPI_Comm communicator =
          run.model.numbering.layout().communicator();
        while (!has_ended())
          {
            if (const int signal = pending_signal(communicator); signal != 0)
              {
                recorder.keep_checkpoint();
                throw Interrupted(signal);
              }
            // A resumed longer path repeats the last step, which the end has
            // shortened, so a checkpoint precedes it too.
            if (run.scene.output.checkpoints > 0)
              recorder.store_checkpoint(checkpoint(recorder));
            advance(recorder);
          }
        recorder.keep_checkpoint();
      }

      /** Findings on the end of the path. */
      std::vector<Finding> findings() const
      {
        std::vector<Finding> all;
        if (unstable_branch != 0)
          {
            std::ostringstream text;
            text
              << "Path/Branch = stable: the branch entered at load factor "
              << unstable_branch
              << " is unstable, too, because several eigenvalues vanish there "
                 "at once. Add an imperfection, which selects one of the "
                 "branches.";
            all.push_back(
              {Verdict::doubtful, text.str(), point.arc_length(), ""});
          }
        if (has_reached_end())
          return all;
        std::ostringstream text;
        text << "The path ended after Path/Points = " << path.max_points
             << " points, at load factor " << point.load_factor()
             << ", before it reached Largest load factor"
             << (path.largest_displacement ? " or Largest displacement" : "")
             << ".";
        all.push_back({Verdict::doubtful, text.str(), point.arc_length(), ""});
        return all;
      }

    private:
      void serialize(CheckpointArchive &archive)
      {
        point.tangent.serialize(run.model.numbering, archive);
        lengths.serialize(archive);
        archive.values("path: bifurcations so far, load factor of an unstable "
                       "branch",
                       n_bifurcations,
                       unstable_branch);
      }

      CheckpointData checkpoint(Recorder &recorder)
      {
        CheckpointData    taken = run.checkpoint(recorder);
        CheckpointArchive archive =
          CheckpointArchive::saving(taken, run.model.numbering.layout());
        serialize(archive);
        stepper.restart();
        // The state may have gained ghost unknowns.
        point.solution.state = run.solution.state;
        return taken;
      }

      /**
       * Advances by one point, past all singular points in between, or onto
       * another branch at one of them.
       */
      void advance(Recorder &recorder)
      {
        StepReport report;
        PathPoint  next = next_point(report);
        for (LocatedPoint &located :
             find_singular_points(stepper, point, next, report.dt))
          {
            if (is_beyond_end(located.point))
              break;
            recorder.singular_point(located.point.solution, located.singular);
            if (!leaves_branch_at(located.singular))
              continue;
            point = std::move(located.point);
            // The work integral uses the curvature; the path has a kink here.
            point.solution.state.before.reset();
            accept(branch_off(located.singular, report), report, recorder);
            return;
          }
        if (is_beyond_end(next))
          end_at_largest_load(report.dt, next);
        accept(std::move(next), report, recorder);
      }

      /**
       * Limits the step length if only the sign of the determinant is known,
       * because that misses two changes in one step.
       */
      void limit_step_by_load()
      {
        const PathPosition &at = point.position();
        if (at.determinant_sign && !at.n_negative)
          lengths.limit(path.resolution * path.largest_load_factor /
                        std::abs(point.tangent.load_rate));
      }

      /** Computes the next point that is close enough to the tangent. */
      PathPoint next_point(StepReport &report)
      {
        limit_step_by_load();
        while (true)
          {
            report.dt     = lengths.length();
            PathStep step = stepper.step(point, point.tangent, report.dt);
            count(step, report);
            if (is_near_enough(step))
              return std::move(*step.point);
            ++report.retries;
            ++run.work().retries;
            if (lengths.is_exhausted())
              throw_lost_path(report.dt, step.failure_reason);
          }
      }

      void count(const PathStep &step, StepReport &report)
      {
        report.iterations += step.iterations;
        run.work().iterations += step.iterations;
        report.relative_residual = step.relative_residual;
      }

      /** Whether the step is accepted; also sets the next length. */
      bool is_near_enough(const PathStep &step)
      {
        if (!step.point)
          {
            lengths.failed();
            return false;
          }
        const PathMetric &metric = stepper.metric();
        return lengths.judge(step,
                             metric.length(
                               step.point->solution.state.displacement),
                             metric.product(point.tangent.direction,
                                            step.point->tangent.direction));
      }

      [[noreturn]] void throw_lost_path(const double       length,
                                        const std::string &failure_reason) const
      {
        std::ostringstream message;
        message
          << "The path of equilibria is lost at load factor "
          << point.load_factor() << ", arc length " << point.arc_length()
          << " m: Newton's method found no further point, even at a distance "
             "of "
          << length << " m"
          << (failure_reason.empty() ? ", because the path turns too sharply"
                                     : ": " + failure_reason)
          << ".\nAll points until then are in the output folder. Try finer "
             "elements, another Path/Branch or an imperfection.";
        throw ComputationError(message.str());
      }

      bool is_beyond_end(const PathPoint &reached) const
      {
        return std::abs(reached.load_factor()) > path.largest_load_factor;
      }

      /**
       * Replaces @p next, at the distance @p length (m), by the point with the
       * largest load factor if Newton's method converges.
       */
      void end_at_largest_load(const double length, PathPoint &next)
      {
        const double target =
          std::copysign(path.largest_load_factor, next.load_factor());
        const double part = (target - point.load_factor()) /
          (next.load_factor() - point.load_factor());
        PathStep last = stepper.step_to_load(point, part * length, target);
        if (last.point)
          next = std::move(*last.point);
      }

      bool leaves_branch_at(const SingularPoint &singular)
      {
        if (singular.kind != SingularPoint::Kind::bifurcation ||
            singular.null_vector.empty())
          return false;
        ++n_bifurcations;
        using Branch = PathDefinition::Branch;
        return path.branch == Branch::numbered
          ? n_bifurcations == path.branch_number
          : path.branch == Branch::stable && singular.destabilizes();
      }

      /** Computes a point on the crossing branch. */
      PathPoint branch_off(const SingularPoint &singular, StepReport &report)
      {
        PathTangent across{singular.null_vector, 0.};
        if (path.reverse_branch)
          scale(-1., across.direction);
        // Shorter steps would drown in the round-off of a soft direction.
        constexpr double       min_branch_step = 1e-3;
        constexpr unsigned int n_attempts      = 8;
        std::string            failure_reason;
        report.dt =
          std::max(report.dt, min_branch_step * run.model.mean_strut_length);
        for (unsigned int i = 0; i < n_attempts; ++i, report.dt /= 2)
          {
            PathStep step = stepper.step(point, across, report.dt);
            count(step, report);
            if (step.point)
              {
                lengths.restart_branch(report.dt);
                leave_unstable_branches(singular, *step.point, report);
                return std::move(*step.point);
              }
            failure_reason = step.failure_reason;
          }
        throw ComputationError(
          "Branch switching failed at a bifurcation: " + failure_reason +
          ".\nAll points until then are in the output folder. Choose another "
          "Path/Branch, or add an imperfection.");
      }

      /**
       * With several null vectors the branch along one of them may be unstable
       * in another. Steps from @p reached along that one, too.
       */
      void leave_unstable_branches(const SingularPoint &singular,
                                   PathPoint           &reached,
                                   StepReport          &report)
      {
        const auto is_unstable = [&]() {
          return path.branch == PathDefinition::Branch::stable &&
            SingularPoint{singular.kind,
                          singular.before,
                          reached.position(),
                          {}}
              .destabilizes();
        };
        for (unsigned long i = 1; i < singular.multiplicity() && is_unstable();
             ++i)
          {
            auto softest_mode = stepper.softest_mode();
            if (!softest_mode)
              break;
            PathStep further =
              stepper.step(reached,
                           PathTangent{std::move(softest_mode->first), 0.},
                           report.dt);
            count(further, report);
            if (!further.point)
              break;
            reached = std::move(*further.point);
          }
        if (unstable_branch == 0 && is_unstable() && !stepper.is_neutral())
          unstable_branch = point.load_factor();
      }

      /** Accepts the step to @p next. */
      void
      accept(PathPoint &&next, const StepReport &report, Recorder &recorder)
      {
        State           &reached = next.solution.state;
        const Evaluation step =
          Evaluation::static_step(point.solution.state,
                                  reached,
                                  reached.time - point.arc_length());
        run.watches().step(step, next.solution.results, run.solver());
        reached.step = run.solution.state.step + 1;
        run.equations.update_couplings(reached);
        lengths.reached(stepper.metric().length(reached.displacement),
                        next.load_factor());
        point              = std::move(next);
        run.solution.state = point.solution.state;
        std::swap(run.solution.results, point.solution.results);
        ++run.work().steps;
        recorder.step(run.solution, report);
      }

      bool has_ended() const
      {
        return has_reached_end() ||
          point.solution.state.step >= path.max_points;
      }

      /** Whether the last point is the requested end of the path. */
      bool has_reached_end() const
      {
        const State &state = point.solution.state;
        return std::abs(point.load_factor()) >= path.largest_load_factor ||
          (path.largest_displacement &&
           largest_motion(run.model, state.displacement).first >=
             *path.largest_displacement);
      }

      LatticeRun           &run;
      const PathDefinition &path;
      PathStepper           stepper;
      PathPoint             point; ///< the last one
      PathStepLength        lengths;
      unsigned int          n_bifurcations = 0;
      /**
       * Load factor at which the path took a less stable branch; 0: nowhere.
       */
      double unstable_branch = 0;
    };

    RunResult run_path(const Scene   &scene,
                       const MPI_Comm communicator,
                       Recorder      &recorder)
    {
      LatticeRun run(plan_of_path(scene), communicator);
      // A structure that is no mechanism is stable at rest.
      if (!scene.time.static_start)
        {
          run.solution.state.path->n_negative       = 0;
          run.solution.state.path->determinant_sign = 1;
        }
      // The recorder releases its checkpoint when the run continues.
      const CheckpointData *const restart_checkpoint =
        recorder.restart_checkpoint();
      std::optional<CheckpointData> checkpoint;
      if (restart_checkpoint != nullptr)
        checkpoint = *restart_checkpoint;
      return run.run(recorder, [&](Recorder &run_recorder) {
        EquilibriumPath path =
          checkpoint ? EquilibriumPath(run, *checkpoint) : EquilibriumPath(run);
        path.follow(run_recorder);
        return path.findings();
      });
    }

    void check_path(const Scene &scene, const MPI_Comm communicator)
    {
      LatticeRun run(plan_of_path(scene), communicator);
      run.prepare();
      require_existing_columns(scene, run.lattice);
      show_lattice(scene, run.equations);
    }
  } // namespace

  AnalysisEntry static_path_entry()
  {
    return {"static path",
            "Equilibria of a lattice by arc length, through limit points and "
            "bifurcations.",
            [](const Scene &scene) {
              return scene.analysis == Analysis::static_path;
            },
            [](const Scene         &scene,
               const MPI_Comm       communicator,
               const FolderOptions &options) {
              return run_path(scene,
                              communicator,
                              *make_run_output(scene, communicator, options));
            },
            run_path,
            check_path,
            path_contents().names()};
  }
} // namespace auxfem
