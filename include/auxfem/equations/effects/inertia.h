#ifndef auxfem_equations_effects_inertia_h
#define auxfem_equations_effects_inertia_h

#include <auxfem/equations/effect.h>

namespace auxfem
{
  /** What all inertia has: the energies that follow from its mass matrix. */
  class InertiaEffect : public Effect
  {
  public:
    void register_in(StateLayout &layout) override
    {
      kinetic_entry   = layout.energies.enter(kinetic_energy_entry());
      numerical_entry = layout.energies.enter(numerical_energy_entry());
    }

    void account(const Evaluation & /*evaluation*/,
                 const EffectResults * /*results*/,
                 EnergyAccount &account) const override
    {
      account.add_inertia(kinetic_entry,
                          numerical_entry,
                          [&](const Vector &x, const Vector &y) {
                            return mass_product(x, y);
                          });
    }

  protected:
    unsigned int numerical_entry = 0;

  private:
    /** x.M y of what this rank owns, of values of all local unknowns. */
    virtual double mass_product(const Vector &x, const Vector &y) const = 0;

    unsigned int kinetic_entry = 0;
  };
} // namespace auxfem

#endif
