#ifndef auxfem_rigid_rigid_part_h
#define auxfem_rigid_rigid_part_h

#include <auxfem/parameters/subsection_schema.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <optional>
#include <string>

/**
 * @file
 * Rigid bodies in the plane and bars in space in natural coordinates (Garcia de
 * Jalon & Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994,
 * chapter 2). The unknowns are positions of points of the body, here r0 and r1
 * of its base. With d = r1 - r0 and J the rotation by a right angle, every
 * other point is
 * @code
 * r = r0 + a d + b J d
 * @endcode
 * with constants a, b; the body is rigid if |d| is constant. The mass matrix is
 * constant and no unknown is a rotation. In space the same holds with b = 0 for
 * points on the base line.
 */
namespace auxfem
{
  using PlaneVector = dealii::Tensor<1, 2>;

  /** Rotates @p v by a right angle, counterclockwise. */
  inline PlaneVector perpendicular(const PlaneVector &v)
  {
    PlaneVector result;
    result[0] = -v[1];
    result[1] = v[0];
    return result;
  }

  /** Position of a point of a body relative to its base: r = r0 + a d + b J d.
   */
  struct NaturalPosition
  {
    double a, b;
  };

  /** The first @p dim components of @p v. */
  template <int dim>
  dealii::Tensor<1, dim> in_dimension(const dealii::Tensor<1, 3> &v)
  {
    dealii::Tensor<1, dim> result;
    for (int c = 0; c < dim; ++c)
      result[c] = v[c];
    return result;
  }

  /**
   * Natural position of @p point in a body with distinct base points @p r0 and
   * @p r1 (m); in space, of its projection on the base line.
   */
  template <int dim>
  NaturalPosition natural_position(const dealii::Point<3> &r0,
                                   const dealii::Point<3> &r1,
                                   const dealii::Point<3> &point);

  /** Derivatives of component @p component of a point by r0_x, r0_y, ..., r1_x,
   * r1_y, ...: the shares of a force on the point for the base unknowns. */
  template <int dim>
  std::array<double, 2 * dim> shape(const NaturalPosition &position,
                                    unsigned int           component);

  /**
   * Consistent mass matrix of a body on its base unknowns r0_x, r0_y, ...,
   * r1_x, r1_y, ..., row by row (kg). For a uniform bar it is m/3 and m/6.
   * @param rotary_inertia about the centre of mass (kg m2), for a bar in space
   *   about transverse axes
   * @param length length of the base (m)
   * @param centre natural position of the centre of mass
   */
  template <int dim>
  std::array<double, 4 * dim * dim>
  rigid_mass_matrix(double                 mass,
                    double                 rotary_inertia,
                    double                 length,
                    const NaturalPosition &centre);

  /** The constraint |r1 - r0| = L as g = (|d|^2 - L^2) / (2 L) = 0 (m); its
   * multiplier is the force (N) along the base. */
  template <int dim>
  struct DistanceConstraint
  {
    dealii::Tensor<1, dim> rest; ///< d at rest
    double                 length;

    /** g, from the relative displacement @p stretch = u1 - u0 of the base. */
    double value(const dealii::Tensor<1, dim> &stretch) const
    {
      // This form avoids the cancellation of |d|^2 - L^2.
      return (rest * stretch + 0.5 * (stretch * stretch)) / length;
    }

    /** dg / du1 = -dg / du0. */
    dealii::Tensor<1, dim> gradient(const dealii::Tensor<1, dim> &stretch) const
    {
      return (rest + stretch) / length;
    }

    /** d2g / du1^2 is this times the identity; the mixed one is its negative.
     */
    double curvature() const
    {
      return 1 / length;
    }
  };

  /**
   * Constraint that a section rotates with the body, in the plane: g = e(phi) .
   * d = 0 (m). e(phi) is the unit normal of the base at rest, rotated by the
   * section rotation phi, so g = L sin(angle of the base - phi).
   */
  struct ClampConstraint
  {
    PlaneVector rest; ///< d at rest
    double      length;

    /** e(phi). */
    PlaneVector normal(double rotation) const;

    /** de / dphi; the next derivative is -e. */
    PlaneVector normal_derivative(double rotation) const
    {
      return perpendicular(normal(rotation));
    }
  };

  /** `Rigid parts/NAME`: struts or joints that move as rigid bodies. */
  struct RigidPartDefinition
  {
    std::string name;
    /** Strut set; empty if the part is made of joints. */
    std::string struts;
    /** Joint set of one part; empty if parts are made of struts. */
    std::string joints;
    /** True: every strut is a separate part; false: connected struts form one
     * part. */
    bool   single_struts = false;
    double mass          = 0; ///< of each part (kg)
    /**
     * Rotary inertia about x, y, z axes at rest through the centre of mass (kg
     * m2), in the plane only the last; empty: from the uniform mass
     * distribution.
     */
    std::optional<dealii::Tensor<1, 3>> rotary_inertia;
    /** Whether elastic struts at its joints are clamped to it, not hinged. */
    bool        clamps_struts = false;
    std::string path;
  };

  /** `Rigid parts`. */
  SubsectionSchema rigid_parts_schema();

  /** Reads the values of one such subsection. Throws InputError if they are
   * inconsistent. */
  RigidPartDefinition read_rigid_part(ParameterValues &values);
} // namespace auxfem

#endif
