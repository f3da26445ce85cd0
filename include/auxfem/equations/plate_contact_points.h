#ifndef auxfem_equations_plate_contact_points_h
#define auxfem_equations_plate_contact_points_h

#include <auxfem/contact/surface_approach.h>
#include <auxfem/equations/strut_curves.h>

namespace auxfem
{
  /** A point of an axis that presses on a surface. */
  struct PressingPoint
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
    std::vector<PressingPoint>
    pressing(unsigned int                  axis,
             const PlateSide              &side,
             const std::vector<AxisCurve> &curves) const;

    /**
     * The parts of an axis that a plate can touch. A rigid arc's ends alone:
     * between them it does not move as they do.
     */
    std::vector<ControlPolygon> touchable(unsigned int     axis,
                                          const AxisCurve &curve) const;

  private:
    bool is_rigid_arc(unsigned int axis) const;

    const LatticeModel             &model;
    const std::vector<ContactAxis> &axes;
  };
} // namespace auxfem

#endif
