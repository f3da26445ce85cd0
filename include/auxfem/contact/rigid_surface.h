#ifndef auxfem_contact_rigid_surface_h
#define auxfem_contact_rigid_surface_h

#include <auxfem/contact/axis_curve.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>
#include <vector>

namespace auxfem
{
  /** Where a point lies to a surface. */
  struct SurfaceDistance
  {
    /** m, negative inside the body behind the surface. */
    double distance;
    /** Its gradient by the point: unit normal, out of the body. */
    dealii::Tensor<1, 3> normal;
    /** Its second derivative (1/m). */
    dealii::Tensor<2, 3> curvature;
  };

  /** The same in a step between two positions of the point. */
  struct MeanDistance
  {
    /** The product with the motion is the change of the distance. */
    dealii::Tensor<1, 3> direction;
    /** Derivative of the direction by the second position (1/m). */
    dealii::Tensor<2, 3> change;
  };

  /**
   * The surface of a rigid body that does not turn. Positions are relative to a
   * point of reference of the body (m). Pure geometry.
   */
  class RigidSurface
  {
  public:
    using Vector = dealii::Tensor<1, 3>;

    virtual ~RigidSurface() = default;

    /** m, as SurfaceDistance::distance; changes by at most the length of a
     * motion. */
    virtual double distance(const Vector &position) const = 0;

    virtual SurfaceDistance at(const Vector &position) const = 0;

    virtual MeanDistance between(const Vector &from,
                                 const Vector &to) const = 0;

    /**
     * The symmetric bilinear form L(one, other) of two curves of one degree, by
     * their parameter. L(curve, curve) is negative where, and only where, the
     * curve is nearer to the surface than @p distance (m). On the straight way
     * (1 - t) from + t to this is
     * (1 - t)^2 L(from, from) + 2 t (1 - t) L(from, to) + t^2 L(to, to).
     * Coefficients that are round-off are zero.
     */
    virtual BernsteinPolynomial level(const ControlPolygon &one,
                                      const ControlPolygon &other,
                                      double                distance) const = 0;

    /**
     * Lines that show the body (m), each through points: relative to the point
     * of reference.
     * @param size what extends without end is shown as far as this (m)
     * @param dimension of space
     */
    virtual std::vector<std::vector<Vector>>
    outline(double size, unsigned int dimension) const = 0;
  };

  /** @name Surfaces */
  ///@{
  /** Everything behind a plane through the point of reference.
   * @param normal unit vector out of the body */
  std::shared_ptr<const RigidSurface>
  make_plane_surface(const dealii::Tensor<1, 3> &normal);

  /** A ball about the point of reference, in the plane a disc.
   * @param radius m */
  std::shared_ptr<const RigidSurface> make_sphere_surface(double radius);

  /** A cylinder without ends, its axis through the point of reference.
   * @param axis unit vector
   * @param radius m */
  std::shared_ptr<const RigidSurface>
  make_cylinder_surface(const dealii::Tensor<1, 3> &axis, double radius);
  ///@}

  /** A parameter of a curve, and a part of its way from one place to another.
   */
  struct CurvePassage
  {
    double parameter, path_fraction;
  };

  /** Sorted parameters from 0 to 1 between which the distances of a curve from
   * a
   * surface lie on one side of each of @p levels (m).
   * @param curves of one degree; all of them count */
  std::vector<double>
  parameters_between_levels(const RigidSurface                &surface,
                            const std::vector<ControlPolygon> &curves,
                            const std::vector<double>         &levels);

  /** Where a curve comes nearer to a surface than @p distance (m) on the
   * straight way from @p from to @p to, if anywhere; subdivision of polynomials
   * with bounds finds it, however short it is.
   * @param from, to of one degree */
  std::optional<CurvePassage> find_passage(const RigidSurface   &surface,
                                           const ControlPolygon &from,
                                           const ControlPolygon &to,
                                           double                distance);
} // namespace auxfem

#endif
