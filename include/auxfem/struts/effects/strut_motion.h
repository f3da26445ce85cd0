#ifndef auxfem_struts_effects_strut_motion_h
#define auxfem_struts_effects_strut_motion_h

#include <auxfem/model/numbering.h>
#include <auxfem/state/state.h>

#include <vector>

namespace auxfem
{
  /**
   * Motion of the nodes of one strut at an instant, from its first to its
   * second end: order * n_elements + 1 nodes, the Gauss-Lobatto points of its
   * elements. Used to move states between meshes.
   */
  struct StrutMotion
  {
    unsigned int order      = 0; ///< of the elements
    unsigned int n_elements = 0;
    double       time       = 0; ///< time_of_loads()
    /**
     * @name Values, n_components() per node; rates are empty if the state has
     * none.
     */
    ///@{
    std::vector<double> displacement, velocity, acceleration;
    ///@}
    /** One rotation per node; empty if the state has no quaternions. */
    std::vector<Quaternion> rotations;

    unsigned int n_nodes() const
    {
      return order * n_elements + 1;
    }
  };

  /** Motion of the strut whose elements begin with @p first_element of @p
   * numbering; this rank must hold all of them. */
  StrutMotion motion_of_strut(const DofNumbering &numbering,
                              const State        &state,
                              unsigned int        first_element);

  /**
   * Interpolates @p motion to the nodes of another division. Displacements,
   * rotations relative to the middle of the element (beam_3d_strains.h) and
   * rates are polynomials of the source elements. The interpolation is exact if
   * the new elements subdivide the old ones and have no lower order.
   */
  StrutMotion interpolated(const StrutMotion &motion, StrutDivision division);

  /**
   * Writes @p motion, given at the nodes of the strut's elements, to @p state.
   */
  void set_motion_of_strut(const DofNumbering &numbering,
                           unsigned int        first_element,
                           const StrutMotion  &motion,
                           State              &state);
} // namespace auxfem

#endif
