#ifndef auxfem_joints_effects_relation_forces_h
#define auxfem_joints_effects_relation_forces_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace auxfem
{
  /** A linear relation by local unknowns. */
  struct LocalRelation
  {
    /** Unknowns of the terms, then the multiplier. */
    std::vector<int>    unknowns;
    std::vector<double> coefficients; ///< of the terms
    /** The two equal large rotations in space, of which the terms are one
     * component, as numbers in DofNumbering::rotations(). */
    std::optional<std::array<unsigned int, 2>> equal_rotations = {};
  };

  /**
   * Makes the constraints of linear relations between motions u_i,
   * @code
   * g = sum_i c_i u_i = 0
   * @endcode
   * with the forces c_i lambda. They are constant in direction, so that they do
   * no work in any step at whose ends g is zero. For equal large rotations u_i
   * are the differences of the material rotation vectors in the global frame.
   * @param numbering must outlive the object
   */
  std::unique_ptr<Constraints>
  make_relation_forces(std::vector<LocalRelation> relations,
                       const DofNumbering        &numbering);
} // namespace auxfem

#endif
