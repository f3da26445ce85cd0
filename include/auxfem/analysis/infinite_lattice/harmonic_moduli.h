#ifndef auxfem_analysis_infinite_lattice_harmonic_moduli_h
#define auxfem_analysis_infinite_lattice_harmonic_moduli_h

#include <auxfem/analysis/simulation/lattice_run.h>

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Stiffness of an infinite lattice under slow oscillations of its mean
   * strain: the stress of storage is in phase, that of loss a quarter of a
   * period ahead. */
  struct HarmonicModuli
  {
    double frequency; ///< Hz
    /** Complex stiffness (Pa) in the order of ElasticConstants: storage is its
     * real part, loss its imaginary part. */
    dealii::FullMatrix<std::complex<double>> stiffness;

    /** Complex compliance (1/Pa); empty if the stiffness is singular. */
    std::optional<dealii::FullMatrix<std::complex<double>>> compliance() const;
  };

  /** @p plan with all damping and relaxation that the scene does not leave out.
   */
  RunPlan with_damping(RunPlan plan);

  /** Whether anything loses energy. */
  bool has_damping(const SimulatedEffects &simulated);

  /**
   * Moduli at @p frequencies (Hz), without inertia: the periods of oscillation
   * are long against those of the struts. Throws ComputationError if equations
   * cannot be solved. Collective.
   * @param run of an infinite lattice at rest, with a plan of with_damping()
   */
  std::vector<HarmonicModuli>
  harmonic_moduli(LatticeRun &run, const std::vector<double> &frequencies);

  /** Writes storage and loss of Young's moduli, shear moduli and stiffnesses by
   * frequency to moduli.csv in @p folder, and the meanings of its columns beside
   * it. */
  void write_harmonic_moduli(const std::vector<HarmonicModuli> &moduli,
                             const std::string                 &folder);
} // namespace auxfem

#endif
