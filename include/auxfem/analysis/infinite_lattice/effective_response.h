#ifndef auxfem_analysis_infinite_lattice_effective_response_h
#define auxfem_analysis_infinite_lattice_effective_response_h

#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/infinite_lattice/wave_stability.h>

namespace auxfem
{
  /** Plan of the response of the infinite lattice of @p scene to its mean
   * deformation: equilibria at large rotations. */
  RunPlan plan_of_response(const Scene &scene);

  /** Mean state of an infinite lattice, row by row: strains, then nominal
   * stresses (Pa). Collective. */
  std::vector<double> mean_strains_and_stresses(const LatticeModel &model,
                                                const State        &state);

  /** Stiffness of an infinite lattice for stress along one axis. */
  struct UniaxialTangent
  {
    double modulus; ///< Pa
    /** Negative derivative of the strain along each axis by that along the
     * axis. */
    std::array<double, 3> poissons_ratios;
  };

  /**
   * Stiffness along the axis @p i from tangent @p moduli, see PeriodTangent:
   * the other stresses stay constant, except where @p is_held, row by row, says
   * that the strain does. None if that has no unique answer.
   */
  std::optional<UniaxialTangent>
  uniaxial_tangent(const dealii::FullMatrix<double> &moduli,
                   const std::vector<bool>          &is_held,
                   unsigned int                      i);

  /**
   * Computes a scene with Analysis = effective response for @p recorder, and
   * writes tangents and losses of stability into @p directory if it is given.
   * Throws InputError and ComputationError. Collective.
   */
  RunResult run_effective_response(const Scene &scene,
                                   MPI_Comm     communicator,
                                   Recorder    &recorder,
                                   const std::optional<std::string> &directory);
} // namespace auxfem

#endif
