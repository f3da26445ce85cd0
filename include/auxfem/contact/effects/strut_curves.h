#ifndef auxfem_contact_effects_strut_curves_h
#define auxfem_contact_effects_strut_curves_h

#include <auxfem/contact/axis_curve.h>
#include <auxfem/model/lattice_model.h>

#include <array>
#include <map>
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

  /** Parts of the parameter of an element, [begin, end] each. */
  using ParameterRanges = std::vector<std::array<double, 2>>;

  /** A node that two axes share: its parameter on either. */
  struct CommonNode
  {
    std::array<double, 2> end;
  };

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
    void shape(const unsigned int axis,
               const double       parameter,
               double            *values,
               double            *slopes = nullptr) const
    {
      basis_of[axis]->values_at(parameter, values, slopes);
    }

    /** By how much an axis turns (rad): the largest derivative of the motion
     * along it, at as many points as it has nodes.
     * @param motion of its nodes, dimension of space at each (m) */
    double axis_rotation(unsigned int axis, const double *motion) const;

    /** How much it turns at most if none of its nodes moves by more than this
     * (rad). */
    double largest_axis_rotation(unsigned int axis, double motion) const;

    /** Whether two axes belong to one strut or to struts with a common joint.
     */
    bool are_neighbours(unsigned int one, unsigned int other) const;

    /** Whether two axes cannot move against each other, or have no thickness
     * that could touch: of one rigid part. */
    bool never_touch(unsigned int one, unsigned int other) const;

    /** Ends of two axes that move together. */
    std::vector<CommonNode> common_nodes(unsigned int one,
                                         unsigned int other) const;

    /** Pairs of axes with a common node that may touch, and axes that may touch
     * themselves, sorted. */
    const std::vector<AxisPair> &connected() const
    {
      return connected_pairs;
    }

    /** Half the sum of the thicknesses of both (m). */
    double thickness(unsigned int one, unsigned int other) const
    {
      return axes[one].half_thickness + axes[other].half_thickness;
    }

    /** How far at rest a point of @p axis is from the strut of @p other if it
     * may touch that (m). Neighbours come apart as far as they are thick before
     * they count: at a joint they bend. */
    double free_distance(const unsigned int axis,
                         const unsigned int other) const
    {
      return (are_neighbours(axis, other) ? 2 : 1) * thickness(axis, other);
    }

    /** The parts of @p axis that may touch the strut of @p other. */
    const ParameterRanges &free_ranges(unsigned int axis,
                                       unsigned int other) const;

    /** The parts of @p other, of the same strut, that are so far along it from a
     * point of @p axis that these can touch: bent round, half a circle of its
     * thickness. */
    ParameterRanges self_contact_ranges(unsigned int axis,
                                        double       parameter,
                                        unsigned int other) const;

    /** Axes of a strut: [begin, end) in the list. */
    std::array<unsigned int, 2> axes_of(const unsigned int strut) const
    {
      return axes_of_struts.at(strut);
    }

    const std::vector<ContactAxis> &list() const
    {
      return axes;
    }

  private:
    /** Shape functions in powers of the parameter, by node. */
    struct Basis
    {
      /** Of all nodes; derivatives if these are given. */
      void
      values_at(double parameter, double *values, double *derivatives) const;

      /** Largest derivative of a motion by the parameter, at these points.
       * @param motion of each node, by component */
      template <unsigned int dimension>
      double largest_slope(const double *motion) const;

      unsigned int        degree;
      std::vector<double> coefficients; ///< of each node, degree + 1
      /** Derivatives at points at equal distances: by point, then node. */
      std::vector<double> slopes;
      /** The largest sum of their magnitudes at a point. */
      double steepest = 0;
    };

    static Basis    make_basis(unsigned int order);
    AxisCurve       arc_at_rest(const ContactAxis &axis) const;
    void            find_connected();
    ParameterRanges find_free_ranges(unsigned int axis,
                                     unsigned int other) const;

    const LatticeModel                      &model;
    const std::vector<ContactAxis>          &axes;
    std::map<unsigned int, Basis>            bases; ///< by order
    std::vector<const Basis *>               basis_of;
    std::map<unsigned int, AxisCurve>        arcs; ///< at rest
    std::vector<AxisPair>                    connected_pairs;
    std::vector<std::array<unsigned int, 2>> axes_of_struts; ///< begin, end
    /** By axis and strut, as they are asked for. */
    mutable std::map<std::array<unsigned int, 2>, ParameterRanges> known_ranges;
  };
} // namespace auxfem

#endif
