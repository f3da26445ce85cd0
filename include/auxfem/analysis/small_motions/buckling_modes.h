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
    double factor;   ///< lambda, of the loads
    double residual; ///< |K x + lambda K' x| over |lambda K' x|
    /** Of all local unknowns; rotations as vectors in the global frame. */
    Vector shape;
    /** Relative error of the factor by the elements; NaN: not known. */
    double mesh_error = std::numeric_limits<double>::quiet_NaN();
  };

  /** Modes by rising factor. */
  struct BucklingModes
  {
    std::vector<BucklingMode> modes;
    /** Whether an inertia of the stiffness (Sylvester) tells that there are no
     * others below the last; nothing where none is known (iterative solvers).
     */
    bool is_counted = false;
    /** Factors that this mesh has at most. */
    unsigned int n_possible = 0;
    /** How far the linear answer goes with the factor 1: rotation (rad) or
     * displacement over the mean length of struts, whichever is larger. */
    double motion = 0;
  };

  /** Which loads are multiplied by the factor. */
  struct BucklingLoads
  {
    double time;        ///< they are those of this time (s)
    bool   is_reversed; ///< their opposite is
  };

  /**
   * The @p n lowest factors lambda of loads and prescribed motions with which
   * the equilibrium @p state becomes indifferent, by linear theory: K is its
   * stiffness, and K' the geometric stiffness of the forces of struts,
   * connectors and constraints in the linear answer to what the loads of
   * loads.time change of those of @p state. At rest without loads they are all
   * loads of that time. Motions until then do not count otherwise.
   *
   * Fewer where the lattice has not so many. Throws InputError where the
   * state is not a stable equilibrium by itself, where loads follow their
   * joints, and where nothing loads the lattice or makes it buckle;
   * ComputationError if the modes are not found. Collective.
   */
  BucklingModes buckling_modes(TangentSolver       &solver,
                               const State         &state,
                               const BucklingLoads &loads,
                               unsigned int         n);

  /** Factors of finer elements near those of @p coarse, as
   * finer_eigenvalues(). */
  FinerValues finer_factors(TangentSolver             &solver,
                            const State               &state,
                            const BucklingLoads       &loads,
                            const BucklingModes       &coarse,
                            const std::vector<Vector> &shapes);
} // namespace auxfem

#endif
