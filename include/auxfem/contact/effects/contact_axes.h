#ifndef auxfem_contact_effects_contact_axes_h
#define auxfem_contact_effects_contact_axes_h

#include <auxfem/model/lattice_model.h>

#include <array>
#include <vector>

namespace auxfem
{
  /** Axis segment for contact detection: an element or a rigid strut. */
  struct ContactAxis
  {
    unsigned int strut;
    double       begin, end; ///< fractions of the strut's length
    /** Global numbers of the nodal displacements, `dimension` per node. */
    std::vector<int> unknowns;
    unsigned int     order; ///< of the polynomial through the nodes
    /** Whether this rank accounts for its energy. */
    bool                            is_owned;
    double                          length; ///< at rest (m)
    std::array<dealii::Point<3>, 2> ends;   ///< at rest (m)
    /** Half the thickness (m); zero for rigid struts without a section and
     * sections given by stiffnesses. */
    double half_thickness;
    /** Force per length and penetration between face and axis (N/m2); zero
     * without a thickness. */
    double stiffness;

    unsigned int n_nodes() const
    {
      return order + 1;
    }
  };

  /**
   * The axes of all struts, in the same order on every rank.
   *
   * Rigid struts get the stiffness of the stiffest section and keep the
   * thickness of their own section.
   * @param stiffness_factor ContactParameters::stiffness
   */
  std::vector<ContactAxis> make_contact_axes(const LatticeModel &model,
                                             double stiffness_factor);

  /** Parameter intervals [begin, end] of an element. */
  using ParameterRanges = std::vector<std::array<double, 2>>;
} // namespace auxfem

#endif
