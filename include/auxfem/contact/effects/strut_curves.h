#ifndef auxfem_contact_effects_strut_curves_h
#define auxfem_contact_effects_strut_curves_h

#include <auxfem/contact/axis_curve.h>
#include <auxfem/contact/effects/contact_axes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace auxfem
{
  /** Two axes, the lower number first. */
  using AxisPair = std::array<unsigned int, 2>;

  /** A node shared by two axes: its parameter on each axis. */
  struct CommonNode
  {
    std::array<double, 2> end;
  };

  /**
   * Axes of struts as curves, with the parameter ranges in which contact is
   * possible. Ranges closer to each other at rest than the thickness, as at a
   * common joint, are excluded.
   */
  class StrutCurves
  {
  public:
    /** @param model, axes must outlive the object. */
    StrutCurves(const LatticeModel             &model,
                const std::vector<ContactAxis> &axes);

    /** The displaced curve of an axis.
     * @param unknowns of the axis, as indices into @p values (m) */
    AxisCurve
    curve(unsigned int axis, const int *unknowns, const double *values) const;

    /** The curve at rest. */
    AxisCurve at_rest(unsigned int axis) const;

    /** Shape functions of an axis by ContactAxis::n_nodes() at a parameter;
     * derivatives are written
     * if @p slopes is given. */
    void shape(const unsigned int axis,
               const double       parameter,
               double            *values,
               double            *slopes = nullptr) const
    {
      basis_of[axis]->values_at(parameter, values, slopes);
      const auto &factors = axes[axis].axis_factors;
      std::copy(factors.begin(), factors.end(), values + axes[axis].order + 1);
      if (slopes != nullptr)
        std::fill_n(slopes + axes[axis].order + 1, factors.size(), 0.);
    }

    /** Rotation of an axis (rad): largest derivative of the motion along it,
     * sampled at as many points as nodes.
     * @param motion of its nodes (m), `dimension` components each */
    double axis_rotation(unsigned int axis, const double *motion) const;

    /** Upper bound of the rotation (rad) for nodal motions of at most @p motion
     * (m). */
    double largest_axis_rotation(unsigned int axis, double motion) const;

    /** Whether two axes belong to one strut or to struts with a common joint.
     */
    bool are_neighbours(unsigned int one, unsigned int other) const;

    /** Takes struts out of contact, or back into it.
     * @param removed by strut */
    void set_removed(std::vector<bool> removed)
    {
      removed_struts = std::move(removed);
    }

    /** By strut; empty: none. */
    const std::vector<bool> &removed() const
    {
      return removed_struts;
    }

    bool is_removed(const unsigned int axis) const
    {
      return !removed_struts.empty() && removed_struts[axes[axis].strut];
    }

    /** Whether contact is impossible: an axis is removed, both belong to one
     * rigid part, or they have no thickness; or another pair stands for it in
     * an infinite lattice. */
    bool never_touch(unsigned int one, unsigned int other) const;

    /** Ends of two axes that move together. */
    std::vector<CommonNode> common_nodes(unsigned int one,
                                         unsigned int other) const;

    /** Sorted pairs of axes with a common node that may touch, including
     * self-contact. */
    const std::vector<AxisPair> &connected() const
    {
      return connected_pairs;
    }

    /** Half the sum of the thicknesses of both (m). */
    double thickness(unsigned int one, unsigned int other) const
    {
      return axes[one].half_thickness + axes[other].half_thickness;
    }

    /** Distance at rest (m) from which a point of @p axis may touch the strut
     * of @p other. Neighbours need twice the distance because they bend towards
     * each other at the joint. */
    double free_distance(const unsigned int axis,
                         const unsigned int other) const
    {
      return (are_neighbours(axis, other) ? 2 : 1) * thickness(axis, other);
    }

    /** Ranges of @p axis that may touch the strut of @p other. */
    const ParameterRanges &free_ranges(unsigned int axis,
                                       unsigned int other) const;

    /** Ranges of @p other, on the same strut, that a point of @p axis can
     * touch: at least half a circle of the thickness away along the strut. */
    ParameterRanges self_contact_ranges(unsigned int axis,
                                        double       parameter,
                                        unsigned int other) const;

    /** Axes of a strut or copy: [begin, end) in the list. */
    std::array<unsigned int, 2> axes_of(const unsigned int line) const
    {
      return axes_of_lines.at(line);
    }

    const std::vector<ContactAxis> &list() const
    {
      return axes;
    }

  private:
    /** Shape functions in monomial form, by node. */
    struct Basis
    {
      /** Values of all nodes; derivatives unless null. */
      void
      values_at(double parameter, double *values, double *derivatives) const;

      /** Largest parameter derivative of a motion at the sampled points.
       * @param motion by node, then component */
      template <unsigned int dimension>
      double largest_slope(const double *motion) const;

      unsigned int        degree;
      std::vector<double> coefficients; ///< of each node, degree + 1
      /** Derivatives at equidistant points: by point, then node. */
      std::vector<double> slopes;
      /** Largest sum of their magnitudes at a point. */
      double steepest = 0;
    };

    static Basis    make_basis(unsigned int order);
    AxisCurve       arc_at_rest(const ContactAxis &axis) const;
    void            find_connected();
    ParameterRanges find_free_ranges(unsigned int axis,
                                     unsigned int other) const;

    const LatticeModel                      &model;
    const std::vector<ContactAxis>          &axes;
    std::vector<bool>                        removed_struts;
    std::map<unsigned int, Basis>            bases; ///< by order
    std::vector<const Basis *>               basis_of;
    std::map<unsigned int, AxisCurve>        arcs; ///< at rest
    std::vector<AxisPair>                    connected_pairs;
    std::vector<std::array<unsigned int, 2>> axes_of_lines; ///< begin, end
    /** Cache by axis and line: both in one number. */
    mutable std::unordered_map<std::uint64_t, ParameterRanges> known_ranges;
  };
} // namespace auxfem

#endif
