#ifndef auxfem_analysis_infinite_lattice_harmonic_moduli_h
#define auxfem_analysis_infinite_lattice_harmonic_moduli_h

#include <auxfem/analysis/simulation/lattice_run.h>

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <string>
#include <vector>

namespace auxfem
{
  /** Stiffness of an infinite lattice under slow oscillations of its mean
   * strain: storage is in phase, loss a quarter of a period ahead. */
  struct HarmonicModuli
  {
    double frequency; ///< Hz
    /** Real and imaginary part of the complex stiffness (Pa), in the order of
     * ElasticConstants. */
    dealii::FullMatrix<double> storage, loss;

    /** Complex compliance (1/Pa); empty if the stiffness is singular. */
    std::vector<std::complex<double>> compliance() const;
  };

  /** @p plan with all damping and relaxation that the scene does not leave out.
   */
  RunPlan with_damping(RunPlan plan);

  /** Whether anything in the lattice of @p run loses energy. */
  bool has_damping(const LatticeRun &run);

  /**
   * Moduli at @p frequencies (Hz), without inertia: the periods of oscillation
   * are long against those of the struts. Throws ComputationError if equations
   * cannot be solved. Collective.
   * @param run of an infinite lattice at rest, with a plan of with_damping()
   */
  std::vector<HarmonicModuli>
  harmonic_moduli(LatticeRun &run, const std::vector<double> &frequencies);

  /** Writes storage and loss of Young's moduli, shear moduli and stiffnesses by
   * frequency to @p file, and the meanings of its columns beside it. */
  void write_harmonic_moduli(const std::vector<HarmonicModuli> &moduli,
                             const std::string                 &folder);
} // namespace auxfem

#endif
