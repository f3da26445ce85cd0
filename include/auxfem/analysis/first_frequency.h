#ifndef auxfem_analysis_first_frequency_h
#define auxfem_analysis_first_frequency_h

#include <auxfem/analysis/tangent_solver.h>

#include <optional>

namespace auxfem
{
  /**
   * Lowest angular frequency (1/s) of small undamped oscillations about
   * @p state: Rayleigh's quotient of the tangent stiffness and the mass matrix
   * after a few inverse iterations with the diagonal of the latter, from above
   * and within a few per cent. Nothing if the structure can move freely.
   * Collective.
   */
  std::optional<double> first_frequency(TangentSolver &solver,
                                        const State   &state);
} // namespace auxfem

#endif
