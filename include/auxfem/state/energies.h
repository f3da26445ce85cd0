#ifndef auxfem_state_energies_h
#define auxfem_state_energies_h

#include <auxfem/algebra/unknowns.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace auxfem
{
  /** Largest value so far, at least zero, and its time (s). */
  struct LargestInTime
  {
    void add(const double candidate, const double now)
    {
      // A NaN is never replaced.
      if (value >= candidate || std::isnan(value))
        return;
      value = candidate;
      time  = now;
    }

    /** Largest value over all ranks of @p layout. Collective. */
    LargestInTime gather_over_ranks(const UnknownLayout &layout) const
    {
      const double largest = layout.largest(value);
      return {largest, layout.largest(largest == value ? time : 0.)};
    }

    double value = 0, time = 0;
  };

  /** Kind of an entry in the energy ledger. */
  enum class EnergyKind
  {
    kinetic,
    strain,     ///< in struts and rotational springs
    stored,     ///< in the springs of connectors
    dissipated, ///< since the start
    /** Removed by the time integration since the start; negative: added. */
    numerical,
    work ///< done by loads and prescribed motion since the start
  };

  /** Entry of the ledger, a column of history.csv. */
  struct EnergyEntry
  {
    EnergyKind kind;
    /** Heading of the column, for instance `kinetic` or `push.load_work`. */
    std::string name;
    /** For `history.units.csv`. */
    std::string meaning;
  };

  /**
   * Named energies of a scene. Each effect enters its own; effects may share
   * an entry, which is identified by its name.
   */
  class EnergyLedger
  {
  public:
    /**
     * Number of the entry with the name of @p entry, which is added if
     * missing.
     */
    unsigned int enter(const EnergyEntry &entry);

    const std::vector<EnergyEntry> &entries() const
    {
      return list;
    }

    bool has(EnergyKind kind) const;

  private:
    std::vector<EnergyEntry> list;
  };

  /** @name Entries shared by several effects. */
  ///@{
  EnergyEntry kinetic_energy_entry();
  EnergyEntry strain_energy_entry();
  EnergyEntry stored_energy_entry();
  EnergyEntry numerical_energy_entry();
  EnergyEntry relaxation_energy_entry();
  EnergyEntry plastic_energy_entry();
  EnergyEntry fracture_energy_entry();
  EnergyEntry contact_energy_entry();
  EnergyEntry friction_energy_entry();
  ///@}

  /** Energies at one time (J), one amount per entry of a ledger. */
  class Energies
  {
  public:
    /** Without entries. */
    Energies();

    /** All zero. */
    explicit Energies(std::shared_ptr<const EnergyLedger> ledger);

    const EnergyLedger &ledger() const
    {
      return *entries;
    }

    double &operator[](const unsigned int entry)
    {
      return values[entry];
    }

    double operator[](const unsigned int entry) const
    {
      return values[entry];
    }

    /** Amounts in the order of the entries. */
    std::vector<double> &amounts()
    {
      return values;
    }

    const std::vector<double> &amounts() const
    {
      return values;
    }

    /** Sum of all entries of a kind. */
    double sum(EnergyKind kind) const;

    /** @name Sums by kind. */
    ///@{
    double kinetic() const
    {
      return sum(EnergyKind::kinetic);
    }

    double strain() const
    {
      return sum(EnergyKind::strain);
    }

    double stored() const
    {
      return sum(EnergyKind::stored);
    }

    double dissipated() const
    {
      return sum(EnergyKind::dissipated);
    }

    /** Energy removed by the time integration. */
    double numerical() const
    {
      return sum(EnergyKind::numerical);
    }

    /** Work of loads and prescribed motion. */
    double external() const
    {
      return sum(EnergyKind::work);
    }
    ///@}

    /** Mechanical energy: kinetic + strain + stored. */
    double total() const
    {
      return kinetic() + strain() + stored();
    }

    /**
     * total + dissipated + numerical - external - @p initial_total. Linear
     * scenes balance to round-off, others to the error of the steps.
     */
    double balance(const double initial_total) const
    {
      return total() + dissipated() + numerical() - external() - initial_total;
    }

  private:
    std::shared_ptr<const EnergyLedger> entries;
    std::vector<double>                 values;
  };
} // namespace auxfem

#endif
