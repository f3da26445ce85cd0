#include <auxfem/analysis/reduced_cell/cell_scheme.h>
#include <auxfem/parameters/errors.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    State state_of_cell(const ImplicitScheme &scheme)
    {
      StateLayout layout;
      layout.velocity                 = true;
      layout.acceleration             = true;
      layout.algorithmic_acceleration = scheme.uses_algorithmic_acceleration();
      return {2, layout};
    }

    CellVector pair(const Vector &vector)
    {
      CellVector result;
      result[0] = vector[0];
      result[1] = vector[1];
      return result;
    }

    CellMotion motion_of(const State &state)
    {
      return {pair(state.displacement), pair(*state.velocity)};
    }

    /** Sum of the absolute terms of @p M times @p a, row by row. */
    CellVector absolute_terms(const CellMatrix &M, const CellVector &a)
    {
      CellVector result;
      for (unsigned int i = 0; i < 2; ++i)
        result[i] = std::abs(M[i][0] * a[0]) + std::abs(M[i][1] * a[1]);
      return result;
    }

    /**
     * Applies a time scheme of lattices to the two unknowns, with the full
     * Newton method.
     */
    class ImplicitCellScheme : public CellScheme
    {
    public:
      explicit ImplicitCellScheme(const Scene &scene)
        : scene(scene)
        , scheme(scene.time.implicit_scheme())
        , cell(scene)
        , state(state_of_cell(scheme))
        , trial(state)
        , increment(state.displacement.size())
      {}

      CellSample start() override
      {
        cell.begin_step(0);
        const CellMotion motion = motion_of(state);
        const double     force  = cell.load() + cell.connector(motion).force;
        const CellVector a      = equations().acceleration(motion, force);
        for (unsigned int i = 0; i < 2; ++i)
          (*state.acceleration)[i] = a[i];
        if (state.algorithmic_acceleration)
          *state.algorithmic_acceleration = *state.acceleration;
        return cell.accept(motion);
      }

      CellSample advance() override
      {
        cell.begin_step(state.step + 1);
        scheme.predict(state, cell.dt(), trial);
        solve();
        equations().require_regular_mass(trial.displacement[0]);
        trial.step = state.step + 1;
        state      = trial;
        return cell.accept(motion_of(state));
      }

      unsigned long work() const override
      {
        return iterations;
      }

    private:
      /** Residual and its scale at the trial state. */
      struct Evaluation
      {
        CellVector        residual; ///< M q'' + h + (f1 + F) b
        ConnectorResponse connector;
        double            size;  ///< residual norm in force units (N)
        double            scale; ///< sum of the norms of its terms (N)
      };

      const CellEquations &equations() const
      {
        return cell.equations();
      }

      double in_force_units(const CellVector &v) const
      {
        const double moment_part =
          std::abs(v[0]) / scene.reduced_cell->bar_length;
        // std::max drops a NaN in its second argument.
        return std::isfinite(moment_part)
          ? std::max(std::abs(v[1]), moment_part)
          : moment_part;
      }

      Evaluation evaluate()
      {
        const CellMotion motion   = motion_of(trial);
        const double     rotation = motion.position[0];
        const CellMatrix M        = equations().mass(rotation);
        const CellVector a        = pair(*trial.acceleration);
        const CellVector h =
          equations().velocity_force(rotation, motion.velocity[0]);
        const CellVector b = equations().lever(rotation);

        Evaluation evaluation;
        evaluation.connector = cell.connector(motion);
        const double force   = cell.load() + evaluation.connector.force;
        evaluation.residual  = M * a + h + force * b;
        evaluation.size      = in_force_units(evaluation.residual);
        evaluation.scale     = in_force_units(absolute_terms(M, a)) +
          in_force_units(h) + std::abs(cell.load()) +
          std::abs(evaluation.connector.force);
        return evaluation;
      }

      /** Derivative of the residual by an increment of the unknowns. */
      CellMatrix tangent(const Evaluation     &evaluation,
                         const TangentFactors &factors) const
      {
        const CellMotion motion        = motion_of(trial);
        const double     rotation      = motion.position[0];
        const double     rotation_rate = motion.velocity[0];
        const CellVector b             = equations().lever(rotation);
        const CellVector b_by_rotation = equations().lever_derivative(rotation);
        const double     force = cell.load() + evaluation.connector.force;

        CellMatrix       K = factors.mass * equations().mass(rotation);
        const CellVector by_rotation =
          equations().mass_derivative(rotation) * pair(*trial.acceleration) +
          equations().velocity_force_by_rotation(rotation, rotation_rate) +
          force * b_by_rotation +
          evaluation.connector.damping * (b_by_rotation * motion.velocity) * b;
        const CellVector by_rate =
          equations().velocity_force_by_rate(rotation, rotation_rate);
        const double along =
          factors.stiffness * evaluation.connector.stiffness +
          factors.damping * evaluation.connector.damping;
        for (unsigned int i = 0; i < 2; ++i)
          {
            K[i][0] +=
              factors.stiffness * by_rotation[i] + factors.damping * by_rate[i];
            for (unsigned int j = 0; j < 2; ++j)
              K[i][j] += along * b[i] * b[j];
          }
        return K;
      }

      void solve()
      {
        const TangentFactors factors = scheme.factors(state, cell.dt());
        for (unsigned int iteration = 0;; ++iteration)
          {
            const Evaluation evaluation = evaluate();
            if (!std::isfinite(evaluation.size))
              throw_failed_step("the residual is not finite");
            const double scale = std::max(largest_scale, evaluation.scale);
            // Round-off of its terms bounds the residual from below.
            const double floor =
              16 * std::numeric_limits<double>::epsilon() * evaluation.scale;
            if (evaluation.size <= scene.newton.tolerance * scale + floor)
              {
                largest_scale = scale;
                return;
              }
            if (iteration == scene.newton.maximum_iterations)
              throw_failed_step("Newton's method has not converged in " +
                                std::to_string(iteration) + " iterations");
            const CellMatrix K = tangent(evaluation, factors);
            if (determinant(K) == 0)
              throw_failed_step("the tangent is singular");
            const CellVector solution = invert(K) * (-evaluation.residual);
            increment[0]              = solution[0];
            increment[1]              = solution[1];
            scheme.correct(state, increment, cell.dt(), trial);
            ++iterations;
          }
      }

      [[noreturn]] void throw_failed_step(const std::string &reason)
      {
        // Close to the singularity rates grow without bounds and Newton fails.
        constexpr double just_before = 4; // steps
        equations().require_regular_mass(state.displacement[0] +
                                         just_before * cell.dt() *
                                           (*state.velocity)[0]);
        std::ostringstream message;
        message << "The step from t = " << scene.time.time_at(state.step)
                << " s with dt = " << cell.dt() << " s failed: " << reason
                << ".\nAll steps until then are in the output folder. Reduce "
                   "Time/Time step.";
        throw ComputationError(message.str());
      }

      const Scene          &scene;
      const ImplicitScheme &scheme;
      SteppedCell           cell;
      State                 state, trial;
      Vector                increment;
      double                largest_scale = 0; ///< N
      unsigned long         iterations    = 0;
    };
  } // namespace

  std::unique_ptr<CellScheme> make_implicit_cell_scheme(const Scene &scene)
  {
    return std::make_unique<ImplicitCellScheme>(scene);
  }
} // namespace auxfem
