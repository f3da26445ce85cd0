#ifndef auxfem_struts_effects_struts_h
#define auxfem_struts_effects_struts_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>
#include <auxfem/struts/beam_shape.h>
#include <auxfem/struts/section.h>

#include <array>

namespace auxfem
{
  /** Resultants at a point: N, Q_2, Q_3 (N), T, M_2, M_3 (N m). */
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
  };

  /**
   * Strains and velocities along an element, so scaled that half the sum of the
   * squares at a point is an energy per length: strains times the square root
   * of their stiffness, (J/m)^1/2, velocities times that of the mass per
   * length. Polynomials, told by their values at Gauss points.
   */
  struct ScaledMotion
  {
    /** Of epsilon, gamma_2, gamma_3, torsion, kappa_2, kappa_3, at the Gauss
     * points of the internal forces. */
    std::vector<std::array<double, 6>> strains;
    /** Of the displacements along x, y, z, at one Gauss point more; empty
     * without inertia. */
    std::vector<std::array<double, 3>> velocities;
  };

  /** Strain that the outer fibres of a section may have. */
  struct StrainLimit
  {
    double                strain;    ///< infinite: any
    std::array<double, 2> distances; ///< of the fibres from axes 2 and 3 (m)
  };

  /** Strain of an outer fibre, axial strain and those of bending, over what is
   * allowed. */
  struct StrutStrain
  {
    double       ratio = 0;
    unsigned int strut = invalid_index;
  };

  /** Which part of the beam theory is used. */
  struct StrutModel
  {
    bool large_rotation    = true;
    bool shear_flexibility = true;
    bool damping           = false; ///< stiffness-proportional
    /** ImplicitScheme::high_frequency_damping(). */
    double high_frequency_damping = 0;
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

    /** Which elements of the numbering they are. */
    virtual const DofNumbering::Group &elements() const = 0;

    /**
     * State of element @p e of the numbering, one of elements(), at @p n_points equally spaced points
     * from its first to its second end. Section forces are those of the
     * Gauss points, interpolated.
     */
    virtual std::vector<StrutPoint>
    sample(const State &state, unsigned int e, unsigned int n_points) const = 0;

    /** Strain energy per length (J/m) of @p forces in element @p e. */
    virtual double energy_density(unsigned int         e,
                                  const SectionForces &forces) const = 0;

    /** Positions (m) of the same points under @p displacement, by local
     * unknown. */
    virtual std::vector<dealii::Point<3>> axis(const Vector &displacement,
                                               unsigned int  e,
                                               unsigned int n_points) const = 0;

    /** Motion of element @p e of the numbering at @p state. */
    virtual ScaledMotion scaled_motion(const State &state,
                                       unsigned int e) const = 0;

    /** Strain energy (J) of element @p e of the numbering, from the results of
     * an evaluation. */
    virtual double strain_energy(const EffectCache &results,
                                 unsigned int       e) const = 0;

    /** Axial force (N) in element @p e of the numbering at @p state, the mean
     * along it, without damping; positive in tension. */
    virtual double axial_force(const State &state, unsigned int e) const = 0;

    /**
     * The largest strain along the struts counted by this rank over what its
     * section may have, if it is more than @p least; else that, of no strut.
     * By the section forces of sample(), without damping.
     * @param results of the evaluation of @p state
     * @param limits by section
     */
    virtual StrutStrain largest_strain(const State                    &state,
                                       const EffectCache              &results,
                                       const std::vector<StrainLimit> &limits,
                                       double least) const = 0;
  };
} // namespace auxfem

#endif
