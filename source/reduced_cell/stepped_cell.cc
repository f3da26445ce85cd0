#include <auxfem/parameters/errors.h>
#include <auxfem/reduced_cell/stepped_cell.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Throws InputError if the last step would be shorter than the others. */
    void refuse_uneven_steps(const Scene &scene)
    {
      const TimeParameters &time = scene.time;
      const double          even = time.n_steps() * time.step;
      if (std::abs(even - time.end_time) > 1e-6 * time.step)
        throw InputError(
          "Time/Scheme = " + time.scheme->name() +
          " needs equal steps, but Time/End time is no multiple of Time/Time "
          "step. Change one of them");
    }
  } // namespace

  SteppedCell::SteppedCell(const Scene &scene)
    : scene(scene)
    , cell(*scene.reduced_cell)
    , law(*scene.connectors.front().law)
    , committed(law.n_history(), 0.)
    , trial(committed)
    , energies(cell_energies())
  {}

  void SteppedCell::begin_step(const unsigned long step)
  {
    const double begin                  = time;
    const double end                    = scene.time.time_at(step);
    connector_motion.previous_extension = connector_motion.extension;
    connector_motion.dt                 = end - begin;
    time                                = end;
    load_before = scene.reduced_cell->load.value_after(begin);
    load_now    = scene.reduced_cell->load.value_before(end);
  }

  const ConnectorResponse &SteppedCell::connector(const CellMotion &motion)
  {
    connector_motion.extension = cell.extension(motion.position);
    connector_motion.rate      = cell.extension_rate(motion);
    law.evaluate(1,
                 &connector_motion,
                 committed.data(),
                 trial.data(),
                 &response);
    return response;
  }

  CellSample SteppedCell::accept(const CellMotion &motion)
  {
    connector(motion);
    const ConnectorEnergy of_connector =
      law.energy(connector_motion, committed.data(), trial.data());
    energies[cell_kinetic] = cell.kinetic_energy(motion);
    energies[cell_stored]  = of_connector.stored;
    energies[cell_dissipated] += of_connector.dissipated;
    energies[cell_work] -= (load_before + load_now) / 2 *
      (connector_motion.extension - connector_motion.previous_extension);
    committed = trial;
    const CellSample sample{time,
                            cell.angle(motion.position[0]),
                            connector_motion.extension,
                            motion.position[1],
                            load_now,
                            -response.force,
                            energies};
    refuse_not_finite(sample);
    return sample;
  }

  TwoStepGrid::TwoStepGrid(const std::array<CellVector, 4> &first) : x(first)
  {}

  TwoStepScheme::TwoStepScheme(const Scene &scene) : scene(scene), cell(scene)
  {
    refuse_uneven_steps(scene);
  }

  CellSample TwoStepScheme::start()
  {
    cell.begin_step(0);
    set_first_positions();
    return sample();
  }

  CellSample TwoStepScheme::advance()
  {
    cell.begin_step(++step);
    return sample();
  }
} // namespace auxfem
