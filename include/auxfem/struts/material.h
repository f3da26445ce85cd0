#ifndef auxfem_struts_material_h
#define auxfem_struts_material_h

#include <auxfem/struts/section_law.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** A material, named in `Materials` or given within a section (SI). */
  struct MaterialDefinition
  {
    std::string name;               ///< empty if given within a section
    double      youngs_modulus = 0; ///< E (Pa), the instantaneous one
    double      shear_modulus  = 0; ///< G = E / (2 (1 + nu)) (Pa)
    /** rho (kg/m3); empty if not given. */
    std::optional<double> density;
    /** Outer-fibre strain at which the material yields; empty: not given. */
    std::optional<double> yield_strain;
    /** The time beta in stress = E (strain + beta strain rate) (s). */
    double stiffness_proportional_damping = 0;
    /** The rate alpha: damping force per mass and velocity (1/s). */
    double mass_proportional_damping = 0;
    /** Strain per temperature (1/K); empty: not given. */
    std::optional<double> thermal_expansion;
    /** Empty: linear elastic. */
    std::shared_ptr<const SectionLaw> law;
  };

  /** Parameters of the material constants, for materials and for sections. */
  Parameters material_parameters();

  /** @name Young's modulus and Poisson's ratio among material_parameters(). */
  ///@{
  const Quantity &youngs_modulus_parameter();
  const Quantity &poissons_ratio_parameter();
  ///@}

  /** Advice to users who give a law no Young's modulus. */
  inline const std::string example_of_youngs_modulus =
    "For instance set Young's modulus = 70 GPa";

  /** Young's modulus among @p values (Pa). Throws InputError without, with @p
   * remedy. */
  double read_youngs_modulus(const ParameterValues &values,
                             const std::string     &remedy);

  /** Reads material_parameters() other than @p youngs_modulus (Pa); the law is
   * left empty. */
  MaterialDefinition read_material_constants(const ParameterValues &values,
                                             double youngs_modulus);

  /** Refuses material_parameters() that are given beside @p material. */
  void refuse_material_parameters(const ParameterValues &values,
                                  const std::string     &material);

  /** `Materials`. */
  SubsectionSchema materials_schema();

  /** Reads the values of one such subsection. Throws InputError if they are
   * inconsistent. */
  MaterialDefinition read_material(ParameterValues &values);
} // namespace auxfem

#endif
