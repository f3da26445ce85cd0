#ifndef auxfem_contact_effects_contact_axes_h
#define auxfem_contact_effects_contact_axes_h

#include <auxfem/model/lattice_model.h>

#include <array>
#include <vector>

namespace auxfem
{
  /**
   * Axis segment for contact detection: an element or a rigid strut. In an
   * infinite lattice also copies of them in neighbouring periods, which move as
   * the original and with the mean deformation.
   */
  struct ContactAxis
  {
    unsigned int strut;
    /** Number of the strut, or of its copy: behind all struts, with gaps. */
    unsigned int line;
    double       begin, end; ///< fractions of the strut's length
    /** Global numbers of the nodal displacements, `dimension` per node; of a
     * copy then those of the axes of the mean deformation. */
    std::vector<int> unknowns;
    /** Shift of a copy from its original, in periods. */
    std::array<int, 3> shift = {{0, 0, 0}};
    /** Motion of a copy over that of each axis of the mean deformation; empty
     * for originals. */
    std::vector<double> axis_factors = {};
    /** Numbers of the points at both ends of the axis and of its strut; equal
     * where they move together. */
    std::array<unsigned int, 2> end_points, strut_ends;
    unsigned int                order; ///< of the polynomial through the nodes
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

    /** Nodes and axes of the mean deformation, on which the motion depends. */
    unsigned int n_nodes() const
    {
      return order + 1 + axis_factors.size();
    }

    bool is_copy() const
    {
      return !axis_factors.empty();
    }
  };

  /**
   * The axes of all struts, in the same order on every rank. Copies of an
   * infinite lattice are those within half a cell of the period.
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
