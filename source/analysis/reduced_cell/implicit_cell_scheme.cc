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

    /** Sum of the sizes of the terms of @p M times @p a, row by row. */
    CellVector size_of_terms(const CellMatrix &M, const CellVector &a)
    {
      CellVector result;
      for (unsigned int i = 0; i < 2; ++i)
        result[i] = std::abs(M[i][0] * a[0]) + std::abs(M[i][1] * a[1]);
      return result;
    }

    /**
     * A scheme of lattices on the two unknowns, with Newton's method and
     * the exact tangent in every iteration.
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
        equations().refuse_singular(trial.displacement[0]);
        trial.step = state.step + 1;
        state      = trial;
        return cell.accept(motion_of(state));
      }

      unsigned long work() const override
      {
        return iterations;
      }

    private:
      /** The equations at the trial state. */
      struct Evaluation
      {
        CellVector        residual; ///< M q'' + h + (f1 + F) b
        ConnectorResponse connector;
        double            size;  ///< of the residual, in force units (N)
        double            scale; ///< of the terms it is the sum of (N)
      };

      const CellEquations &equations() const
      {
        return cell.equations();
      }

      double in_force_units(const CellVector &v) const
      {
        const double of_moment =
          std::abs(v[0]) / scene.reduced_cell->bar_length;
        // std::max would drop a NaN in its second place.
        return std::isfinite(of_moment) ? std::max(std::abs(v[1]), of_moment)
                                        : of_moment;
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

        Evaluation now;
        now.connector      = cell.connector(motion);
        const double force = cell.load() + now.connector.force;
        now.residual       = M * a + h + force * b;
        now.size           = in_force_units(now.residual);
        now.scale = in_force_units(size_of_terms(M, a)) + in_force_units(h) +
          std::abs(cell.load()) + std::abs(now.connector.force);
        return now;
      }

      /** Derivative of the residual by an increment of the unknowns. */
      CellMatrix tangent(const Evaluation     &now,
                         const TangentFactors &factors) const
      {
        const CellMotion motion        = motion_of(trial);
        const double     rotation      = motion.position[0];
        const double     rotation_rate = motion.velocity[0];
        const CellVector b             = equations().lever(rotation);
        const CellVector b_by_rotation = equations().lever_derivative(rotation);
        const double     force         = cell.load() + now.connector.force;

        CellMatrix       K = factors.mass * equations().mass(rotation);
        const CellVector by_turn =
          equations().mass_derivative(rotation) * pair(*trial.acceleration) +
          equations().velocity_force_by_rotation(rotation, rotation_rate) +
          force * b_by_rotation +
          now.connector.damping * (b_by_rotation * motion.velocity) * b;
        const CellVector by_rate =
          equations().velocity_force_by_rate(rotation, rotation_rate);
        const double along = factors.stiffness * now.connector.stiffness +
          factors.damping * now.connector.damping;
        for (unsigned int i = 0; i < 2; ++i)
          {
            K[i][0] +=
              factors.stiffness * by_turn[i] + factors.damping * by_rate[i];
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
            const Evaluation now = evaluate();
            if (!std::isfinite(now.size))
              give_up("the residual is not finite");
            const double scale = std::max(largest_scale, now.scale);
            // Below the last digit of its terms no residual can come.
            const double floor =
              16 * std::numeric_limits<double>::epsilon() * now.scale;
            if (now.size <= scene.newton.tolerance * scale + floor)
              {
                largest_scale = scale;
                return;
              }
            if (iteration == scene.newton.maximum_iterations)
              give_up("Newton's method has not converged in " +
                      std::to_string(iteration) + " iterations");
            const CellMatrix K = tangent(now, factors);
            if (determinant(K) == 0)
              give_up("the tangent is singular");
            const CellVector solution = invert(K) * (-now.residual);
            increment[0]              = solution[0];
            increment[1]              = solution[1];
            scheme.correct(state, increment, cell.dt(), trial);
            ++iterations;
          }
      }

      [[noreturn]] void give_up(const std::string &reason)
      {
        // Just before, rates grow without bounds and no iteration converges.
        constexpr double just_before = 4; // steps
        equations().refuse_singular(state.displacement[0] +
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
