#ifndef auxfem_equations_contact_axes_h
#define auxfem_equations_contact_axes_h

#include <auxfem/model/lattice_model.h>

#include <deal.II/base/table.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * A piece of the axis of a strut as contact sees it: an element, or a rigid
   * strut, with the points at which it may touch something.
   */
  struct ContactAxis
  {
    /** A shape function of each node at each contact point. */
    using Shape = dealii::Table<2, double>;

    unsigned int strut;
    double       begin, end; ///< fractions of the strut's length
    /** Global numbers of the displacements, dimension of space at each node. */
    std::vector<int> unknowns;
    /** Whether this rank counts its energy. */
    bool                            is_owned;
    double                          length; ///< at rest (m)
    std::array<dealii::Point<3>, 2> ends;   ///< at rest (m)
    /** Of the strut, half of it (m); zero of rigid ones and of sections that
     * are given by their stiffnesses. */
    double half_thickness;
    /** Force per length and penetration of the face against the axis (N/m2);
     * zero if the section has no thickness. */
    double stiffness;
    /** By point, then node. */
    std::shared_ptr<const Shape>  shape;
    std::vector<dealii::Point<3>> rest;    ///< of the points (m)
    std::vector<double>           weights; ///< lengths they stand for (m)

    unsigned int n_points() const
    {
      return rest.size();
    }

    unsigned int n_nodes() const
    {
      return shape->size(1);
    }
  };

  /**
   * The axes of all struts, the same list on every rank, with Gauss-Lobatto
   * points about as far apart as the struts are thick. The points at the ends
   * of struts stand for half the thickness more, the caps of the ends.
   *
   * Rigid struts have no thickness, and the stiffness of the stiffest section.
   * Collective.
   * @param stiffness_factor of ContactParameters
   */
  std::vector<ContactAxis> make_contact_axes(const LatticeModel &model,
                                             double stiffness_factor);

  /** Displacement (m) of point @p point of @p axis.
   * @param unknowns local numbers, as ContactAxis::unknowns
   * @param values by local number */
  dealii::Tensor<1, 3> displacement_of(const ContactAxis &axis,
                                       unsigned int       point,
                                       unsigned int       dimension,
                                       const int         *unknowns,
                                       const double      *values);
} // namespace auxfem

#endif
