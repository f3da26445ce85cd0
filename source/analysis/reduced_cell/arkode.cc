#include <auxfem/analysis/reduced_cell/cell_equations.h>
#include <auxfem/analysis/reduced_cell/cell_scheme.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/lac/vector.h>
#include <deal.II/sundials/arkode.h>

#include <arkode/arkode_arkstep.h>
#include <sundials/sundials_config.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    using StateVector = dealii::Vector<double>;
    using Ode         = dealii::SUNDIALS::ARKode<StateVector>;

    /** Largest number of evaluations in one step of the scene. */
    constexpr unsigned long max_evaluations = 1000000;

    Ode::AdditionalData settings(const Scene &scene)
    {
      Ode::AdditionalData data;
      data.initial_time      = 0;
      data.final_time        = scene.time.end_time;
      data.initial_step_size = scene.time.step / 100;
      // A period beyond the end gives one output per call.
      data.output_period      = 2 * scene.time.end_time;
      data.minimum_step_size  = 0;
      data.maximum_order      = 8;
      data.relative_tolerance = 1e-12;
      // Tiny displacements at the start matter later.
      data.absolute_tolerance = 1e-15;
      return data;
    }

    /**
     * First-order system for ARKODE. Unknowns are rotation, rise, their rates,
     * the connector's internal variables, the dissipated energy and the work of
     * the load, all under the same error control.
     */
    class ArkodeScheme : public CellScheme
    {
    public:
      explicit ArkodeScheme(const Scene &scene)
        : scene(scene)
        , cell(*scene.reduced_cell)
        , law(*scene.connectors.front().law)
        , y(first_internal + law.n_history() + 2)
        , ode(settings(scene))
      {
        if (law.slips())
          throw InputError(scene.connectors.front().path +
                           ": Time/Scheme = arkode needs a law with "
                           "differential equations, which friction has not. "
                           "Use Time/Scheme = newmark");
        ode.explicit_function =
          [this](const double t, const StateVector &y, StateVector &rates) {
            evaluate(t, y, rates);
            return 0;
          };
        ode.custom_setup = [end = scene.time.time_at(1)](void *memory) {
          // max_evaluations limits the effort, with a message to the user.
          ARKStepSetMaxNumSteps(memory, -1);
#if SUNDIALS_VERSION_MAJOR < 7
          ARKStepSetErrFile(memory, nullptr); // gone in SUNDIALS 7
#endif
          // deal.II sets it from the second call on. Without it ARKODE steps
          // beyond the end of a step and interpolates, losing digits.
          ARKStepSetStopTime(memory, end);
        };
      }

      CellSample start() override
      {
        StateVector rates(y.size());
        evaluate(0, y, rates);
        return sample();
      }

      CellSample advance() override
      {
        evaluations_of_step = 0;
        ode.solve_ode_incrementally(y, scene.time.time_at(step + 1));
        ++step;
        return sample();
      }

      unsigned long work() const override
      {
        return evaluations;
      }

    private:
      static constexpr unsigned int first_internal = 4;

      unsigned int lost_energy() const
      {
        return first_internal + law.n_history();
      }

      unsigned int load_work() const
      {
        return lost_energy() + 1;
      }

      static CellMotion motion_of(const StateVector &y)
      {
        CellMotion motion;
        for (unsigned int i = 0; i < 2; ++i)
          {
            motion.position[i] = y[i];
            motion.velocity[i] = y[2 + i];
          }
        return motion;
      }

      /**
       * Throws from within ARKODE, because deal.II 9.4 checks its error codes
       * in Debug mode only and would repeat the call forever.
       */
      void evaluate(const double t, const StateVector &y, StateVector &rates)
      {
        ++evaluations;
        if (++evaluations_of_step > max_evaluations)
          throw_too_stiff();
        const CellMotion         motion = motion_of(y);
        const double             load   = scene.reduced_cell->load.value(t);
        const double             rate   = cell.extension_rate(motion);
        const ContinuousResponse connector =
          law.continuous(cell.extension(motion.position),
                         rate,
                         y.data() + first_internal,
                         rates.data() + first_internal);
        const CellVector a = cell.acceleration(motion, load + connector.force);
        for (unsigned int i = 0; i < 2; ++i)
          {
            rates[i]     = motion.velocity[i];
            rates[2 + i] = a[i];
          }
        rates[lost_energy()] = connector.lost_power;
        rates[load_work()]   = -load * rate;
      }

      CellSample sample() const
      {
        const CellMotion         motion    = motion_of(y);
        const double             time      = scene.time.time_at(step);
        const double             extension = cell.extension(motion.position);
        std::vector<double>      ignored(law.n_history());
        const ContinuousResponse connector =
          law.continuous(extension,
                         cell.extension_rate(motion),
                         y.data() + first_internal,
                         ignored.data());
        Energies energies         = cell_energies();
        energies[cell_kinetic]    = cell.kinetic_energy(motion);
        energies[cell_stored]     = connector.stored;
        energies[cell_dissipated] = y[lost_energy()];
        energies[cell_work]       = y[load_work()];
        const CellSample sample{time,
                                cell.angle(motion.position[0]),
                                extension,
                                motion.position[1],
                                scene.reduced_cell->load.value_before(time),
                                -connector.force,
                                energies};
        require_finite(sample);
        return sample;
      }

      [[noreturn]] void throw_too_stiff() const
      {
        std::ostringstream message;
        message
          << "ARKODE needs more than " << max_evaluations
          << " evaluations for the step from t = " << scene.time.time_at(step)
          << " s: the connector is too stiff for an explicit method, or "
             "the solution does not exist beyond this time.\nAll steps until "
             "then are "
             "in the output folder. Use Time/Scheme = newmark.";
        throw ComputationError(message.str());
      }

      const Scene        &scene;
      const CellEquations cell;
      const ConnectorLaw &law;
      StateVector         y;
      Ode                 ode;
      unsigned long       step = 0, evaluations = 0, evaluations_of_step = 0;
    };

    const std::string arkode_name = "arkode";

    std::unique_ptr<TimeScheme> make_arkode(ParameterValues & /*values*/)
    {
      return std::make_unique<CellMethodOf<ArkodeScheme>>(arkode_name);
    }
  } // namespace

  TimeSchemeEntry arkode_entry()
  {
    return {{arkode_name,
             "explicit Runge-Kutta with error control (SUNDIALS ARKODE), the "
             "reference",
             {},
             make_arkode},
            {Model::reduced_cell}};
  }
} // namespace auxfem
