#ifndef auxfem_analysis_small_motions_buckling_modes_h
#define auxfem_analysis_small_motions_buckling_modes_h

#include <auxfem/equations/mode_space.h>

#include <limits>
#include <vector>

namespace auxfem
{
  /** A solution x of (K + lambda K') x = 0 with x.K x = 1. */
  struct BucklingMode
  {
    double factor;   ///< load factor lambda
    double residual; ///< |K x + lambda K' x| over |lambda K' x|
    /**
     * Values of all local unknowns; rotations as vectors in the global frame.
     */
    Vector shape;
    /** Relative discretization error of the factor; NaN: unknown. */
    double mesh_error = std::numeric_limits<double>::quiet_NaN();
  };

  /** Buckling modes, sorted by increasing factor. */
  struct BucklingModes
  {
    std::vector<BucklingMode> modes;
    /**
     * Whether Sylvester's law of inertia proves that no factor below the last
     * one is missing; false with iterative solvers, which give no inertia.
     */
    bool is_counted = false;
    /** Upper bound of the number of factors on this mesh. */
    unsigned int n_possible = 0;
    /**
     * Size of the linear response at factor 1: the larger of the rotation (rad)
     * and the displacement over the mean strut length.
     */
    double motion = 0;
  };

  /** Load case that the factor multiplies. */
  struct BucklingLoads
  {
    double time;        ///< loads are evaluated at this time (s)
    bool   is_reversed; ///< the sign of the loads is reversed
  };

  /**
   * Computes the @p n lowest factors lambda by linear buckling theory. K is the
   * stiffness at the equilibrium @p state. K' is the geometric stiffness of the
   * internal forces in the linear response to the load increment. The increment
   * leads from the loads and prescribed motions of @p state to those at
   * loads.time.
   *
   * Returns fewer modes if the lattice has fewer. Throws InputError if the
   * state is not a stable equilibrium, if loads follow their joints, or if no
   * load can cause buckling; ComputationError if the eigensolver fails.
   * Collective.
   */
  BucklingModes buckling_modes(TangentSolver       &solver,
                               const State         &state,
                               const BucklingLoads &loads,
                               unsigned int         n);

  /**
   * Factors on finer elements near those of @p coarse; see nearby_eigenvalues().
   */
  FinerValues finer_factors(TangentSolver             &solver,
                            const State               &state,
                            const BucklingLoads       &loads,
                            const BucklingModes       &coarse,
                            const std::vector<Vector> &shapes);
} // namespace auxfem

#endif
