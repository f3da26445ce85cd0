#ifndef auxfem_equations_contact_points_h
#define auxfem_equations_contact_points_h

#include <auxfem/equations/contact_axes.h>

#include <deal.II/base/table.h>

#include <memory>

namespace auxfem
{
  /** Points at which an axis may touch a plate. */
  struct ContactPoints
  {
    /** A shape function of each node at each point: by point, then node. */
    using Shape = dealii::Table<2, double>;

    std::shared_ptr<const Shape>  shape;
    std::vector<dealii::Point<3>> rest;    ///< m
    std::vector<double>           weights; ///< lengths they stand for (m)

    unsigned int size() const
    {
      return rest.size();
    }

    /** Displacement (m) of a point.
     * @param unknowns local numbers, as ContactAxis::unknowns
     * @param values by local number */
    dealii::Tensor<1, 3> displacement(unsigned int  point,
                                      unsigned int  dimension,
                                      const int    *unknowns,
                                      const double *values) const;
  };

  /**
   * Of each axis Gauss-Lobatto points about as far apart as the strut is thick.
   * Those at the ends of struts stand for half the thickness more, the caps of
   * the ends.
   */
  std::vector<ContactPoints>
  make_contact_points(const Lattice                  &lattice,
                      const std::vector<ContactAxis> &axes);
} // namespace auxfem

#endif
