#ifndef auxfem_struts_section_law_h
#define auxfem_struts_section_law_h

#include <auxfem/mathematics/lanes.h>
#include <auxfem/parameters/registry.h>

#include <map>
#include <memory>

namespace auxfem
{
  /** Whether a strain of a beam changes the length of fibres or shears them. */
  enum class StrainType
  {
    normal, ///< axial strain and curvatures, governed by Young's modulus
    shear   ///< shear strains and torsion, governed by the shear modulus
  };

  /** Largest number of strains at a point: in space epsilon, gamma_2, gamma_3,
   * torsion, kappa_2, kappa_3; in the plane epsilon, gamma, kappa. */
  constexpr unsigned int max_section_strains = 6;

  /** A Gauss point of several elements, the input of a law (SI). */
  struct SectionPoint
  {
    unsigned int      n_strains; ///< 3 in the plane, 6 in space
    const StrainType *types;     ///< by strain
    /** Instantaneous stiffness by strain: EA, kGA (N), GJ, EI (N m2). */
    const Lanes *stiffness;
  };

  /** Section forces at a Gauss point, by strain (N, N m). */
  struct SectionResponse
  {
    Lanes forces[max_section_strains];
    /** Derivative of each force by its strain. */
    Lanes tangent[max_section_strains];
    /** Energy stored per length (J/m). */
    Lanes stored;
  };

  /** Section forces at an instant, without history. */
  struct SectionInstant
  {
    /** Forces (N, N m) and the part of them that relaxes. */
    Lanes forces[max_section_strains], relaxing[max_section_strains];
    /** Energy stored per length, and the part of it that relaxes (J/m). */
    Lanes stored, relaxing_stored;
    /** Power lost per length (W/m), >= 0. */
    Lanes lost_power;
  };

  /** Kind and length of a step of a law. */
  struct SectionStep
  {
    enum class Kind
    {
      /** Forces at the end. */
      end,
      /** Stage of a Runge-Kutta step: Euler's backward rule from its base. */
      stage,
      /** Forces after complete relaxation. */
      relaxed,
      /** Equilibrium at the start of a run: relaxed or, if the material says
       * so, loaded just now. */
      start,
      /** Mean forces, which do the work of the stored and the lost energy;
       * tangents are doubled. */
      mean
    };

    Kind   kind;
    double dt; ///< length (s), 0 if no time passes
  };

  /**
   * A law over steps of one kind and length. Holds coefficients that all Gauss
   * points share. History arrays have the internal variables of the law first,
   * then its kept values.
   */
  class SectionUpdate
  {
  public:
    virtual ~SectionUpdate() = default;

    /**
     * Computes section forces and tangents.
     * @param strains at the end of the step
     * @param committed history at its start
     * @param trial receives the history at the end
     */
    virtual void evaluate(const SectionPoint &point,
                          const Lanes        *strains,
                          const Lanes        *committed,
                          Lanes              *trial,
                          SectionResponse    &response) const = 0;

    /** Strains at the start of the step, from its history. */
    virtual void start_strains(const SectionPoint &point,
                               const Lanes        *committed,
                               Lanes              *strains) const = 0;
  };

  /** Energies lost by a law in steps of one kind and length. */
  class SectionLosses
  {
  public:
    virtual ~SectionLosses() = default;

    /**
     * Energy lost per length in an accepted step (J/m), >= 0.
     * @param committed, accepted history at the start and the end
     */
    virtual Lanes lost(const SectionPoint &point,
                       const Lanes        *committed,
                       const Lanes        *accepted) const = 0;
  };

  /**
   * The law of a material in the sections of struts: strain history at a Gauss
   * point to section forces. One object serves all struts of a material and
   * holds parameters only. All history is zero at rest. Elastic struts have no
   * such law: ElasticSection in the kernels is theirs.
   */
  class SectionLaw
  {
  public:
    virtual ~SectionLaw() = default;

    /** Whether forces are linear in strains and history. */
    virtual bool is_linear() const = 0;

    /** Whether the equilibrium at the start of a run is the relaxed one. */
    virtual bool starts_relaxed() const = 0;

    /** Number of internal variables of a Gauss point, which obey differential
     * equations. */
    virtual unsigned int n_internal(const SectionPoint &point) const = 0;

    /** Number of other values kept from step to step at a Gauss point. */
    virtual unsigned int n_kept(const SectionPoint &point) const = 0;

    /** The law over steps of one kind and length. */
    virtual std::unique_ptr<SectionUpdate>
    update(const SectionStep &step) const = 0;

    /** Losses in steps of one kind and length. */
    virtual std::unique_ptr<SectionLosses>
    losses(const SectionStep &step) const = 0;

    /**
     * The law as ordinary differential equations at an instant.
     * @param internal_rates receives the rates of the internal variables (1/s)
     */
    virtual void instant(const SectionPoint &point,
                         const Lanes        *strains,
                         const Lanes        *internal,
                         Lanes              *internal_rates,
                         SectionInstant     &instant) const = 0;

    /** Stiffness after complete relaxation over the instantaneous one. */
    virtual double long_time_ratio(StrainType type) const = 0;

    /** Terms r s tau / (1 + s tau) that motions e^(s t) add to the stiffness
     * after complete relaxation, over the instantaneous one: r by tau (s). */
    virtual std::map<double, double> relaxing_ratios(StrainType type) const = 0;
  };

  /** Registry of all laws (source/struts/section_law.cc); the entry of the
   * elastic law makes no object. */
  const Registry<SectionLaw> &section_law_registry();

  /**
   * @name Registry entries of the laws, one per file in source/struts/.
   */
  ///@{
  RegistryEntry<SectionLaw> viscoelastic_entry();
  ///@}
} // namespace auxfem

#endif
