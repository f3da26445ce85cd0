#ifndef auxfem_struts_effects_struts_h
#define auxfem_struts_effects_struts_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>
#include <auxfem/struts/beam_shape.h>
#include <auxfem/struts/effects/group_initial_strains.h>
#include <auxfem/struts/section.h>

#include <array>

namespace auxfem
{
  /** Section forces N, Q_2, Q_3 (N), T, M_2, M_3 (N m) at a point. */
  template <class Number>
  using SectionForcesOf = std::array<Number, 6>;
  using SectionForces   = SectionForcesOf<double>;

  /** Section forces and kinematics at a point of a strut, for output. */
  struct StrutPoint
  {
    dealii::Point<3>     position;     ///< at rest (m)
    dealii::Tensor<1, 3> displacement; ///< m
    dealii::Tensor<1, 3> velocity;     ///< m/s
    /** Rotation vector since rest (rad). */
    dealii::Tensor<1, 3> rotation;
    /** Section axes 1, 2, 3 now, as columns. */
    dealii::Tensor<2, 3> axes;
    /** Axial force, positive in tension, and shear along axes 2, 3 (N). */
    dealii::Tensor<1, 3> force;
    /** Torque and bending moments about axes 2, 3 (N m). */
    dealii::Tensor<1, 3> moment;
    double               energy_density; ///< strain energy per length (J/m)
    /** Section forces of an elastic strut with the same strains, without
     * initial ones: a measure of strains. */
    SectionForces strain_forces = {};
    /** @name Of struts with a law, else zero. */
    ///@{
    double dissipated_density = 0; ///< energy lost per length so far (J/m)
    double plastic_strain     = 0; ///< SectionYielding::plastic_strain
    double utilisation        = 0; ///< SectionYielding::utilisation
    double intactness         = 1; ///< part of the forces that is left
    /** Largest normal stress of the fibres, with its sign, and von Mises stress
     * (Pa), of struts that yield. */
    double fibre_stress = 0, equivalent_stress = 0;
    ///@}
  };

  /**
   * Strains and velocities along an element for comparing runs, scaled so that
   * half the sum of squares is an energy per length (J/m). Strains are
   * multiplied by the square root of their stiffness, velocities by that of the
   * mass per length. Polynomials, given by their values at Gauss points.
   */
  struct ScaledMotion
  {
    /** Scaled epsilon, gamma_2, gamma_3, torsion, kappa_2, kappa_3 at the Gauss
     * points of the internal forces. */
    std::vector<std::array<double, 6>> strains;
    /** Scaled velocities along x, y, z at one more Gauss point; empty without
     * inertia. */
    std::vector<std::array<double, 3>> velocities;
  };

  /** Allowed outer-fibre strain of a section. */
  struct StrainLimit
  {
    double strain; ///< infinite: no limit
    /** Its outermost fibres (m). */
    std::vector<dealii::Point<2>> fibres;
  };

  /** Outer-fibre strain, axial plus bending, over the allowed strain. */
  struct StrutStrain
  {
    double       ratio = 0;
    unsigned int strut = invalid_index;
  };

  /** A strut that has broken. */
  struct BrokenStrut
  {
    unsigned int strut;
    double       time; ///< at which its limit was passed (s)
  };

  /** Terms of the beam theory to simulate. */
  struct StrutModel
  {
    bool large_rotation    = true;
    bool shear_flexibility = true;
    bool damping           = false; ///< stiffness-proportional
    /** ImplicitScheme::high_frequency_damping(). */
    double high_frequency_damping = 0;
    /** Translational and rotary. */
    bool has_inertia = false;
    /** Law of the sections; empty: linear elastic. */
    std::shared_ptr<const SectionLaw> law = nullptr;
    /** Initial strains of all struts; a strut that has one needs a law. */
    const InitialStrains *initial_strains = nullptr;
  };

  /** Internal forces of the struts of one polynomial order: geometrically exact
   * beams. */
  class StrutForces : public Effect, public StageTerms, public SmallMotionTerms
  {
  public:
    /** @param group of the elements of @p numbering. */
    static std::unique_ptr<StrutForces>
    make(const Lattice              &lattice,
         const DofNumbering         &numbering,
         const DofNumbering::Group  &group,
         const std::vector<Section> &sections,
         const StrutModel           &model);

    /** Range of the elements in the numbering. */
    virtual const DofNumbering::Group &elements() const = 0;

    /**
     * State of element @p e of the numbering, one of elements(), at @p n_points
     * equally spaced points from its first to its second end. Section forces
     * are interpolated from the Gauss points.
     */
    virtual std::vector<StrutPoint>
    sample(const State &state, unsigned int e, unsigned int n_points) const = 0;

    /** Strain energy per length (J/m) of @p forces in element @p e. */
    virtual double energy_density(unsigned int         e,
                                  const SectionForces &forces) const = 0;

    /** Positions (m) of the points of sample() under @p displacement, by local
     * unknown. */
    virtual std::vector<dealii::Point<3>> axis(const Vector &displacement,
                                               unsigned int  e,
                                               unsigned int n_points) const = 0;

    /** Scaled motion of element @p e of the numbering at @p state. */
    virtual ScaledMotion scaled_motion(const State &state,
                                       unsigned int e) const = 0;

    /** Strain energy (J) of element @p e of the numbering, from the @p results
     * of an evaluation. */
    virtual double strain_energy(const EffectCache &results,
                                 unsigned int       e) const = 0;

    /** Mean elastic axial force (N) in element @p e of the numbering at @p
     * state; positive in tension. */
    virtual double axial_force(const State &state, unsigned int e) const = 0;

    /** Adds the broken struts whose first element this rank owns. */
    virtual void add_broken_struts(const State & /*state*/,
                                   std::vector<BrokenStrut> & /*broken*/) const
    {}

    /** Largest accumulated plastic strain of a fibre, of the struts owned by
     * this rank, if above @p least; else no strut. */
    virtual StrutStrain largest_plastic_strain(const State & /*state*/,
                                               const double least) const
    {
      return {least, invalid_index};
    }

    /**
     * Largest ratio of strain to allowed strain among the struts owned by this
     * rank, if above @p least; otherwise no strut. Uses the section forces of
     * sample(), without damping.
     * @param results cache of the evaluation of @p state
     * @param limits by section
     */
    virtual StrutStrain largest_strain(const State                    &state,
                                       const EffectCache              &results,
                                       const std::vector<StrainLimit> &limits,
                                       double least) const = 0;
  };
} // namespace auxfem

#endif
