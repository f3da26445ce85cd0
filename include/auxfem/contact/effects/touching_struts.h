#ifndef auxfem_contact_effects_touching_struts_h
#define auxfem_contact_effects_touching_struts_h

#include <auxfem/contact/effects/contact_effect.h>
#include <auxfem/contact/effects/strut_curves.h>

namespace auxfem
{
  /** Curves of the near axes, by axis. */
  using NearCurves = std::map<unsigned int, AxisCurve>;

  /** An axis and all near axes of an opposing strut. */
  struct FacingStrut
  {
    /** A near axis of that strut. */
    struct Target
    {
      unsigned int axis;
      unsigned int pair; ///< index in the caller's list of pairs
    };
    unsigned int        axis, line; ///< line: ContactAxis::line
    std::vector<Target> targets;
  };

  /** The point of a strut nearest to a point of an axis. */
  struct NearestOfStrut
  {
    FacingStrut::Target target;
    NearestPoint        point;
  };

  /** A contact point of an axis on a strut. */
  struct TouchingPoint
  {
    unsigned int   point;
    NearestOfStrut nearest;
  };

  /**
   * Contact points along the axes of struts, spaced by half a thickness in the
   * plane and a quarter of it in space. Pure geometry. Theory:
   * doc/theory/contact.md, Struts against struts.
   */
  class StrutContactPoints
  {
  public:
    /** @param curves must outlive the object. */
    StrutContactPoints(const StrutCurves &curves, unsigned int dimension);

    /** Groups a list of pairs by axis and opposing strut, sorted in this
     * order. */
    std::vector<FacingStrut>
    facing_struts(const std::vector<AxisPair> &pairs) const;

    /** Sorted contact points of an axis. */
    std::vector<TouchingPoint> touching(const FacingStrut &facing,
                                        const NearCurves  &now) const;

    /** Nearest point of the opposing strut to @p point, the point of the axis
     * at @p parameter. */
    NearestOfStrut nearest(const FacingStrut          &facing,
                           const NearCurves           &now,
                           const dealii::Tensor<1, 3> &point,
                           double                      parameter) const;

    /** Parameter of a contact point on its axis. */
    double parameter(const unsigned int axis, const unsigned int point) const
    {
      return double(point) / (n_points(axis) - 1);
    }

    /** Tributary length of a point (m). */
    double weight(unsigned int axis, unsigned int point) const;

  private:
    unsigned int n_points(unsigned int axis) const;

    /** Adds the contact points between @p begin and @p end.
     * @param chords of the targets */
    void find_touching(const FacingStrut              &facing,
                       const NearCurves               &now,
                       const std::vector<CurveChords> &chords,
                       unsigned int                    begin,
                       unsigned int                    end,
                       std::vector<TouchingPoint>     &points) const;

    const StrutCurves &curves;
    const unsigned int dimension;
    double             thickest = 0; ///< half (m)
  };

  /** A contact point of a strut on another strut or itself. */
  struct StrutTouch : Touch
  {
    /** The opposite point on the other strut. */
    struct Opposite
    {
      double parameter; ///< of the other axis
      /** Direction of the force on the first strut. */
      dealii::Tensor<1, 3> direction;
      /** Unit normal from the other strut, at the end of the step. */
      dealii::Tensor<1, 3> normal;
      /** Length (m) by which the derivative of a unit vector is divided. */
      double length;
    };

    unsigned int other; ///< axis of the point nearest to it
    double       parameter;
    double       weight;   ///< tributary length (m)
    double       distance; ///< of the two points at the end of the step (m)
    /** Whether the nearest point at the end of the step is not an end of the
     * other axis. */
    bool is_inside;
    /** The nearest point; for discrete gradients those of both states, the end
     * last, each with half of the force. */
    std::vector<Opposite> opposites = {};
    double stored_energy_defect     = 0; ///< work that is not stored (J)
  };

  /**
   * Relative motion at a contact point of two struts and its derivatives with
   * respect to the unknowns of the pair. Theory: doc/theory/contact.md, Struts
   * against struts.
   */
  class StrutTouchMotion
  {
  public:
    /** @param curves, touch, pair, unknowns must outlive the object;
     * @p unknowns are the local numbers of both axes, listed once for
     * self-contact */
    StrutTouchMotion(const StrutCurves      &curves,
                     unsigned int            dimension,
                     const StrutTouch       &touch,
                     const AxisPair         &pair,
                     const std::vector<int> &unknowns);

    /** Motion of the point relative to its last opposite point, for values by
     * local unknown. */
    dealii::Tensor<1, 3> difference(const Vector &values) const;

    /** Derivative of difference() with respect to the parameter of the opposite
     * point. */
    dealii::Tensor<1, 3> difference_slope(const Vector &values) const;

    /** Adds @p force on the point, and its reaction on the other axis at
     * @p opposite, to @p forces by local unknown. */
    void add_force(double                      opposite,
                   const dealii::Tensor<1, 3> &force,
                   double                     *forces) const;

    /** Gradient with respect to the unknowns of the pair: @p vector times the
     * motion of the point relative to the other axis at @p opposite. */
    std::vector<double> gradient(double                      opposite,
                                 const dealii::Tensor<1, 3> &vector) const;

    /** Gradient of @p vector times the tangent of the other axis at the last
     * opposite point. */
    std::vector<double>
    tangent_gradient(const dealii::Tensor<1, 3> &vector) const;

    /** Gradient of the parameter of an interior nearest point.
     * @param other the other axis */
    std::vector<double> nearest_change(const AxisCurve &other) const;

    /** @name Add stiffness blocks: derivatives of the negative forces on both
     * struts. */
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
    /** Calls @p add(first unknown of the node in the pair, share) for each
     * node. */
    template <class Add>
    void for_each_share(double opposite, const Add &add) const;

    /** First unknown of an axis within the pair. */
    unsigned int first_of(unsigned int axis) const;

    const StrutCurves      &curves;
    const unsigned int      dimension;
    const StrutTouch       &touch;
    const AxisPair         &pair;
    const std::vector<int> &unknowns;
  };
} // namespace auxfem

#endif
