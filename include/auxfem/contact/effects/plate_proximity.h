#ifndef auxfem_contact_effects_plate_proximity_h
#define auxfem_contact_effects_plate_proximity_h

#include <auxfem/contact/effects/strut_curves.h>
#include <auxfem/contact/plate_definition.h>
#include <auxfem/contact/rigid_surface.h>
#include <auxfem/equations/evaluation.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/state/state.h>

#include <optional>

namespace auxfem
{
  /** A point of an axis that presses on a surface. */
  struct ContactQuadraturePoint
  {
    double parameter;
    double weight; ///< length that it stands for (m)
  };

  /** How an axis lies to a plate. */
  struct PlateSide
  {
    const RigidSurface &surface;
    double              half_thickness; ///< m
    /** Depth (m) up to which the law of contact is a parabola. */
    double smoothing;
  };

  /**
   * The points at which the force of contact per length is integrated: Gauss
   * points of each part of the axis that is nearer to the surface than half its
   * thickness, divided where the law of contact changes, and the caps at the
   * ends of struts. So the parts move with the motion, and the sum is the
   * integral whatever the length of elements. Theory: doc/theory.md, Contact.
   */
  class PlateContactPoints
  {
  public:
    /** @param model, axes must outlive the object. */
    PlateContactPoints(const LatticeModel             &model,
                       const std::vector<ContactAxis> &axes);

    /** @param curves of the axis from the point of reference of the plate (m);
     * of two, points that press in either count */
    std::vector<ContactQuadraturePoint>
    quadrature_points(unsigned int                  axis,
                      const PlateSide              &side,
                      const std::vector<AxisCurve> &curves) const;

    /**
     * The parts of an axis that a plate can touch. A rigid arc's ends alone:
     * between them it does not move as they do.
     */
    std::vector<ControlPolygon> touchable_parts(unsigned int     axis,
                                                const AxisCurve &curve) const;

  private:
    bool is_rigid_arc(unsigned int axis) const;

    const LatticeModel             &model;
    const std::vector<ContactAxis> &axes;
  };

  /** An axis and a plate. */
  struct PlatePair
  {
    unsigned int axis, plate;

    bool operator<(const PlatePair &other) const
    {
      return std::pair(axis, plate) < std::pair(other.axis, other.plate);
    }

    bool operator==(const PlatePair &other) const
    {
      return axis == other.axis && plate == other.plate;
    }
  };

  /**
   * Which axes come near which plates, and how deep they go into them. Each
   * rank looks at the axes that it counts. Theory: doc/theory.md, Contact, What
   * is near.
   */
  class PlateProximity
  {
  public:
    /** A plate of the scene, and the global numbers of its displacements. */
    struct Plate
    {
      const PlateDefinition *definition;
      std::vector<int>       unknowns;
    };

    /**
     * @param model, curves must outlive the object
     */
    PlateProximity(const LatticeModel &model, const StrutCurves &curves);

    /** Throws InputError for struts without thickness, and for such as lie in a
     * plate at rest. */
    void refuse_bad_plates() const;

    /** Follows an accepted state; whether near() has changed. Collective. */
    bool follow(const State &accepted);

    /** Pairs that touch or may do so in the next step, of all ranks, sorted. */
    const std::vector<PlatePair> &near() const
    {
      return near_pairs;
    }

    /** Follows an accepted state as if nothing were known of those before;
     * whether near() has changed. Collective. */
    bool restart(const State &accepted);

    /** A strut that goes into a plate. */
    struct Depth
    {
      unsigned int strut, plate;
      double       depth; ///< m
      bool         is_near;
    };

    /** A strut of this rank that goes too deep into a plate on the straight way
     * between the states of a step: one that is near() deeper than it may,
     * another that touches it. Collective. */
    std::optional<Depth>
    first_excessive_penetration(const Evaluation &step) const;

    /** All, in the order of the scene. */
    const std::vector<Plate> &plates() const
    {
      return all_plates;
    }

    /** By plate, of the plates' points of reference. Collective. */
    std::vector<dealii::Tensor<1, 3>> plate_values(const Vector &values) const;

    /** Half of it (m), of a rigid strut without a section that of the thickest
     * one. */
    double thickness(const unsigned int axis) const
    {
      return axes[axis].half_thickness > 0 ? axes[axis].half_thickness
                                           : thickest;
    }

  private:
    using SpaceVector = dealii::Tensor<1, 3>;

    /** The last search for what is near. */
    struct Search
    {
      Vector displacement; ///< m
      double clearance;    ///< least gap of any strut, on all ranks (m)
    };

    void refuse_struts_without_thickness() const;
    void refuse_plates_in_struts() const;

    /** How deep an axis reaches into a plate at rest (m), if deeper than
     * @p tolerance; else 0. */
    double depth_at_rest(unsigned int           axis,
                         const PlateDefinition &plate,
                         double                 tolerance) const;

    /** Gap (m) that an owned axis has at least; the plate is displaced. */
    double least_gap(const PlatePair   &pair,
                     const Vector      &displacement,
                     const SpaceVector &plate_displacement) const;

    /** Of the nodes of an owned axis against the plate (m). */
    double largest_motion(unsigned int       axis,
                          const Vector      &increment,
                          const SpaceVector &plate_displacement) const;

    /** Also keeps how far all others are from all plates. Collective. */
    std::vector<PlatePair> find_near(const State &accepted);

    /** Motion of the last or the next step (m); empty if not known. */
    std::optional<Vector> motion_of_step(const State &accepted) const;

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

    /** As first_excessive_penetration(), of a pair whose plate has gone from
     * one place to another. */
    std::optional<Depth> excessive_penetration(const PlatePair   &pair,
                                               const Evaluation  &step,
                                               const SpaceVector &before,
                                               const SpaceVector &now) const;

    const LatticeModel             &model;
    const StrutCurves              &curves;
    const std::vector<ContactAxis> &axes;
    const PlateContactPoints        points_of_axes;
    /** Part of half the thickness that a step may go deep. */
    const double       allowed_part;
    const double       step_length; ///< of the scene (s); 0 in statics
    const unsigned int dimension;
    double             thickest = 0; ///< half thickness (m)
    std::vector<Plate> all_plates;
    /** Of this rank: local unknowns of the axes that it counts. */
    std::vector<std::vector<int>> owned_unknowns;
    /** Of this rank: local unknowns of all displacements of struts and plates.
     */
    std::vector<int>       displacements;
    std::optional<Search>  last_search;
    std::vector<PlatePair> near_pairs;
  };
} // namespace auxfem

#endif
