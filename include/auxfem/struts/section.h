#ifndef auxfem_struts_section_h
#define auxfem_struts_section_h

#include <auxfem/mathematics/rotation.h>
#include <auxfem/struts/grading.h>
#include <auxfem/struts/material.h>
#include <auxfem/struts/shapes/cross_section.h>
#include <auxfem/struts/taper.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace auxfem
{
  /**
   * Cross-section and material of a strut, reduced to beam stiffnesses (SI).
   * Axis 1 is along the strut; axes 2 and 3 are principal axes of the section.
   * In the plane, axis 2 lies in it and axis 3 is its normal.
   */
  struct Section : CrossSection
  {
    double youngs_modulus = 0; ///< E (Pa), the instantaneous one
    double shear_modulus  = 0; ///< G = E / (2 (1 + nu)) (Pa)
    double density        = 0; ///< rho (kg/m3)
    /** Vector whose projection normal to the strut gives the drawn axis 3;
     * empty: default_reference(). */
    std::optional<dealii::Tensor<1, 3>> reference;
    /** Outer-fibre strain at which the material yields; empty: not given. */
    std::optional<double> yield_strain;
    /** The time beta in stress = E (strain + beta strain rate) (s). */
    double stiffness_proportional_damping = 0;
    /** The rate alpha: damping force per mass and velocity (1/s). */
    double mass_proportional_damping = 0;
    /** Strain per temperature (1/K); empty: not given. */
    std::optional<double> thermal_expansion;
    /** Law of the material; empty: linear elastic. */
    std::shared_ptr<const SectionLaw> law;
    /** Variation along the strut, whose constants are then those of its middle;
     * empty: none. */
    std::shared_ptr<const Taper> taper;

    /** The section at the part @p s, from 0 to 1, of the strut. */
    Section at(const double s) const
    {
      Section section = *this;
      if (taper)
        static_cast<CrossSection &>(section) = taper->shape_at(s);
      return section;
    }

    /** Whether the material yields. */
    bool yields() const
    {
      return law && law->yields();
    }

    /** This section after complete relaxation, linear elastic. */
    Section relaxed() const
    {
      Section section = *this;
      if (law)
        {
          section.youngs_modulus *= law->long_time_ratio(StrainType::normal);
          section.shear_modulus *= law->long_time_ratio(StrainType::shear);
          section.law = nullptr;
        }
      return section;
    }

    /** Directions of axes 2 and 3. */
    SectionOrientation orientation() const
    {
      return {reference, principal_angle};
    }

    /** EA (N). */
    double axial_stiffness() const
    {
      return youngs_modulus * area;
    }
    /** k G A along axis 2 (N). */
    double shear_stiffness_2() const
    {
      return shear_modulus * shear_area_2;
    }
    /** k G A along axis 3 (N). */
    double shear_stiffness_3() const
    {
      return shear_modulus * shear_area_3;
    }
    /** G J (N m2). */
    double torsion_stiffness() const
    {
      return shear_modulus * torsion_constant;
    }
    /** EI about axis 2 (N m2). */
    double bending_stiffness_2() const
    {
      return youngs_modulus * second_moment_2;
    }
    /** EI about axis 3 (N m2). */
    double bending_stiffness_3() const
    {
      return youngs_modulus * second_moment_3;
    }
    /** Radii of gyration about axes 2 and 3 (m), lower bounds of the fibre
     * distances of any section. */
    std::array<double, 2> radii_of_gyration() const
    {
      return {
        {std::sqrt(second_moment_2 / area), std::sqrt(second_moment_3 / area)}};
    }
    /** rho A (kg/m). */
    double mass_per_length() const
    {
      return density * area;
    }
    /** Rotary inertia per length about axes 1, 2, 3 (kg m). */
    std::array<double, 3> rotary_inertia_per_length() const
    {
      if (given_rotary_inertia)
        return *given_rotary_inertia;
      return {{density * (second_moment_2 + second_moment_3),
               density * second_moment_2,
               density * second_moment_3}};
    }
  };

  /** `Sections/NAME`: cross-section and material of a set of struts. */
  struct SectionDefinition
  {
    std::string name;
    std::string struts; ///< strut set
    Section     section;
    std::string path;
    /** Path of the material's parameters: this section or `Materials/NAME`. */
    std::string material_path;
    /** False if the scene gives no density, allowed only without inertia and
     * weight. */
    bool has_density = true;
    /** Number of the subsection in the file, for output. */
    unsigned int number = 0;
    /** Variation from strut to strut; empty: none. */
    std::shared_ptr<Grading> grading;
    /** The only struts with this section, one of several made by a grading;
     * empty: all of `struts` that no later section has. */
    std::vector<unsigned int> graded_struts;
  };

  /** Whether a section has a material that yields. */
  bool yields(const std::vector<SectionDefinition> &sections);

  /** Whether a section varies along its struts. */
  bool have_tapers(const std::vector<SectionDefinition> &sections);

  /** `Sections`. */
  SubsectionSchema sections_schema();

  /** Parameter `Base` of sections: the section that gives the values not
   * given. */
  const Parameter &base_section_parameter();

  /**
   * Reads the values of one such subsection. Throws InputError if they are
   * inconsistent or name none of the @p materials.
   * @param others sections before, whose laws serve equal ones
   */
  SectionDefinition
  read_section(ParameterValues                       &values,
               const std::vector<MaterialDefinition> &materials,
               const std::vector<SectionDefinition>  &others);
} // namespace auxfem

#endif
