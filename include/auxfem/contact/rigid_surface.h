#ifndef auxfem_contact_rigid_surface_h
#define auxfem_contact_rigid_surface_h

#include <auxfem/contact/axis_curve.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>
#include <vector>

namespace auxfem
{
  /** Signed distance of a point from a surface, with derivatives. */
  struct SurfaceDistance
  {
    /** Signed distance (m), negative inside the body. */
    double distance;
    /** Gradient of the distance: outward unit normal. */
    dealii::Tensor<1, 3> normal;
    /** Hessian of the distance (1/m). */
    dealii::Tensor<2, 3> curvature;
  };

  /** Discrete gradient of the distance between two positions of the point. */
  struct MeanDistance
  {
    /** Its product with the displacement equals the change of the distance. */
    dealii::Tensor<1, 3> direction;
    /** Derivative of the direction with respect to the second position
     * (1/m). */
    dealii::Tensor<2, 3> change;
  };

  /**
   * Surface of a rigid, non-rotating body. Positions are relative to the
   * reference point of the body (m). Pure geometry.
   */
  class RigidSurface
  {
  public:
    using Vector = dealii::Tensor<1, 3>;

    virtual ~RigidSurface() = default;

    /** SurfaceDistance::distance (m); Lipschitz constant 1. */
    virtual double distance(const Vector &position) const = 0;

    virtual SurfaceDistance at(const Vector &position) const = 0;

    virtual MeanDistance between(const Vector &from,
                                 const Vector &to) const = 0;

    /**
     * Symmetric bilinear form L(one, other) of two curves of equal degree, as a
     * polynomial of their parameter. L(curve, curve) is negative exactly where
     * the curve is closer to the surface than @p distance (m). On the straight
     * path (1 - t) from + t to it is (1 - t)^2 L(from, from) + 2 t (1 - t)
     * L(from, to) + t^2 L(to, to). Coefficients at round-off level are set to
     * zero.
     */
    virtual BernsteinPolynomial level(const ControlPolygon &one,
                                      const ControlPolygon &other,
                                      double                distance) const = 0;

    /** Polylines that draw the body (m), relative to the reference point.
     * @param size drawn extent of unbounded surfaces (m)
     * @param dimension of space */
    virtual std::vector<std::vector<Vector>>
    outline(double size, unsigned int dimension) const = 0;
  };

  /** @name Surfaces */
  ///@{
  /**
   * Half space behind a plane through the reference point.
   * @param normal outward unit vector
   */
  std::shared_ptr<const RigidSurface>
  make_plane_surface(const dealii::Tensor<1, 3> &normal);

  /**
   * Ball about the reference point; a disc in the plane.
   * @param radius m
   */
  std::shared_ptr<const RigidSurface> make_sphere_surface(double radius);

  /**
   * Infinite cylinder whose axis passes through the reference point.
   * @param axis unit vector
   * @param radius m
   */
  std::shared_ptr<const RigidSurface>
  make_cylinder_surface(const dealii::Tensor<1, 3> &axis, double radius);
  ///@}

  /** A parameter of a moving curve and the fraction of its path. */
  struct CurvePassage
  {
    double parameter, path_fraction;
  };

  /**
   * Sorted parameters from 0 to 1 that split a curve where its distance from a
   * surface crosses one of @p levels (m).
   * @param curves of equal degree; the crossings of all are merged
   */
  std::vector<double>
  parameters_between_levels(const RigidSurface                &surface,
                            const std::vector<ControlPolygon> &curves,
                            const std::vector<double>         &levels);

  /**
   * Finds where a curve gets closer to a surface than @p distance (m) on the
   * straight path from @p from to @p to. Bounded subdivision of polynomials
   * also finds arbitrarily short passages.
   * @param from, to of equal degree
   */
  std::optional<CurvePassage> find_passage(const RigidSurface   &surface,
                                           const ControlPolygon &from,
                                           const ControlPolygon &to,
                                           double                distance);
} // namespace auxfem

#endif
