#ifndef auxfem_struts_section_law_h
#define auxfem_struts_section_law_h

#include <auxfem/mathematics/lanes.h>
#include <auxfem/parameters/registry.h>
#include <auxfem/struts/fibres.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>

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
    /** Square roots of the stiffnesses over EA; of curvatures the radii of
     * gyration (m). */
    const Lanes *radii;
  };

  /** Section forces at a Gauss point, by strain (N, N m). */
  struct SectionResponse
  {
    Lanes forces[max_section_strains];
    /** Derivative of each force by its strain. */
    Lanes tangent[max_section_strains];
    /** Whether forces depend on strains besides their own. */
    bool is_coupled = false;
    /** Derivative of each force by the other strains, symmetric; set only if
     * is_coupled. */
    Lanes coupling[max_section_strains][max_section_strains];
    /** Energy stored per length (J/m). */
    Lanes stored;
  };

  /**
   * History of a Gauss point of several elements: internal variables, which
   * obey differential equations, and other values kept from step to step. Read
   * one by one, since most laws need few of them.
   */
  struct SectionHistory
  {
    LaneArray<const double *> internal_values, kept_values;

    Lanes internal(const unsigned int i) const
    {
      return make_lanes(
        [&](const auto lane) { return internal_values[lane][i]; });
    }

    Lanes kept(const unsigned int i) const
    {
      return make_lanes([&](const auto lane) { return kept_values[lane][i]; });
    }
  };

  /** Receives the history of a Gauss point. */
  struct SectionHistoryOutput
  {
    LaneArray<double *> internal_values, kept_values;

    void set_internal(const unsigned int i, const Lanes &value) const
    {
      for (std::size_t lane = 0; lane < n_lanes; ++lane)
        internal_values[lane][i] = lane_value(value, lane);
    }

    void set_kept(const unsigned int i, const Lanes &value) const
    {
      for (std::size_t lane = 0; lane < n_lanes; ++lane)
        kept_values[lane][i] = lane_value(value, lane);
    }

    /** Keeps the values [begin, end) of @p history. */
    void copy_kept(const SectionHistory &history,
                   const unsigned int    begin,
                   const unsigned int    end) const
    {
      for (std::size_t lane = 0; lane < n_lanes; ++lane)
        std::copy(history.kept_values[lane] + begin,
                  history.kept_values[lane] + end,
                  kept_values[lane] + begin);
    }
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

  /** How far a section has yielded. */
  struct SectionYielding
  {
    /** Largest accumulated plastic strain of its fibres. */
    Lanes plastic_strain = 0;
    /** Largest stress minus back stress of its fibres, over the yield stress
     * there. */
    Lanes utilisation = 0;
    /** Normal stress of the fibre where it is largest in magnitude, and largest
     * von Mises stress of a fibre, over Young's modulus. */
    Lanes fibre_stress = 0, equivalent_stress = 0;
    /** Largest plastic strain or stress over that at which struts break; 0:
     * they do not. */
    Lanes failure = 0;
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

  /** A law over steps of one kind and length. Holds coefficients that all Gauss
   * points share. */
  class SectionUpdate
  {
  public:
    virtual ~SectionUpdate() = default;

    /**
     * Computes section forces and tangents.
     * @param strains at the end of the step
     * @param committed history at its start
     * @param end receives the history at the end, unless nullptr
     */
    virtual void evaluate(const SectionPoint         &point,
                          const Lanes                *strains,
                          const SectionHistory       &committed,
                          const SectionHistoryOutput *end,
                          SectionResponse            &response) const = 0;

    /** Strains at the start of the step, from its history. */
    virtual void start_strains(const SectionPoint   &point,
                               const SectionHistory &committed,
                               Lanes                *strains) const = 0;
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
    virtual Lanes lost(const SectionPoint   &point,
                       const SectionHistory &committed,
                       const SectionHistory &accepted) const = 0;
  };

  /**
   * The law of a material in the sections of struts: strain history at a Gauss
   * point to section forces. One object serves all struts of a material, or
   * those with sections of one shape, and holds parameters only. All history is
   * zero at rest. Elastic struts have no such law: ElasticSection in the
   * kernels is theirs.
   */
  class SectionLaw
  {
  public:
    virtual ~SectionLaw() = default;

    /** The part of a shape that the law depends on. */
    virtual SectionShape needed_shape(const SectionShape & /*shape*/) const
    {
      return {};
    }

    /** The law in sections of a needed_shape(); nullptr: this one, which serves
     * all. */
    virtual std::shared_ptr<const SectionLaw>
    in_shape(const SectionShape & /*shape*/) const
    {
      return nullptr;
    }

    /** Whether forces are linear in strains and history. */
    virtual bool is_linear() const = 0;

    /** Whether the material yields: tangents jump where it begins to. */
    bool yields() const
    {
      return yield_strain().has_value();
    }

    /** Whether struts lose energy. */
    virtual bool loses_energy() const
    {
      return true;
    }

    /** Strain of a fibre at which it begins to yield, if it does. */
    virtual std::optional<double> yield_strain() const
    {
      return std::nullopt;
    }

    /** Instantaneous Young's modulus (Pa), if the data of the law include it.
     */
    virtual std::optional<double> youngs_modulus() const
    {
      return std::nullopt;
    }

    /** Note for users on the data of the law; empty: none. */
    virtual std::string note() const
    {
      return "";
    }

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
     * @param rates receives the rates of the internal variables (1/s), unless
     *   nullptr
     */
    virtual void instant(const SectionPoint         &point,
                         const Lanes                *strains,
                         const SectionHistory       &history,
                         const SectionHistoryOutput *rates,
                         SectionInstant             &instant) const = 0;

    /** How far a section has yielded at an instant. */
    virtual SectionYielding yielding(const SectionPoint & /*point*/,
                                     const Lanes * /*strains*/,
                                     const SectionHistory & /*history*/) const
    {
      return {};
    }

    /** Time in which a strut that breaks loses its forces (s); empty: struts do
     * not break. */
    virtual std::optional<double> failure_time() const
    {
      return std::nullopt;
    }

    /** Accumulated plastic strain at which the law's data end; empty: none. */
    virtual std::optional<double> largest_plastic_strain() const
    {
      return std::nullopt;
    }

    /** Stiffness after complete relaxation over the instantaneous one. */
    virtual double long_time_ratio(StrainType type) const = 0;

    /** Terms r s tau / (1 + s tau) that motions e^(s t) add to the stiffness
     * after complete relaxation, over the instantaneous one: r by tau (s). */
    virtual std::map<double, double> relaxing_ratios(StrainType type) const = 0;
  };

  /** Registry of all laws (source/struts/section_law.cc); the entry of the
   * elastic law makes no object. */
  const Registry<SectionLaw> &section_law_registry();

  /** The elastic law as an object, for struts with initial strains. */
  std::shared_ptr<const SectionLaw> make_elastic_section_law();

  /**
   * @name Registry entries of the laws, one per file in source/struts/.
   */
  ///@{
  RegistryEntry<SectionLaw> viscoelastic_entry();
  RegistryEntry<SectionLaw> elastic_plastic_entry();
  ///@}
} // namespace auxfem

#endif
