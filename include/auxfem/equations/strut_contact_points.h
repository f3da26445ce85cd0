#ifndef auxfem_equations_strut_contact_points_h
#define auxfem_equations_strut_contact_points_h

#include <auxfem/equations/strut_curves.h>

namespace auxfem
{
  /** The curves of the axes that are near another one, by axis. */
  using NearCurves = std::map<unsigned int, AxisCurve>;

  /** An axis against all near axes of a strut. */
  struct FacingStrut
  {
    /** One of them. */
    struct Target
    {
      unsigned int axis;
      unsigned int pair; ///< of both, in the list that the caller has
    };
    unsigned int        axis, strut;
    std::vector<Target> targets;
  };

  /** The point of a strut that is nearest to a point of an axis. */
  struct NearestOfStrut
  {
    FacingStrut::Target target;
    NearestPoint        point;
  };

  /** A point of an axis that touches a strut. */
  struct TouchingPoint
  {
    unsigned int   point;
    NearestOfStrut nearest;
  };

  /**
   * Points along the axes of struts that may touch other struts, one to each
   * half thickness in the plane and four in space, and which of them do. Pure
   * geometry. Theory: doc/theory.md, Contact, Struts against struts.
   */
  class StrutContactPoints
  {
  public:
    /** @param curves must outlive the object. */
    StrutContactPoints(const StrutCurves &curves, unsigned int dimension);

    /** Each axis of a list of pairs against each strut, in this order. */
    std::vector<FacingStrut>
    facing_struts(const std::vector<AxisPair> &pairs) const;

    /** Points of an axis that are nearer to a strut than their thickness,
     * sorted. */
    std::vector<TouchingPoint> touching(const FacingStrut &facing,
                                        const NearCurves  &now) const;

    /** The point of a strut that is nearest to @p point, which is that of the
     * axis at @p parameter. */
    NearestOfStrut nearest(const FacingStrut          &facing,
                           const NearCurves           &now,
                           const dealii::Tensor<1, 3> &point,
                           double                      parameter) const;

    /** Of a point along its axis. */
    double parameter(const unsigned int axis, const unsigned int point) const
    {
      return double(point) / (n_points(axis) - 1);
    }

    /** Length that a point stands for (m). */
    double weight(unsigned int axis, unsigned int point) const;

  private:
    unsigned int n_points(unsigned int axis) const;

    /** Adds those between @p begin and @p end that touch. */
    void find_touching(const FacingStrut          &facing,
                       const NearCurves           &now,
                       unsigned int                begin,
                       unsigned int                end,
                       std::vector<TouchingPoint> &points) const;

    const StrutCurves &curves;
    const unsigned int dimension;
    double             thickest = 0; ///< half (m)
  };
} // namespace auxfem

#endif
