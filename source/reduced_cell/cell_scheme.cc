#include <auxfem/reduced_cell/cell_scheme.h>

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

  std::unique_ptr<CellScheme> make_cell_scheme(const Scene &scene)
  {
    const auto *own = dynamic_cast<const CellMethod *>(scene.time.scheme.get());
    return own != nullptr ? own->begin(scene)
                          : make_implicit_cell_scheme(scene);
  }
} // namespace auxfem
