#ifndef auxfem_analysis_small_motions_relaxations_h
#define auxfem_analysis_small_motions_relaxations_h

#include <auxfem/analysis/tangent_solver.h>

#include <vector>

namespace auxfem
{
  /** A small motion that decays as e^(-rate t) and does not swing, or with 0.99
   * of the critical damping or more. */
  struct Relaxation
  {
    double rate;     ///< 1/s
    double residual; ///< |A(s) x| over |s A'(s) x|, s = -rate

    /** In which it decays to 1/e (s). */
    double time() const
    {
      return 1 / rate;
    }
  };

  /** The slowest first. */
  using Relaxations = std::vector<Relaxation>;

  /**
   * The @p n slowest relaxations about @p state, at rest there, with all
   * damping, among those nearest to the relaxation times of Maxwell elements,
   * to the lowest frequency and to zero (MotionPencil); fewer where there are
   * not so many. Collective.
   */
  Relaxations
  relaxations(TangentSolver &solver, const State &state, unsigned int n);
} // namespace auxfem

#endif
