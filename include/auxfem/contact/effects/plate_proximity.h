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
  /** A quadrature point of the contact force on an axis. */
  struct ContactQuadraturePoint
  {
    double parameter;
    double weight; ///< quadrature weight (m)
  };

  /** Geometry of the contact of an axis with a plate. */
  struct PlateSide
  {
    const RigidSurface &surface;
    double              half_thickness; ///< m
    /** Depth (m) up to which the contact law is quadratic. */
    double smoothing;
  };

  /**
   * Quadrature of the contact force per length: Gauss points on the intervals
   * of an axis that penetrate the surface, split where the contact law changes,
   * and one point per end cap. The intervals follow the motion, so accuracy is
   * independent of the element length. Theory: doc/theory/contact.md.
   */
  class PlateContactPoints
  {
  public:
    /** @param model, axes must outlive the object. */
    PlateContactPoints(const LatticeModel             &model,
                       const std::vector<ContactAxis> &axes);

    /** @param curves of the axis relative to the reference point of the plate
     * (m); with two curves, intervals that penetrate in either are included */
    std::vector<ContactQuadraturePoint>
    quadrature_points(unsigned int                  axis,
                      const PlateSide              &side,
                      const std::vector<AxisCurve> &curves) const;

    /** Parts of an axis that can touch a plate. For a rigid arc only its ends,
     * because its interior does not follow the interpolated motion. */
    std::vector<ControlPolygon> touchable_parts(unsigned int     axis,
                                                const AxisCurve &curve) const;

  private:
    bool is_rigid_arc(unsigned int axis) const;

    const LatticeModel             &model;
    const std::vector<ContactAxis> &axes;
  };

  /** An axis and a plate, as indices. */
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
   * Detects contact between axes and plates and measures penetrations. Each
   * rank checks the axes it owns. Theory: doc/theory/contact.md, Detection at
   * plates.
   */
  class PlateProximity
  {
  public:
    /** A plate of the scene, and the global numbers of its displacements. */
    struct Plate
    {
      const PlateDefinition *definition;
      dealii::Point<3>       position; ///< at rest (m)
      std::vector<int>       unknowns;
    };

    /**
     * @param model, curves must outlive the object
     */
    PlateProximity(const LatticeModel &model, const StrutCurves &curves);

    /** Throws InputError for struts without thickness or inside a plate at
     * rest. */
    void refuse_bad_plates() const;

    /** Updates near() for an accepted state; returns whether it changed.
     * Collective. */
    bool follow(const State &accepted);

    /** Sorted pairs of all ranks that touch or may touch in the next step. */
    const std::vector<PlatePair> &near() const
    {
      return near_pairs;
    }

    /** As follow(), but independent of earlier states. Collective. */
    bool restart(const State &accepted);

    /** Penetration of a strut into a plate. */
    struct Depth
    {
      unsigned int strut, plate;
      double       depth; ///< m
      bool         is_near;
    };

    /** Finds a strut of this rank whose penetration is excessive on the
     * straight path of a step. Near pairs may reach the allowed penetration;
     * other pairs must not touch. Collective. */
    std::optional<Depth>
    first_excessive_penetration(const Evaluation &step) const;

    /** All plates in the order of the scene. */
    const std::vector<Plate> &plates() const
    {
      return all_plates;
    }

    /** Values at the reference points, by plate. Collective. */
    std::vector<dealii::Tensor<1, 3>> plate_values(const Vector &values) const;

    /** Half thickness (m); rigid struts without a section use that of the
     * thickest strut. */
    double thickness(const unsigned int axis) const
    {
      return axes[axis].half_thickness > 0 ? axes[axis].half_thickness
                                           : thickest;
    }

  private:
    using SpaceVector = dealii::Tensor<1, 3>;

    /** Result of the last proximity search. */
    struct Search
    {
      Vector displacement; ///< m
      double clearance;    ///< smallest gap on all ranks (m)
    };

    void refuse_struts_without_thickness() const;
    void refuse_plates_in_struts() const;

    /** Penetration of an axis into a plate at rest (m); 0 if at most
     * @p tolerance. */
    double depth_at_rest(unsigned int axis,
                         const Plate &plate,
                         double       tolerance) const;

    /** Lower bound of the gap (m) between an owned axis and the displaced
     * plate. */
    double least_gap(const PlatePair   &pair,
                     const Vector      &displacement,
                     const SpaceVector &plate_displacement) const;

    /** Largest motion of the nodes of an owned axis relative to the plate
     * (m). */
    double largest_motion(unsigned int       axis,
                          const Vector      &increment,
                          const SpaceVector &plate_displacement) const;

    /** Searches near pairs and stores the clearance. Collective. */
    std::vector<PlatePair> find_near(const State &accepted);

    /** Motion of the last or the next step (m); empty if unknown. */
    std::optional<Vector> motion_of_step(const State &accepted) const;

    /** Whether the last search guarantees that no strut is closer to a plate
     * than @p margin (m) at the displacement @p now, after further motions of
     * at most @p further (m). Collective. */
    bool are_clear(const Vector &now, double further, double margin) const;

    /** Largest displacement in @p values, or in the change from @p from, of all
     * nodes and plates of this rank. */
    double largest_displacement(const Vector &values) const;
    double largest_displacement(const Vector &values, const Vector &from) const;

    /** Gap below which a pair is near (m). */
    double least_margin() const
    {
      return 4 * thickest;
    }

    /** As first_excessive_penetration(), for a pair whose plate moves from
     * @p before to @p now. */
    std::optional<Depth> excessive_penetration(const PlatePair   &pair,
                                               const Evaluation  &step,
                                               const SpaceVector &before,
                                               const SpaceVector &now) const;

    const LatticeModel             &model;
    const StrutCurves              &curves;
    const std::vector<ContactAxis> &axes;
    const PlateContactPoints        points_of_axes;
    /** Allowed penetration of a step over half the thickness. */
    const double       allowed_part;
    const double       step_length; ///< nominal step (s); 0 in statics
    const unsigned int dimension;
    double             thickest = 0; ///< half thickness (m)
    std::vector<Plate> all_plates;
    /** Local unknowns of the axes owned by this rank, by axis. */
    std::vector<std::vector<int>> owned_unknowns;
    /** Local unknowns of all displacements of struts and plates. */
    std::vector<int>       displacements;
    std::optional<Search>  last_search;
    std::vector<PlatePair> near_pairs;
  };
} // namespace auxfem

#endif
