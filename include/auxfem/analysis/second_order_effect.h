#ifndef auxfem_analysis_second_order_effect_h
#define auxfem_analysis_second_order_effect_h

#include <auxfem/analysis/tangent_solver.h>

#include <memory>
#include <optional>

namespace auxfem
{
  /**
   * Change of displacements and forces of a linear scene by axial forces,
   * by the stiffness K + K_g of the structure as it is at rest with the forces
   * that it bears: linear stability theory. Costs a factorization each time.
   */
  class SecondOrderEffect
  {
  public:
    /** @param scene, equations of small displacements, must outlive the object.
     */
    SecondOrderEffect(const Scene &scene, const Equations &equations);
    ~SecondOrderEffect();

    /**
     * The larger of the change of the displacements over the displacements and
     * that of the forces over the forces, in the norm of their energy; nothing
     * where the structure has buckled or moves freely. Collective.
     * @param state of small displacements, which has its energies
     * @param forces_by_turning what axial forces do on turned struts (N), by
     *   local unknown
     */
    std::optional<double> at(const State  &state,
                             const Vector &forces_by_turning);

    /** Effort of the checks since the last call. */
    Work take_effort();

  private:
    /** The same structure with large rotations. */
    struct Exact;

    const Scene           &scene;
    const Equations       &equations;
    Work                   effort;
    std::unique_ptr<Exact> exact; ///< made when it is needed
    /** There is no such structure. */
    bool is_impossible = false;
  };
} // namespace auxfem

#endif
