#ifndef auxfem_figures_crush_curve_h
#define auxfem_figures_crush_curve_h

#include <optional>
#include <vector>

namespace auxfem
{
  /** Choices in the evaluation of a crush curve, see CrushDefinition. */
  struct CrushOptions
  {
    /** Strains between which the plateau is averaged. */
    double plateau_begin = 0.2, plateau_end = 0.4;
    /** Strain from which energies count in efficiency and plateau by energy. */
    double yield_strain = 0;
  };

  /**
   * Nominal stress over nominal strain of a crushed lattice, both positive in
   * compression.
   */
  struct CrushCurve
  {
    std::vector<double> strain;
    std::vector<double> stress; ///< Pa
    /** Work per volume since the start (J/m3), by the trapezoidal rule. */
    std::vector<double> work;

    /** Adds the next point and its work. */
    void add(double next_strain, double next_stress);
  };

  /**
   * The points of @p curve at which the strain is larger than at all before:
   * stress and work become functions of strain. Unloading and vibration in
   * between count in the work.
   */
  CrushCurve loading_part(const CrushCurve &curve);

  /** Figures of a crush curve (SI); strains have no unit. */
  struct CrushFigures
  {
    double largest_strain  = 0;
    double peak_stress     = 0; ///< up to the onset of densification, if known
    double work_to_largest = 0; ///< J/m3, up to the largest strain
    double work_at_end     = 0; ///< J/m3, after unloading

    /** @name By strain, after ISO 13314; empty if the strain is not reached. */
    ///@{
    /** Mean stress between the strains of the plateau, from values at steps of
     * 0.001. */
    std::optional<double> plateau_stress;
    /** Strain after the plateau at which stress is 1.3 plateau_stress. */
    std::optional<double> plateau_end;
    std::optional<double> work_to_plateau_end; ///< J/m3
    /** Work to the end of the plateau over the product of its strain and the
     * largest stress so far. */
    std::optional<double> efficiency_at_plateau_end;
    ///@}

    /**
     * @name By energy (Q. M. Li, I. Magkiriadis & J. J. Harrigan, J. Cellular
     * Plastics 42, 2006, 371-392)
     * Empty if the lattice has not densified: the efficiency, work over
     * stress, still grows at the largest strain.
     */
    ///@{
    /** Strain of the largest efficiency, the onset of densification. */
    std::optional<double> densification_strain;
    std::optional<double> efficiency;
    std::optional<double> work_to_densification; ///< J/m3
    /** Work from the yield strain on over the strain since. */
    std::optional<double> plateau_stress_by_energy;
    /** Work over stress and strain. */
    std::optional<double> ideality;
    /** Mean over peak force up to the onset. */
    std::optional<double> crush_force_efficiency;
    ///@}
  };

  /**
   * Efficiency at each point of @p loading: work from the yield strain on over
   * the stress (J. Miltz & G. Gruenbaum, Polymer Engineering and Science 21,
   * 1981, 1010-1014); zero before and where stress is not positive.
   */
  std::vector<double> efficiencies(const CrushCurve   &loading,
                                   const CrushOptions &options);

  /** Figures of @p curve, which has two points at least. */
  CrushFigures crush_figures(const CrushCurve   &curve,
                             const CrushOptions &options);
} // namespace auxfem

#endif
