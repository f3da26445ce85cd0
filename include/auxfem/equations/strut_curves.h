#ifndef auxfem_equations_strut_curves_h
#define auxfem_equations_strut_curves_h

#include <auxfem/contact/axis_curve.h>
#include <auxfem/equations/contact_axes.h>

#include <map>

namespace auxfem
{
  /** Parts of the parameter of an element, [begin, end] each. */
  using ParameterRanges = std::vector<std::array<double, 2>>;

  /**
   * The axes of struts as curves that can touch each other, and which parts of
   * them count against which struts: where two struts are nearer to each other
   * at rest than their thickness, as at a joint that they share, they cannot
   * touch.
   */
  class StrutCurves
  {
  public:
    /** @param model, axes must outlive the object. */
    StrutCurves(const LatticeModel             &model,
                const std::vector<ContactAxis> &axes);

    /** The curve of an axis.
     * @param unknowns of the axis, as @p values are numbered (m) */
    AxisCurve
    curve(unsigned int axis, const int *unknowns, const double *values) const;

    /** The curve at rest. */
    AxisCurve at_rest(unsigned int axis) const;

    /** Shape functions of the nodes of an axis at a parameter, and their
     * derivatives if @p slopes is given. */
    void shape(unsigned int axis,
               double       parameter,
               double      *values,
               double      *slopes = nullptr) const;

    /** Whether two axes belong to one strut or to struts with a common joint.
     */
    bool are_neighbours(unsigned int one, unsigned int other) const;

    /** Whether two axes cannot move against each other, or have no thickness
     * that could touch: of one rigid part. */
    bool never_touch(unsigned int one, unsigned int other) const;

    /** Axes that are neighbours of each other, each pair once. */
    const std::vector<std::array<unsigned int, 2>> &neighbours() const
    {
      return neighbour_pairs;
    }

    /** Half the sum of the thicknesses of both (m). */
    double thickness(unsigned int one, unsigned int other) const
    {
      return axes[one].half_thickness + axes[other].half_thickness;
    }

    /** The parts of @p axis that may touch the strut of @p other. */
    const ParameterRanges &free_ranges(unsigned int axis,
                                       unsigned int other) const;

    /** The parts of @p other, of the same strut, that are so far along it from a
     * point of @p axis that these can touch: bent round, half a circle of its
     * thickness. */
    ParameterRanges
    parts_apart(unsigned int axis, double parameter, unsigned int other) const;

    /** Whether struts that are not neighbours overlap at rest. */
    bool overlap_at_rest(unsigned int one, unsigned int other) const;

    /** Axes of a strut: [begin, end) in the list. */
    std::array<unsigned int, 2> axes_of(unsigned int strut) const;

    const std::vector<ContactAxis> &list() const
    {
      return axes;
    }

  private:
    /** Shape functions in powers of the parameter, by node. */
    struct Basis
    {
      unsigned int        degree;
      std::vector<double> coefficients; ///< of each node, degree + 1
    };

    void            set_rest(unsigned int axis);
    void            find_neighbours();
    ParameterRanges find_free_ranges(unsigned int axis,
                                     unsigned int other) const;
    double          rest_distance(unsigned int axis,
                                  double       parameter,
                                  unsigned int strut) const;
    double          free_end(unsigned int axis,
                             unsigned int strut,
                             double       least,
                             double       occupied,
                             double       free) const;

    const LatticeModel                                 &model;
    const std::vector<ContactAxis>                     &axes;
    std::map<unsigned int, Basis>                       bases; ///< by order
    std::vector<const Basis *>                          basis_of;
    std::vector<AxisCurve>                              rest;
    std::vector<std::array<unsigned int, 2>>            neighbour_pairs;
    std::map<unsigned int, std::array<unsigned int, 2>> axes_of_struts;
    /** By axis and strut, as they are asked for. */
    mutable std::map<std::array<unsigned int, 2>, ParameterRanges> known_ranges;
  };
} // namespace auxfem

#endif
