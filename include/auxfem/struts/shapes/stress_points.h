#ifndef auxfem_struts_shapes_stress_points_h
#define auxfem_struts_shapes_stress_points_h

#include <array>
#include <functional>
#include <vector>

namespace auxfem
{
  /**
   * A point of a section, and the shear stresses there along axes 2 and 3 by
   * unit section forces, as in elastic bodies at Poisson's ratio 0 (see
   * solve_saint_venant()).
   */
  struct StressPoint
  {
    using Shear = std::array<double, 2>;

    double y, z;            ///< along axes 2 and 3 from the axis (m)
    Shear  by_shear_2 = {}; ///< by a force along axis 2 (1/m2)
    Shear  by_shear_3 = {}; ///< by a force along axis 3 (1/m2)
    Shear  by_torque  = {}; ///< 1/m3
  };

  /** Points of a section at which stresses are looked for. */
  struct StressPoints
  {
    std::vector<StressPoint> points;
    /** Whether the section is the same about every transverse axis, so that
     * points may be turned into the plane of bending. */
    bool is_axisymmetric = false;
  };

  /** Computes the points of a section in the plane (2) or in space (3); some
   * take a while. */
  using StressPointsMaker = std::function<StressPoints(unsigned int dimension)>;

  /** @name Points of shapes with closed solutions (S. P. Timoshenko & J. N.
   * Goodier, Theory of Elasticity, chapters 10 and 11); sides and diameters in
   * m, @p height along axis 2. */
  ///@{
  StressPoints
  rectangle_stress_points(double height, double width, unsigned int dimension);
  StressPoints tube_stress_points(double outer_radius, double inner_radius);
  StressPoints ellipse_stress_points(double height, double width);
  ///@}

  /** Shear stresses of a rectangle by a unit twist per length and unit shear
   * modulus, at @p y, @p z from its centre: Saint-Venant's series. */
  StressPoint::Shear
  twist_of_rectangle(double y, double z, double height, double width);
} // namespace auxfem

#endif
