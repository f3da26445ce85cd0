#ifndef auxfem_equations_effects_plate_contact_h
#define auxfem_equations_effects_plate_contact_h

#include <auxfem/equations/effects/contact_effect.h>
#include <auxfem/equations/plate_proximity.h>

namespace auxfem
{
  /** A point of a strut that touches a plate. */
  struct PlateTouch : Touch
  {
    unsigned int point; ///< of the axis
    unsigned int plate; ///< in the order of the scene
    /** Of the force on the strut: out of the plate. In a step between two
     * states not quite of length 1. */
    dealii::Tensor<1, 3> normal = {};
    /** By minus this the depth changes with the position. */
    dealii::Tensor<1, 3> now     = {};
    dealii::Tensor<2, 3> turning = {}; ///< of `normal`, by the position (1/m)

    /** Of the plate on the strut (N). */
    dealii::Tensor<1, 3> whole_force() const
    {
      return force * normal + friction.force;
    }
  };

  /** What a plate and the struts exert on each other. */
  struct PlateReport
  {
    dealii::Tensor<1, 3> displacement; ///< of the plate (m)
    dealii::Tensor<1, 3> force;        ///< of the struts on the plate (N)
    /** The largest penetration over the thickness of the strut. */
    double largest_penetration = 0;
  };

  /** A point of a strut that touches a plate, for output. */
  struct ContactReport
  {
    unsigned int         strut, plate;
    dealii::Point<3>     rest;         ///< on the axis (m)
    dealii::Tensor<1, 3> displacement; ///< m
    /** From the face that touches to the axis, now (m). */
    dealii::Tensor<1, 3> to_face;
    dealii::Tensor<1, 3> force; ///< of the plate on the strut (N)
    double               depth; ///< of penetration (m)
  };

  /**
   * Contact of struts with rigid plates: at every contact point of an axis that
   * is nearer to the surface than half the thickness, a force of ContactLaw
   * along the normal, times the length that the point stands for, and Coulomb's
   * friction against the motion along the surface, regularised as
   * v / sqrt(v^2 + v0^2). Forces act on the axis. Theory: doc/theory.md,
   * Contact.
   *
   * Only struts near a plate are coupled with it; which these are follows from
   * accepted states.
   */
  class PlateContact : public ContactEffect<PlatePair, PlateTouch>
  {
  public:
    /** @param scene, model must outlive the object. Throws InputError for struts
     * without thickness, and for such as lie in a plate at rest. Collective. */
    PlateContact(const Scene &scene, const LatticeModel &model);

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
      return !near().empty();
    }

    std::string why_not_acceptable(const Evaluation &step) const override;

    /** Number of plates. */
    unsigned int n_plates() const;

    /** By plate, over all ranks. Collective. */
    std::vector<PlateReport> reports(const EffectResults &results,
                                     const State         &state) const;

    /** All points that touch, of this rank. */
    std::vector<ContactReport> contacts(const EffectResults &results,
                                        const State         &state) const;

    /** Name of a plate. */
    const std::string &name(unsigned int plate) const;

    /** Lines that show a plate at rest (m); @p size of what has no end. */
    std::vector<std::vector<dealii::Point<3>>> outline(unsigned int plate,
                                                       double       size) const;

  private:
    using SpaceVector = dealii::Tensor<1, 3>;

    const std::vector<PlatePair> &near() const override
    {
      return proximity.near();
    }

    std::vector<int> unknowns_of(const PlatePair &pair) const override;
    std::vector<PlateTouch>
                touching(const Evaluation &evaluation) const override;
    ContactLaw  law_at(const PlateTouch &touch) const override;
    Penetration penetration(const PlateTouch &touch) const override;
    SpaceVector difference(const PlateTouch &touch,
                           const Vector     &values) const override;

    const RigidSurface &surface_of(const PlateTouch &touch) const;

    /** Of a contact point from the point of reference of the plate (m). */
    SpaceVector position(const PlateTouch &touch,
                         const Vector     &displacement) const;

    /** Of a point of a near pair, if it touches. */
    std::optional<PlateTouch> press(const Evaluation &evaluation,
                                    PlateTouch        touch) const;

    /** Calls @p add(unknown, component, share) for all unknowns of a point's
     * pair: its motion against the plate is their sum times the share. */
    template <class Add>
    void add_to_unknowns(const PlateTouch &touch, const Add &add) const;

    /** Derivative of minus the force on the strut by its motion against the
     * plate (N/m). */
    dealii::Tensor<2, 3> stiffness_of(const PlateTouch &touch,
                                      double            by_position,
                                      double            by_velocity) const;

    const std::vector<ContactPoints> points_of_axes; ///< of each axis
    PlateProximity                   proximity;
  };
} // namespace auxfem

#endif
