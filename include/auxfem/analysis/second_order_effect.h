#ifndef auxfem_analysis_second_order_effect_h
#define auxfem_analysis_second_order_effect_h

#include <auxfem/analysis/tangent_solver.h>

#include <memory>
#include <optional>

namespace auxfem
{
  /** The change of a linear answer by axial forces. */
  struct SecondOrderChange
  {
    /** The larger of the change of the displacements over the displacements
     * and that of the forces over the forces, in the norm of their energy. */
    double relative = 0;
    /** Whether the stiffness under the axial forces has negative modes;
     * nothing where the linear solver does not tell. */
    std::optional<bool> is_unstable = {};
  };

  /**
   * Change of displacements and forces of a linear scene by axial forces,
   * by the stiffness K + K_g of the structure as it is at rest with the forces
   * that it bears: linear stability theory. Beyond the critical load that
   * stiffness has no meaning for the answer; K takes its place, as if buckling
   * were excluded. Costs one or two factorizations each time.
   */
  class SecondOrderEffect
  {
  public:
    /** @param equations of small displacements, must outlive the object.
     */
    explicit SecondOrderEffect(const Equations &equations);
    ~SecondOrderEffect();

    /**
     * The change in @p state; nothing where there is no such structure with
     * large rotations or it moves freely. Collective.
     * @param state by small displacements, which has its energies
     * @param forces_by_turning forces (N) by local unknown that axial forces
     *   exert on turned struts
     */
    std::optional<SecondOrderChange> at(const State  &state,
                                        const Vector &forces_by_turning);

    /** The equations of the same structure with large rotations; nullptr where
     * these are not possible. Collective. */
    const Equations *exact_equations();

    /** Effort of the checks since the last call. */
    Work take_effort();

  private:
    /** The same structure with large rotations. */
    struct Exact;

    /** The change by @p forces (N) with the factors at hand. */
    std::optional<double> relative_change(const State  &state,
                                          const Vector &forces);

    const Equations       &equations;
    Work                   effort;
    std::unique_ptr<Exact> exact; ///< made when it is needed
    /** There is no such structure. */
    bool is_impossible = false;
  };
} // namespace auxfem

#endif
