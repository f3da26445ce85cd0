#include <auxfem/state/energies.h>

#include <algorithm>

namespace auxfem
{
  unsigned int EnergyLedger::enter(const EnergyEntry &entry)
  {
    const auto known =
      std::find_if(list.begin(), list.end(), [&](const EnergyEntry &other) {
        return other.name == entry.name;
      });
    if (known != list.end())
      return known - list.begin();
    list.push_back(entry);
    return list.size() - 1;
  }

  bool EnergyLedger::has(const EnergyKind kind) const
  {
    return std::any_of(list.begin(),
                       list.end(),
                       [kind](const EnergyEntry &entry) {
                         return entry.kind == kind;
                       });
  }

  EnergyEntry kinetic_energy_entry()
  {
    return {EnergyKind::kinetic, "kinetic", "kinetic energy"};
  }

  EnergyEntry strain_energy_entry()
  {
    return {EnergyKind::strain,
            "strain",
            "strain energy of struts and rotational springs"};
  }

  EnergyEntry stored_energy_entry()
  {
    return {EnergyKind::stored,
            "stored",
            "energy in the springs of connectors"};
  }

  EnergyEntry contact_energy_entry()
  {
    return {EnergyKind::stored, "contact", "elastic energy of contact"};
  }

  EnergyEntry friction_energy_entry()
  {
    return {EnergyKind::dissipated,
            "friction.dissipated",
            "energy lost by friction since the start"};
  }

  EnergyEntry numerical_energy_entry()
  {
    return {EnergyKind::numerical,
            "numerical",
            "energy removed by the time integration since the start, beyond "
            "physical losses; negative: added"};
  }

  EnergyEntry relaxation_energy_entry()
  {
    return {EnergyKind::dissipated,
            "strut_relaxation_dissipated",
            "energy lost by relaxation of the struts since the start"};
  }

  EnergyEntry plastic_energy_entry()
  {
    return {EnergyKind::dissipated,
            "plastic_dissipated",
            "energy lost by yielding of the struts since the start, with the "
            "work of isotropic hardening"};
  }

  EnergyEntry fracture_energy_entry()
  {
    return {
      EnergyKind::dissipated,
      "fracture_dissipated",
      "energy stored in struts and connectors that broke since the start"};
  }

  Energies::Energies() : entries(std::make_shared<const EnergyLedger>())
  {}

  Energies::Energies(std::shared_ptr<const EnergyLedger> ledger)
    : entries(std::move(ledger))
    , values(entries->entries().size(), 0.)
  {}

  double Energies::sum(const EnergyKind kind) const
  {
    double result = 0;
    for (unsigned int i = 0; i < values.size(); ++i)
      if (entries->entries()[i].kind == kind)
        result += values[i];
    return result;
  }
} // namespace auxfem
