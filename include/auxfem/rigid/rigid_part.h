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
 * Rigid bodies in the plane, and bars in space, in natural coordinates (Garcia
 * de Jalon & Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994,
 * chapter 2): the unknowns are the positions of points of the body, here r0 and
 * r1 of its base. With d = r1 - r0 and J the rotation by a right angle, every
 * other point of the body is
 * @code
 * r = r0 + a d + b J d
 * @endcode
 * with constants a, b, and the body is rigid if |d| keeps its length. There is
 * no rotation among the unknowns, the mass matrix is constant. In space the
 * same holds without b for points on the line of the base.
 */
namespace auxfem
{
  using PlaneVector = dealii::Tensor<1, 2>;

  /** @p v turned by a right angle, counterclockwise. */
  inline PlaneVector turned(const PlaneVector &v)
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
   * Natural position of @p point in a body with base points @p r0 and @p r1 (m,
   * not equal); in space of its projection on their line.
   */
  template <int dim>
  NaturalPosition natural_position(const dealii::Point<3> &r0,
                                   const dealii::Point<3> &r1,
                                   const dealii::Point<3> &point);

  /**
   * Derivatives of component @p component of a point with respect to r0_x,
   * r0_y, ..., r1_x, r1_y, ...: the shares of a force on the point that the
   * base unknowns get.
   */
  template <int dim>
  std::array<double, 2 * dim> shape(const NaturalPosition &position,
                                    unsigned int           component);

  /**
   * The consistent mass matrix of a body on its base unknowns r0_x, r0_y, ...,
   * r1_x, r1_y, ..., row by row (kg). For an even bar it is m/3 and m/6.
   * @param rotary_inertia about the centre of mass (kg m2), of a bar in space
   *   about the axes across it.
   * @param length of the base (m).
   * @param centre natural position of the centre of mass.
   */
  template <int dim>
  std::array<double, 4 * dim * dim>
  rigid_mass_matrix(double                 mass,
                    double                 rotary_inertia,
                    double                 length,
                    const NaturalPosition &centre);

  /**
   * The constraint |r1 - r0| = L as g = (|d|^2 - L^2) / (2 L) = 0 (m), so that
   * its multiplier is the force (N) along the base.
   */
  template <int dim>
  struct DistanceConstraint
  {
    dealii::Tensor<1, dim> rest; ///< d at rest
    double                 length;

    /** g, from the relative displacement @p stretch = u1 - u0 of the base. */
    double value(const dealii::Tensor<1, dim> &stretch) const
    {
      // Free of the cancellation that |d|^2 - L^2 would have.
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
   * In the plane: the constraint that a section turns with the body, as g =
   * e(phi) . d = 0 (m) with e(phi) the unit normal of the base at rest turned
   * by the section's rotation phi: g = L sin(angle of the base - phi).
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
      return turned(normal(rotation));
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
    /** True: every strut is a part of its own; false: struts that meet are one.
     */
    bool   single_struts = false;
    double mass          = 0; ///< of each part (kg)
    /**
     * About axes through the centre of mass along x, y, z at rest (kg m2), in
     * the plane the last alone; empty: from the even spread of mass.
     */
    std::optional<dealii::Tensor<1, 3>> rotary_inertia;
    /** Whether elastic struts at its joints are clamped to it, not hinged. */
    bool        clamps_struts = false;
    std::string path;
  };

  /** `Rigid parts`. */
  SubsectionSchema rigid_parts_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  RigidPartDefinition read_rigid_part(ParameterValues &values);
} // namespace auxfem

#endif
