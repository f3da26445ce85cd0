#ifndef auxfem_struts_effects_strut_inertia_h
#define auxfem_struts_effects_strut_inertia_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>
#include <auxfem/struts/beam_shape.h>
#include <auxfem/struts/effects/damped_velocity.h>
#include <auxfem/struts/section.h>

namespace auxfem
{
  /** Inertia terms of struts to simulate. */
  struct InertiaModel
  {
    bool large_rotation = true;
    bool rotary_inertia = true;
    bool damping        = false; ///< mass-proportional
  };

  /** Energy entry of mass-proportional damping. */
  EnergyEntry mass_damping_entry();

  /** Common part of the strut inertia in the plane and in space: elements and
   * energies. */
  class StrutInertia : public InertiaEffect, public StageTerms
  {
  public:
    /** @param damped whether a section has mass-proportional damping. */
    StrutInertia(const Lattice              &lattice,
                 const DofNumbering         &numbering,
                 const DofNumbering::Group  &group,
                 const std::vector<Section> &sections,
                 bool                        damped);

    void register_in(StateLayout &layout) override;
    void account_step(const Evaluation  &step,
                      const EffectCache *results,
                      EnergyAccount     &account) const override;
    void account_stage(const Evaluation  &stage,
                       const EffectCache *results,
                       EnergyAccount     &account) const override;

  protected:
    struct Element
    {
      /** Per length about axes 1, 2, 3 (kg m). */
      std::array<double, 3> rotary_inertia;
      double                half_length; ///< m
      double                mass;        ///< rho A times half the length (kg)
      double                damping;     ///< alpha (1/s)
      bool                  owned;
    };

    using Weight = double (*)(const Element &);

    const DofNumbering       &numbering;
    const DofNumbering::Group group;
    std::vector<Element>      elements;

  private:
    /** Same as mass_product() with each element multiplied by @p weight. */
    virtual double
    product(const Vector &x, const Vector &y, Weight weight) const = 0;

    double mass_product(const Vector &x, const Vector &y) const override
    {
      return product(x, y, [](const Element &) { return 1.; });
    }

    /** Product with the matrix of mass-proportional damping. */
    double damping_product(const Vector &x, const Vector &y) const
    {
      return product(x, y, [](const Element &e) { return e.damping; });
    }

    const bool   is_damped;
    unsigned int damping_entry = 0;
  };

  /** Inertia of the struts, with mass-proportional damping where a section has
   * it. */
  std::unique_ptr<Effect>
  make_strut_inertia(const Lattice              &lattice,
                     const DofNumbering         &numbering,
                     const DofNumbering::Group  &group,
                     const std::vector<Section> &sections,
                     const InertiaModel         &model);

  /** Same as make_strut_inertia() for lattices in space. */
  std::unique_ptr<Effect>
  make_space_strut_inertia(const Lattice              &lattice,
                           const DofNumbering         &numbering,
                           const DofNumbering::Group  &group,
                           const std::vector<Section> &sections,
                           const InertiaModel         &model);
} // namespace auxfem

#endif
