#ifndef auxfem_equations_effects_plate_contact_h
#define auxfem_equations_effects_plate_contact_h

#include <auxfem/contact/contact_law.h>
#include <auxfem/equations/contact_points.h>
#include <auxfem/equations/effect.h>
#include <auxfem/equations/sliding.h>

#include <optional>

namespace auxfem
{
  /** A point of a strut that touches a plate. */
  struct TouchingPoint
  {
    unsigned int pair;  ///< of strut and plate, on this rank
    unsigned int axis;  ///< in the list of all
    unsigned int point; ///< of the axis
    unsigned int plate; ///< in the order of the scene
    /** Penetration at the end of the step or at the instant (m). */
    double depth = 0;
    double force = 0; ///< across the surface (N)
    double slope = 0; ///< its derivative by the depth (N/m)
    /** Of the force on the strut: out of the plate. In a step between two
     * states not quite of length 1. */
    dealii::Tensor<1, 3> normal = {};
    /** By minus this the depth changes with the position. */
    dealii::Tensor<1, 3> now      = {};
    dealii::Tensor<2, 3> turning  = {}; ///< of `normal`, by the position (1/m)
    FrictionForce        friction = {}; ///< on the strut
  };

  /** Points that touch in an evaluation. */
  struct PlateContactResults : EffectResults
  {
    std::vector<TouchingPoint> points;
  };

  /** What a plate and the struts exert on each other. */
  struct PlateReport
  {
    dealii::Tensor<1, 3> displacement; ///< of the plate (m)
    dealii::Tensor<1, 3> force;        ///< of the struts on the plate (N)
    /** The largest penetration over the thickness of the strut. */
    double largest_penetration = 0;
  };

  /** Where a strut has gone deepest into a plate. */
  struct DeepestContact
  {
    double       part; ///< of the thickness of the strut
    unsigned int strut, plate;
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
  class PlateContact : public Effect
  {
  public:
    /** @param scene, model must outlive the object. Throws InputError for struts
     * without thickness, and for such as lie in a plate at rest. Collective. */
    PlateContact(const Scene &scene, const LatticeModel &model);

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

    /** Number of plates. */
    unsigned int n_plates() const;

    /** By plate, over all ranks. Collective. */
    std::vector<PlateReport> reports(const EffectResults &results,
                                     const State         &state) const;

    /** Of the struts of this rank, if any touches. */
    std::optional<DeepestContact> deepest(const EffectResults &results) const;

    /** All points that touch, of this rank. */
    std::vector<ContactReport> contacts(const EffectResults &results,
                                        const State         &state) const;

    /** Name of a plate. */
    const std::string &name(unsigned int plate) const;

    /** Lines that show a plate at rest (m); @p size of what has no end. */
    std::vector<std::vector<dealii::Point<3>>> outline(unsigned int plate,
                                                       double       size) const;

  private:
    struct Plate
    {
      const PlateDefinition *definition;
      std::vector<int>       unknowns; ///< global numbers
    };

    /** An axis near a plate. */
    struct Near
    {
      unsigned int axis, plate;

      bool operator<(const Near &other) const
      {
        return std::pair(axis, plate) < std::pair(other.axis, other.plate);
      }
      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &axis &plate;
      }

      bool operator==(const Near &other) const
      {
        return axis == other.axis && plate == other.plate;
      }
    };

    /** One that this rank has a part in: local unknowns of the nodes of the
     * axis, then of the plate. */
    struct Coupled
    {
      Near             near;
      std::vector<int> unknowns;
    };

    using SpaceVector = dealii::Tensor<1, 3>;

    void refuse_plates_in_struts() const;

    /** By plate, of the plates' points of reference. Collective. */
    std::vector<SpaceVector> plate_values(const Vector &values) const;

    /** Gap (m) that an owned axis has at least; the plate is displaced. */
    double least_gap(unsigned int       axis,
                     unsigned int       plate,
                     const Vector      &displacement,
                     const SpaceVector &of_plate) const;

    /** Of the nodes of an owned axis against the plate (m). */
    double largest_motion(unsigned int       axis,
                          const Vector      &increment,
                          const SpaceVector &of_plate) const;

    /** Also keeps how far all others are from all plates. Collective. */
    std::vector<Near> find_near(const State &accepted);

    /** Whether what the last search has found tells that no strut is nearer to
     * a plate than @p margin (m) at the displacement @p now, or after moves of
     * at most @p further (m) that count twice. Collective. */
    bool are_clear(const Vector &now, double further, double margin) const;

    /** Largest size of the displacements in @p values, or in the change from
     * @p from, of all nodes and plates of this rank. */
    double largest_displacement(const Vector &values) const;
    double largest_displacement(const Vector &values, const Vector &from) const;

    /** Of struts from plates beyond which they are not near (m). */
    double least_margin() const
    {
      return 4 * thickest;
    }

    /** Adds to @p wanted the unknowns of the pairs that this rank has rows of. */
    void want_unknowns(std::vector<int> &wanted) const;

    /** Whether this rank has rows of a pair. */
    bool takes_part(const Near &pair) const;

    ContactLaw law(unsigned int axis, unsigned int point) const;

    /** Half of it (m), of a rigid strut without a section that of the thickest
     * one. */
    double thickness_of(const ContactAxis &axis) const;

    /** Of a contact point less that of the plate, of values by local unknown.
     */
    SpaceVector difference(const Coupled &pair,
                           unsigned int   point,
                           const Vector  &values) const;
    /** Of a contact point from the point of reference of the plate (m). */
    SpaceVector position(const Coupled &pair,
                         unsigned int   point,
                         const Vector  &displacement) const;
    /** Whether this rank counts the point. */
    bool is_owned(const TouchingPoint &touching) const;

    /** Adds the points of a pair that touch. */
    void press(const Coupled              &pair,
               const Evaluation           &evaluation,
               unsigned int                block,
               std::vector<TouchingPoint> &points) const;
    /** Calls @p add(unknown, component, share) for all unknowns of a point's
     * pair: its motion against the plate is their sum times the share. */
    template <class Add>
    void add_to_unknowns(const TouchingPoint &touching, const Add &add) const;

    /** Derivative of minus the force on the strut by its motion against the
     * plate (N/m). */
    dealii::Tensor<2, 3> stiffness_of(const TouchingPoint &touching,
                                      double               by_position,
                                      double               by_velocity) const;

    /** Depth over the thickness of the strut. */
    double penetration(const TouchingPoint &touching) const;

    /** What slides of those that this rank counts. */
    std::vector<Sliding> sliding(const std::vector<TouchingPoint> &points,
                                 const Evaluation                 &step) const;

    /** Empty if the points of an owned axis do not go too deep into a plate on
     * their way in a step. */
    std::string why_too_deep(unsigned int       axis,
                             unsigned int       plate,
                             const Evaluation  &step,
                             const SpaceVector &place,
                             const SpaceVector &place_before) const;

    const LatticeModel      &model;
    const ContactParameters  parameters;
    const CoulombFriction    friction;
    const double             step_length; ///< of the scene (s); 0 in statics
    const unsigned int       dimension;
    std::vector<ContactAxis> axes;
    /** Of each axis. */
    std::vector<ContactPoints> points_of_axes;
    std::vector<Plate>         plates;
    /** Of this rank: local unknowns of the axes that it counts. */
    std::vector<std::vector<int>> owned_unknowns;
    /** Of this rank: local unknowns of all displacements of struts and plates.
     */
    std::vector<int> displacements;
    /** The last search for what is near. */
    struct Search
    {
      Vector displacement; ///< m
      double clearance;    ///< least gap of any strut, on all ranks (m)
    };
    std::optional<Search> last_search;
    std::vector<Near>     near;              ///< of all ranks
    std::vector<Coupled>  coupled;           ///< of this rank
    double                thickest      = 0; ///< half thickness (m)
    std::size_t           first_block   = 0;
    unsigned int          contact_entry = 0;
    FrictionAccount       friction_account;
  };
} // namespace auxfem

#endif
