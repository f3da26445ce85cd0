#ifndef auxfem_struts_shapes_saint_venant_h
#define auxfem_struts_shapes_saint_venant_h

#include <auxfem/struts/shapes/stress_points.h>
#include <auxfem/struts/shapes/triangulation.h>

#include <array>
#include <vector>

namespace auxfem
{
  /** Constants from Saint-Venant's problems of a section. */
  struct SaintVenantConstants
  {
    double torsion_constant; ///< J (m4)
    /** Shear areas along axes 2 and 3 (m2). */
    std::array<double, 2> shear_areas;
    /** Stresses at corners, middles of sides and inside. Re-entrant corners are
     * left out: there the stress has no bound. */
    std::vector<StressPoint> stress_points;
  };

  /**
   * Solves torsion, and shear along both principal axes, by finite elements.
   *
   * With the warping function w, J is the least integral of
   * (w,y - z)^2 + (w,z + y)^2. A unit force along axis 2 has the shear stress
   * grad f, with Laplace f = -y / I_3 and no normal derivative; the shear area
   * has equal energy: 1 / integral of (grad f)^2. This is exact at Poisson's
   * ratio 0 (Pilkey, Analysis and Design of Elastic Beams, 2002, chapters 5 and
   * 6). Both are approached from above, to about 1e-4.
   *
   * @param section in its principal axes
   */
  SaintVenantConstants solve_saint_venant(const TriangulatedSection &section);
} // namespace auxfem

#endif
