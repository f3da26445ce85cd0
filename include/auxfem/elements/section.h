#ifndef auxfem_elements_section_h
#define auxfem_elements_section_h

namespace auxfem
{
  /**
   * Cross-section and material of a strut, reduced to what the planar beam
   * needs (SI).
   */
  struct Section
  {
    double youngs_modulus = 0; ///< E (Pa)
    double shear_modulus  = 0; ///< G = E / (2 (1 + nu)) (Pa)
    double density        = 0; ///< rho (kg/m3)
    double area           = 0; ///< A (m2)
    /** Shear area k A, shear correction included (m2). */
    double shear_area = 0;
    /** I about the axis normal to the plane (m4). */
    double second_moment = 0;
    /** Radius of the tube drawn in ParaView (m). */
    double radius = 0;
    /** The time beta in stress = E (strain + beta strain rate) (s). */
    double stiffness_proportional_damping = 0;
    /** The rate alpha: damping force per mass and velocity (1/s). */
    double mass_proportional_damping = 0;

    /** EA (N). */
    double axial_stiffness() const
    {
      return youngs_modulus * area;
    }
    /** k G A (N). */
    double shear_stiffness() const
    {
      return shear_modulus * shear_area;
    }
    /** EI (N m2). */
    double bending_stiffness() const
    {
      return youngs_modulus * second_moment;
    }
    /** rho A (kg/m). */
    double mass_per_length() const
    {
      return density * area;
    }
    /** rho I (kg m). */
    double rotary_inertia_per_length() const
    {
      return density * second_moment;
    }
  };
} // namespace auxfem

#endif
