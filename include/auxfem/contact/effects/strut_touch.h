#ifndef auxfem_contact_effects_strut_touch_h
#define auxfem_contact_effects_strut_touch_h

#include <auxfem/contact/effects/contact_effect.h>
#include <auxfem/contact/effects/strut_curves.h>

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

  /** A point of a strut that touches another one, or itself. */
  struct StrutTouch : Touch
  {
    /** One point of the other strut that belongs to it. */
    struct Opposite
    {
      double parameter; ///< of the other axis
      /** Of the force on the first strut. */
      dealii::Tensor<1, 3> direction;
      /** From the other strut, at the end of the step. */
      dealii::Tensor<1, 3> normal;
      /** Derivative of the direction is that of a unit vector over this (m). */
      double length;
    };

    unsigned int other; ///< axis of the point nearest to it
    double       parameter;
    double       weight;   ///< length that the point stands for (m)
    double       distance; ///< of the two points at the end of the step (m)
    /** Whether the nearest point of the end moves along the other axis. */
    bool is_inside;
    /** At an instant the nearest point; in a step between two states those of
     * both, each with half of the force; the last is that of the end. */
    std::vector<Opposite> opposites = {};
    double stored_energy_defect     = 0; ///< work that is not stored (J)
  };

  /**
   * How a point of a strut that touches another one moves against that, and
   * how this depends on the unknowns of the pair of axes. Theory:
   * doc/theory.md, Contact, Struts against struts.
   */
  class StrutTouchMotion
  {
  public:
    /** @param curves, touch, pair, unknowns must outlive the object; @p pair of
     * axes, @p unknowns local numbers of both, of an axis with itself once */
    StrutTouchMotion(const StrutCurves      &curves,
                     unsigned int            dimension,
                     const StrutTouch       &touch,
                     const AxisPair         &pair,
                     const std::vector<int> &unknowns);

    /** Motion of the point against its last opposite, of values by local
     * unknown. */
    dealii::Tensor<1, 3> difference(const Vector &values) const;

    /** Its derivative by the parameter of that opposite. */
    dealii::Tensor<1, 3> difference_slope(const Vector &values) const;

    /** Adds @p force on the point, and minus that on the one of the other axis
     * at @p opposite, to @p forces by local unknown. */
    void add_force(double                      opposite,
                   const dealii::Tensor<1, 3> &force,
                   double                     *forces) const;

    /** Derivative by the pair's unknowns of the product of @p vector with the
     * motion of the point against the one of the other axis at @p opposite. */
    std::vector<double> gradient(double                      opposite,
                                 const dealii::Tensor<1, 3> &vector) const;

    /** The same of the product with the tangent of the other axis at its last
     * opposite. */
    std::vector<double>
    tangent_gradient(const dealii::Tensor<1, 3> &vector) const;

    /** Derivative of the parameter of the nearest point, which is inside, by
     * the pair's unknowns.
     * @param other the other axis */
    std::vector<double> nearest_change(const AxisCurve &other) const;

    /** @name Add derivatives of minus the forces on both struts by the pair's
     * unknowns to a square block. */
    ///@{
    void add_instant_block(const AxisCurve     &other,
                           double               by_position,
                           std::vector<double> &block) const;
    void add_mean_block(std::vector<double> &block) const;
    void add_friction_block(const CoulombFriction &friction,
                            const AxisCurve       &other,
                            const Evaluation      &evaluation,
                            const TangentFactors  &factors,
                            std::vector<double>   &block) const;
    ///@}

  private:
    /** Calls @p add(first of the pair's unknowns, share) for each node. */
    template <class Add>
    void for_each_share(double opposite, const Add &add) const;

    /** First of the pair's unknowns that belong to an axis. */
    unsigned int first_of(unsigned int axis) const;

    const StrutCurves      &curves;
    const unsigned int      dimension;
    const StrutTouch       &touch;
    const AxisPair         &pair;
    const std::vector<int> &unknowns;
  };
} // namespace auxfem

#endif
