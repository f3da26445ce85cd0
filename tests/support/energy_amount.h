#ifndef auxfem_tests_support_energy_amount_h
#define auxfem_tests_support_energy_amount_h

#include <auxfem/state/energies.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** The amount in @p energies of the entry with the name @p entry. */
    inline double &energy_amount(Energies &energies, const std::string &entry)
    {
      const std::vector<EnergyEntry> &entries = energies.ledger().entries();
      for (unsigned int i = 0; i < entries.size(); ++i)
        if (entries[i].name == entry)
          return energies[i];
      throw std::runtime_error("There is no energy " + entry);
    }
  } // namespace testing_support
} // namespace auxfem

#endif
