#include <auxfem/analysis/reduced_cell/cell_scheme.h>
#include <auxfem/parameters/errors.h>

#include <cmath>
#include <sstream>

namespace auxfem
{
  Energies cell_energies()
  {
    static const auto ledger = []() {
      EnergyLedger ledger;
      ledger.enter(kinetic_energy_entry());
      ledger.enter(stored_energy_entry());
      ledger.enter({EnergyKind::dissipated,
                    "dissipated",
                    "energy lost in connectors since the start"});
      ledger.enter(
        {EnergyKind::work, "external", "work of the load since the start"});
      return std::make_shared<const EnergyLedger>(ledger);
    }();
    return Energies(ledger);
  }

  void require_finite(const CellSample &sample)
  {
    std::vector<std::pair<std::string, double>> numbers = {
      {"theta", sample.angle},
      {"Y1", sample.upper_rise},
      {"Y2", sample.lower_rise},
      {"f1", sample.load},
      {"f2", sample.transmitted}};
    const std::vector<EnergyEntry> &entries =
      sample.energies.ledger().entries();
    for (unsigned int i = 0; i < entries.size(); ++i)
      numbers.emplace_back("the energy " + entries[i].name, sample.energies[i]);
    for (const auto &[name, number] : numbers)
      if (!std::isfinite(number))
        {
          std::ostringstream message;
          message
            << "At t = " << sample.time << " s " << name
            << " is not a finite number: the motion grows without bounds. "
               "The step is probably too long for the scheme and the stiffness "
               "of the connector.\nAll steps until then "
               "are in the output folder. Reduce Time/Time step, or use "
               "Time/Scheme = newmark.";
          throw ComputationError(message.str());
        }
  }

  std::unique_ptr<CellScheme> make_cell_scheme(const Scene &scene)
  {
    const auto *cell_method =
      dynamic_cast<const CellMethod *>(scene.time.scheme.get());
    return cell_method != nullptr ? cell_method->begin(scene)
                                  : make_implicit_cell_scheme(scene);
  }

  namespace
  {
    /** Throws InputError if the last step would be shorter than the others. */
    void require_equal_steps(const Scene &scene)
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
    const ConnectorEnergy connector_energy =
      law.energy(connector_motion, committed.data(), trial.data());
    energies[cell_kinetic] = cell.kinetic_energy(motion);
    energies[cell_stored]  = connector_energy.stored;
    energies[cell_dissipated] += connector_energy.dissipated;
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
    require_finite(sample);
    return sample;
  }

  TwoStepGrid::TwoStepGrid(const std::array<CellVector, 4> &first) : x(first)
  {}

  TwoStepScheme::TwoStepScheme(const Scene &scene) : scene(scene), cell(scene)
  {
    require_equal_steps(scene);
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
