#ifndef auxfem_struts_effects_strut_inertia_h
#define auxfem_struts_effects_strut_inertia_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>
#include <auxfem/struts/beam_shape.h>
#include <auxfem/struts/section.h>

namespace auxfem
{
  /** Which inertia of struts is simulated. */
  struct InertiaModel
  {
    bool large_rotation = true;
    bool rotary_inertia = true;
    bool damping        = false; ///< mass-proportional
  };

  /** What mass-proportional damping of struts takes from the motion. */
  EnergyEntry mass_damping_entry();

  /** What the inertia of struts has in the plane and in space: elements and
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
    /**
     * The velocities that damping sees: those at evaluation.to, between two
     * states their means.
     */
    class DampedVelocity
    {
    public:
      /** @p evaluation must outlive the object. */
      explicit DampedVelocity(const Evaluation &evaluation);

      /** Of all local unknowns. */
      const double *values() const;

    private:
      const Evaluation   &evaluation;
      std::vector<double> means; ///< empty unless between two states
    };

    struct Element
    {
      const Section &section;
      double         half_length; ///< m
      double         mass;        ///< rho A times half the length (kg)
      double         damping;     ///< alpha (1/s)
      bool           owned;
    };

    using Weight = double (*)(const Element &);

    const DofNumbering       &numbering;
    const DofNumbering::Group group;
    std::vector<Element>      elements;

  private:
    /** As mass_product(), each element with a @p weight. */
    virtual double
    product(const Vector &x, const Vector &y, Weight weight) const = 0;

    double mass_product(const Vector &x, const Vector &y) const override
    {
      return product(x, y, [](const Element &) { return 1.; });
    }

    /** The same with the matrix of mass-proportional damping. */
    double damping_product(const Vector &x, const Vector &y) const
    {
      return product(x, y, [](const Element &e) { return e.damping; });
    }

    const bool   is_damped;
    unsigned int damping_entry = 0;
  };

  /**
   * Inertia of the struts, with mass-proportional damping where a section has
   * it.
   */
  std::unique_ptr<Effect>
  make_strut_inertia(const Lattice              &lattice,
                     const DofNumbering         &numbering,
                     const DofNumbering::Group  &group,
                     const std::vector<Section> &sections,
                     const InertiaModel         &model);

  /** The same for lattices in space. */
  std::unique_ptr<Effect>
  make_space_strut_inertia(const Lattice              &lattice,
                           const DofNumbering         &numbering,
                           const DofNumbering::Group  &group,
                           const std::vector<Section> &sections,
                           const InertiaModel         &model);
} // namespace auxfem

#endif
