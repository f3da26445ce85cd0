#ifndef auxfem_equations_effects_strut_contact_h
#define auxfem_equations_effects_strut_contact_h

#include <auxfem/contact/contact_law.h>
#include <auxfem/equations/effect.h>
#include <auxfem/equations/sliding.h>
#include <auxfem/equations/strut_proximity.h>

namespace auxfem
{
  /** A point of a strut that touches another one, or itself. */
  struct StrutTouch
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

    unsigned int pair;  ///< of axes, on this rank
    unsigned int axis;  ///< whose point it is
    unsigned int other; ///< axis of the point nearest to it
    double       parameter;
    /** Length that the point stands for (m). */
    double weight;
    double depth; ///< of penetration at the end of the step (m)
    double force; ///< N
    double slope; ///< its derivative by the depth (N/m)
    /** At an instant the nearest point; in a step between two states those of
     * both, each with half of the force; the last is that of the end. */
    std::vector<Opposite> opposites;
    /** Whether the nearest point of the end moves along the other axis. */
    bool          is_inside;
    FrictionForce friction = {}; ///< on the first strut
    double        missed   = 0;  ///< work that is not stored (J)
  };

  /** Points that touch in an evaluation. */
  struct StrutContactResults : EffectResults
  {
    std::vector<StrutTouch> points;
  };

  /** A point of contact between struts, for output. */
  struct StrutContactReport
  {
    unsigned int         strut, other;
    dealii::Point<3>     rest;         ///< on the axis (m)
    dealii::Tensor<1, 3> displacement; ///< m
    dealii::Tensor<1, 3> to_face;      ///< from the face to the axis, now (m)
    dealii::Tensor<1, 3> force;        ///< on the strut (N)
    double               depth;        ///< of penetration (m)
    /** Over the mean thickness of both. */
    double penetration;
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
  class StrutContact : public Effect
  {
  public:
    /** @param scene, model must outlive the object. Collective. */
    StrutContact(const Scene &scene, const LatticeModel &model);

    bool is_linear() const override;
    void register_in(StateLayout &layout) override;
    void register_blocks(TangentPattern &pattern) override;
    bool update_couplings(const State      &accepted,
                          std::vector<int> &wanted) override;
    void save(Records &records) const override;
    bool resume(const Records &records, std::vector<int> &wanted) override;
    std::unique_ptr<EffectResults> make_results() const override;
    void                           add_residual(const Evaluation &evaluation,
                                                double           *residual,
                                                EffectResults    *results) const override;
    void                           add_tangent(const Evaluation     &evaluation,
                                               const EffectResults  *results,
                                               const TangentFactors &factors,
                                               TangentMatrix        &matrix) const override;
    void                           account(const Evaluation    &evaluation,
                                           const EffectResults *results,
                                           EnergyAccount       &account) const override;
    void                           account_step(const Evaluation    &step,
                                                const EffectResults *results,
                                                EnergyAccount       &account) const override;
    void                           account_stage(const Evaluation    &stage,
                                                 const EffectResults *results,
                                                 EnergyAccount       &account) const override;
    void                           raise_forces(const Evaluation    &evaluation,
                                                const EffectResults *results,
                                                double              *forces) const override;
    void        raise_uncertain_forces(const Evaluation    &evaluation,
                                       const EffectResults *results,
                                       double               largest_displacement,
                                       double               largest_rotation,
                                       double              *forces) const override;
    bool        may_touch() const override;
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
    /** Two axes that this rank has rows of, with the local unknowns of both,
     * of an axis with itself once. */
    struct Coupled
    {
      AxisPair         axes;
      std::vector<int> unknowns;
    };

    /** The points of an axis against all near axes of a strut. */
    struct Facing
    {
      /** One of them. */
      struct Target
      {
        unsigned int axis, pair;
      };
      unsigned int        axis, strut;
      std::vector<Target> targets;
    };

    /** The curves of the axes that are near another one, by axis. */
    using Curves = std::map<unsigned int, AxisCurve>;

    /** The nearest of the targets of a point. */
    struct Nearest
    {
      Facing::Target target;
      NearestPoint   point;
    };

    using SpaceVector = dealii::Tensor<1, 3>;

    /** As first_to_touch(), of struts that go into each other by more than the
     * part @p allowed of half their thickness. */
    std::optional<std::array<unsigned int, 2>>
    first_too_near(const State &from, const State &to, double allowed) const;
    const std::vector<double> &of_all_ranks(const Vector        &values,
                                            std::vector<double> &room) const;
    void                       want_unknowns(std::vector<int> &wanted) const;
    void                       find_facing();
    bool                       takes_part(const AxisPair &pair) const;

    Curves       curves_at(const State &state) const;
    unsigned int n_points(unsigned int axis) const;
    double       parameter(unsigned int axis, unsigned int point) const;
    double       weight(unsigned int axis, unsigned int point) const;
    ContactLaw law(unsigned int axis, unsigned int other, double weight) const;
    double     scale_of(unsigned int axis, unsigned int other) const;
    /** Of the two points that touch at the end of the step (m). */
    double                    distance(const StrutTouch &touch) const;
    Nearest                   nearest(const Facing      &facing,
                                      const Curves      &curves,
                                      const SpaceVector &point,
                                      double             parameter) const;
    void                      find_touching(const Facing              &facing,
                                            const Curves              &curves,
                                            unsigned int               begin,
                                            unsigned int               end,
                                            std::vector<unsigned int> &points) const;
    std::vector<unsigned int> touching_points(const Facing &facing,
                                              const Curves &curves) const;
    StrutTouch                touch_of(const Facing  &facing,
                                       const Nearest &found,
                                       unsigned int   point) const;
    void                      touch(const Facing            &facing,
                                    const Curves            &curves,
                                    const Evaluation        &evaluation,
                                    std::vector<StrutTouch> &points) const;
    void                      touch_between(const Facing            &facing,
                                            const Curves            &before,
                                            const Curves            &curves,
                                            const Evaluation        &step,
                                            std::vector<StrutTouch> &points) const;
    void        rub(const Evaluation &evaluation, StrutTouch &touch) const;
    SpaceVector difference(const StrutTouch &touch, const Vector &values) const;
    /** Its derivative by the parameter of the nearest point. */
    SpaceVector difference_slope(const StrutTouch &touch,
                                 const Vector     &values) const;
    /** What slides of those that this rank counts. */
    std::vector<Sliding> sliding(const std::vector<StrutTouch> &points,
                                 const Evaluation              &step) const;

    /** Derivative by the pair's unknowns of the product of @p vector with the
     * motion of the point against its opposite; with its @p slope instead along
     * the other axis that of the tangent there. */
    ///@{
    std::vector<double> gradient(const StrutTouch  &touch,
                                 double             opposite,
                                 const SpaceVector &vector) const;
    std::vector<double> tangent_gradient(const StrutTouch  &touch,
                                         double             opposite,
                                         const SpaceVector &vector) const;
    ///@}
    template <class Add>
    void for_each_share(const StrutTouch &touch,
                        double            opposite,
                        const Add        &add) const;
    /** Derivative of the parameter of the nearest point by the pair's unknowns.
     */
    std::vector<double> nearest_change(const StrutTouch &touch,
                                       const AxisCurve  &other) const;
    void                add_instant_block(const StrutTouch    &touch,
                                          const AxisCurve     &other,
                                          double               by_position,
                                          std::vector<double> &block) const;
    void                add_mean_block(const StrutTouch    &touch,
                                       std::vector<double> &block) const;
    void                add_friction_block(const StrutTouch     &touch,
                                           const AxisCurve      &other,
                                           const Evaluation     &evaluation,
                                           const TangentFactors &factors,
                                           std::vector<double>  &block) const;
    bool                is_owned(const StrutTouch &touch) const
    {
      return axes[touch.axis].is_owned;
    }

    const LatticeModel            &model;
    const ContactParameters        parameters;
    const CoulombFriction          friction;
    const unsigned int             dimension;
    const std::vector<ContactAxis> axes;
    const StrutCurves              curves;
    StrutProximity                 proximity;
    std::vector<Coupled>           coupled;
    std::vector<Facing>            facing;
    /** Local unknowns of the axes among `coupled`. */
    std::map<unsigned int, std::vector<int>> local_unknowns;
    double                                   thickest        = 0; ///< half (m)
    std::size_t                              first_block     = 0;
    unsigned int                             contact_entry   = 0;
    unsigned int                             numerical_entry = 0;
    FrictionAccount                          friction_account;
  };
} // namespace auxfem

#endif
