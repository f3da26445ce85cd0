#ifndef auxfem_equations_effects_strut_contact_h
#define auxfem_equations_effects_strut_contact_h

#include <auxfem/equations/effects/strut_touch.h>
#include <auxfem/equations/strut_proximity.h>

namespace auxfem
{
  /** A point of contact between struts, for output. */
  struct StrutContactReport
  {
    unsigned int         strut, other;
    dealii::Point<3>     rest;         ///< on the axis (m)
    dealii::Tensor<1, 3> displacement; ///< m
    dealii::Tensor<1, 3> to_face;      ///< from the face to the axis, now (m)
    dealii::Tensor<1, 3> force;        ///< on the strut (N)
    double               depth;        ///< of penetration (m)
  };

  /**
   * Contact of struts with struts: at points along each of two axes a force of
   * ContactLaw against the point of the other axis that is nearest, if that is
   * nearer than half the sum of their thicknesses; half of it by the points of
   * either. The potential of all is exact, and the tangent its second
   * derivative. Coulomb's friction as in PlateContact. Theory: doc/theory.md,
   * Contact.
   *
   * After C. Meier, A. Popp, W. A. Wall, Comput. Methods Appl. Mech. Eng. 308,
   * 2016, 377-413 (Gauss points against the nearest point of the other axis).
   */
  class StrutContact : public ContactEffect<AxisPair, StrutTouch>
  {
  public:
    /** @param scene, model must outlive the object. Collective. */
    StrutContact(const Scene &scene, const LatticeModel &model);

    void register_in(StateLayout &layout) override;
    void register_blocks(TangentPattern &pattern) override;
    bool update_couplings(const State      &accepted,
                          std::vector<int> &wanted) override;
    void save(Records &records) const override;
    bool resume(const Records &records, std::vector<int> &wanted) override;
    void add_residual(const Evaluation &evaluation,
                      double           *residual,
                      EffectResults    *results) const override;
    void add_tangent(const Evaluation     &evaluation,
                     const EffectResults  *results,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const override;
    void account_step(const Evaluation    &step,
                      const EffectResults *results,
                      EnergyAccount       &account) const override;
    void raise_forces(const Evaluation    &evaluation,
                      const EffectResults *results,
                      double              *forces) const override;
    void raise_uncertain_forces(const Evaluation    &evaluation,
                                const EffectResults *results,
                                double               largest_displacement,
                                double               largest_rotation,
                                double              *forces) const override;

    bool may_touch() const override
    {
      return proximity.may_touch();
    }

    std::string why_not_acceptable(const Evaluation &step) const override;

    /**
     * Two struts that come to touch, or pass each other, on the straight way
     * between two states; none if there are none. The first state was given to
     * update_couplings(). Collective.
     */
    std::optional<std::array<unsigned int, 2>>
    first_to_touch(const State &from, const State &to) const;

    /** Struts that overlap at rest. */
    const std::vector<StrutOverlap> &overlaps() const
    {
      return proximity.overlaps();
    }

    /** All points that touch, of this rank. */
    std::vector<StrutContactReport> contacts(const EffectResults &results,
                                             const State         &state) const;

  private:
    using SpaceVector = dealii::Tensor<1, 3>;

    const std::vector<AxisPair> &near() const override
    {
      return proximity.near();
    }

    std::vector<int> unknowns_of(const AxisPair &pair) const override;
    std::vector<StrutTouch>
               touching(const Evaluation &evaluation) const override;
    ContactLaw law_at(const StrutTouch &touch) const override;
    /** Over the mean thickness of both. */
    Penetration penetration(const StrutTouch &touch) const override;

    SpaceVector difference(const StrutTouch &touch,
                           const Vector     &values) const override
    {
      return motion_of(touch).difference(values);
    }

    /** As first_to_touch(), of struts that go into each other by more than the
     * part @p allowed of half their thickness. */
    std::optional<std::array<unsigned int, 2>>
    first_too_near(const State &from, const State &to, double allowed) const;
    /** Values by global number: those given, or in @p room. Collective. */
    const std::vector<double> &of_all_ranks(const Vector        &values,
                                            std::vector<double> &room) const;

    NearCurves       curves_at(const State &state) const;
    StrutTouchMotion motion_of(const StrutTouch &touch) const;

    /** A point that touches, without forces. */
    StrutTouch touch_of(const FacingStrut    &facing,
                        const NearestOfStrut &found,
                        unsigned int          point) const;
    /** Adds the points that touch at an instant. */
    void touch(const FacingStrut       &facing,
               const NearCurves        &now,
               const Evaluation        &evaluation,
               std::vector<StrutTouch> &points) const;
    /** Adds those that touch at an end of a step between two states. */
    void touch_between(const FacingStrut       &facing,
                       const NearCurves        &before,
                       const NearCurves        &now,
                       const Evaluation        &step,
                       std::vector<StrutTouch> &points) const;
    /** Finds the friction at a point that has all else. */
    void rub(const Evaluation &evaluation, StrutTouch &touch) const;

    /** @name Add derivatives of minus the forces at a point to the block of its
     * pair. */
    ///@{
    void add_instant_block(const StrutTouch       &touch,
                           const StrutTouchMotion &motion,
                           const AxisCurve        &other,
                           double                  by_position,
                           std::vector<double>    &block) const;
    void add_mean_block(const StrutTouch       &touch,
                        const StrutTouchMotion &motion,
                        std::vector<double>    &block) const;
    void add_friction_block(const StrutTouch       &touch,
                            const StrutTouchMotion &motion,
                            const AxisCurve        &other,
                            const Evaluation       &evaluation,
                            const TangentFactors   &factors,
                            std::vector<double>    &block) const;
    ///@}

    const StrutCurves        curves;
    const StrutContactPoints points_of_axes;
    StrutProximity           proximity;
    std::vector<FacingStrut> facing;
    /** Local unknowns of the axes among `coupled`. */
    std::map<unsigned int, std::vector<int>> local_unknowns;
    unsigned int                             numerical_entry = 0;
  };
} // namespace auxfem

#endif
