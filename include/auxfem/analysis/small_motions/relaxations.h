#ifndef auxfem_analysis_small_motions_relaxations_h
#define auxfem_analysis_small_motions_relaxations_h

#include <auxfem/analysis/tangent_solver.h>

#include <optional>
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

  struct Relaxations
  {
    /** The slowest first. */
    std::vector<Relaxation> all;
    /** How many of those that were counted were not found; none where they were
     * not counted. */
    std::optional<unsigned int> n_missing;
  };

  /**
   * The @p n slowest relaxations about @p state, at rest there, with all
   * damping; fewer where there are not so many within some powers of ten about
   * the relaxation times of Maxwell elements and the lowest frequency. Throws
   * InputError for lattices that are too large. Collective.
   */
  Relaxations
  relaxations(TangentSolver &solver, const State &state, unsigned int n);
} // namespace auxfem

#endif
