#include <auxfem/parameters/errors.h>
#include <auxfem/reduced_cell/cell_scheme.h>

#include <cmath>
#include <sstream>

namespace auxfem
{
  Energies cell_energies()
  {
    static const auto ledger = []() {
      EnergyLedger of_cell;
      of_cell.enter(kinetic_energy_entry());
      of_cell.enter(stored_energy_entry());
      of_cell.enter({EnergyKind::dissipated,
                     "dissipated",
                     "energy lost in connectors since the start"});
      of_cell.enter(
        {EnergyKind::work, "external", "work of the load since the start"});
      return std::make_shared<const EnergyLedger>(of_cell);
    }();
    return Energies(ledger);
  }

  void refuse_not_finite(const CellSample &sample)
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
            << " is not a finite number: the motion grows beyond all "
               "bounds, as it does with a step too long for the scheme "
               "and the stiffness of the connector.\nAll steps until then "
               "are in the output folder. Reduce Time/Time step, or use "
               "Time/Scheme = newmark.";
          throw ComputationError(message.str());
        }
  }

  std::unique_ptr<CellScheme> make_cell_scheme(const Scene &scene)
  {
    const auto *own = dynamic_cast<const CellMethod *>(scene.time.scheme.get());
    return own != nullptr ? own->begin(scene)
                          : make_implicit_cell_scheme(scene);
  }
} // namespace auxfem
