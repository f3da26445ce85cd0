#ifndef auxfem_equations_contact_axes_h
#define auxfem_equations_contact_axes_h

#include <auxfem/model/lattice_model.h>

#include <array>
#include <vector>

namespace auxfem
{
  /** Two axes, the one with the lower number first. */
  using AxisPair = std::array<unsigned int, 2>;

  /**
   * A piece of the axis of a strut as contact sees it: an element, or a rigid
   * strut.
   */
  struct ContactAxis
  {
    unsigned int strut;
    double       begin, end; ///< fractions of the strut's length
    /** Global numbers of the displacements, dimension of space at each node. */
    std::vector<int> unknowns;
    unsigned int     order; ///< of the polynomial through the nodes
    /** Whether this rank counts its energy. */
    bool                            is_owned;
    double                          length; ///< at rest (m)
    std::array<dealii::Point<3>, 2> ends;   ///< at rest (m)
    /** Of the strut, half of it (m); zero of rigid ones without a section and
     * of sections that are given by their stiffnesses. */
    double half_thickness;
    /** Force per length and penetration of the face against the axis (N/m2);
     * zero if the section has no thickness. */
    double stiffness;

    unsigned int n_nodes() const
    {
      return order + 1;
    }
  };

  /**
   * The axes of all struts, the same list on every rank.
   *
   * Rigid struts have the stiffness of the stiffest section, and the thickness
   * of their own, if they have one.
   * @param stiffness_factor of ContactParameters
   */
  std::vector<ContactAxis> make_contact_axes(const LatticeModel &model,
                                             double stiffness_factor);
} // namespace auxfem

#endif
