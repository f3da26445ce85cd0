#ifndef auxfem_equations_effects_point_masses_h
#define auxfem_equations_effects_point_masses_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>

namespace auxfem
{
  /** Masses and rotary inertias on joints. */
  class PointMasses : public Effect
  {
  public:
    explicit PointMasses(const DofNumbering &numbering);

    /** Adds @p mass (kg, or kg m2 on a rotation) to a local unknown. */
    void add(unsigned int unknown, double mass);

    /** Whether no mass was added. */
    bool empty() const;

    bool is_linear() const override;
    void register_blocks(TangentPattern &pattern) override;
    void add_residual(const Evaluation &evaluation,
                      double           *residual,
                      EffectResults    *results) const override;
    void add_tangent(const Evaluation     &evaluation,
                     const EffectResults  *results,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const override;
    void register_in(StateLayout &layout) override;
    void account(const Evaluation    &step,
                 const EffectResults *results,
                 EnergyAccount       &account) const override;

  private:
    struct Mass
    {
      int    unknown;
      double mass;
    };
    const DofNumbering &numbering;
    std::vector<Mass>   masses;
    std::size_t         first_block   = 0;
    unsigned int        kinetic_entry = 0, numerical_entry = 0;
  };
} // namespace auxfem

#endif
