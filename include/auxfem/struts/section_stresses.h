#ifndef auxfem_struts_section_stresses_h
#define auxfem_struts_section_stresses_h

#include <auxfem/struts/section.h>

#include <array>
#include <vector>

namespace auxfem
{
  /** Stresses at the points of a section where each is largest in magnitude
   * (Pa). */
  struct Stresses
  {
    double axial   = 0; ///< N / A, positive in tension
    double bending = 0; ///< >= 0, of both moments together
    double fibre   = 0; ///< axial and bending, with the sign of the largest
    double shear   = 0; ///< >= 0, of both shear forces together
    double torsion = 0; ///< >= 0
    /** Equivalent stress of von Mises, largest over the section. */
    double von_mises = 0;
  };

  /**
   * Stresses of an elastic section by its forces. Sections that are given by
   * their constants have no shape: their bending, shear and torsion stresses
   * are NaN, and so are fibre stress and von Mises' unless the axial force
   * alone acts.
   */
  class SectionStresses
  {
  public:
    /** @param dimension 2: bending in the plane alone; 3 */
    SectionStresses(const CrossSection &section, unsigned int dimension);

    /** Whether the shape is known. */
    bool has_shape() const
    {
      return !stress_points.points.empty();
    }

    /** @param forces N, Q_2, Q_3 (N), T, M_2, M_3 (N m) */
    Stresses at(std::array<double, 6> forces) const;

    /** Largest fibre strain, with its sign, of strains that the elastic forces
     * @p forces would have at @p youngs_modulus (Pa). */
    double fibre_strain(const std::array<double, 6> &forces,
                        double                       youngs_modulus) const
    {
      return at(forces).fibre / youngs_modulus;
    }

  private:
    double       area, second_moment_2, second_moment_3;
    StressPoints stress_points;
  };
} // namespace auxfem

#endif
