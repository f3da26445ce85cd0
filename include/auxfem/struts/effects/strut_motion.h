#ifndef auxfem_struts_effects_strut_motion_h
#define auxfem_struts_effects_strut_motion_h

#include <auxfem/model/numbering.h>
#include <auxfem/state/state.h>

#include <vector>

namespace auxfem
{
  /**
   * What the nodes of one strut do at an instant, from its first to its second
   * end: order * n_elements + 1 nodes, the Gauss-Lobatto points of its
   * elements.
   */
  struct StrutMotion
  {
    unsigned int order      = 0; ///< of the elements
    unsigned int n_elements = 0;
    double       time       = 0; ///< time_of_loads()
    /** n_components() a node; rates are empty where the state has none. */
    ///@{
    std::vector<double> displacement, velocity, acceleration;
    ///@}
    /** A node; none if rotations are not kept as quaternions. */
    std::vector<Quaternion> rotations;

    unsigned int n_nodes() const
    {
      return order * n_elements + 1;
    }
  };

  /**
   * Of the strut whose elements, all of which are kept on this rank, begin with
   * @p first_element of @p numbering.
   */
  StrutMotion motion_of_strut(const DofNumbering &numbering,
                              const State        &state,
                              unsigned int        first_element);

  /**
   * The same motion at the nodes of other elements.
   * Displacements, rotations measured from the middle of the element
   * (elements/beam_3d_strains.h) and rates are interpolated as polynomials of
   * the elements they come from, so nothing is lost if the new ones divide
   * these and have no lower order.
   */
  StrutMotion interpolated(const StrutMotion &motion, StrutDivision division);

  /** Writes @p motion, whose nodes are those of the strut's elements, to @p state.
   */
  void set_motion_of_strut(const DofNumbering &numbering,
                           unsigned int        first_element,
                           const StrutMotion  &motion,
                           State              &state);
} // namespace auxfem

#endif
