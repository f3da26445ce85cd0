#ifndef auxfem_analysis_small_motions_natural_modes_h
#define auxfem_analysis_small_motions_natural_modes_h

#include <auxfem/equations/mode_space.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace auxfem
{
  /** A solution x of K x = omega^2 M x with x.M x = 1. */
  struct NaturalMode
  {
    double eigenvalue; ///< omega^2 (1/s2); negative: the state is unstable
    /**
     * |K x - omega^2 M x| over |(omega^2 - sigma) M x|, with the shift sigma of
     * the eigenproblem.
     */
    double residual;
    /** Of all local unknowns; rotations as vectors in the global frame. */
    Vector shape;
    /** x.M r with r a unit translation along x, y, z of all nodes, supports
     * too (kg^1/2). Its square is the effective mass (kg). */
    std::array<double, 3> participation;

    /** What damping makes of it: it goes as e^(-decay t) cos(omega t). */
    struct Damped
    {
      double growth;            ///< minus the decay (1/s)
      double angular_frequency; ///< omega (rad/s)

      /** Damping over the critical one. */
      double ratio() const
      {
        return -growth / std::hypot(growth, angular_frequency);
      }
    };
    /** If asked for (add_damped_modes()) and found. */
    std::optional<Damped> damped = {};

    /** Relative error of the frequency by the elements, of the damped one where
     * that errs more; NaN: not known. */
    double mesh_error = std::numeric_limits<double>::quiet_NaN();

    /** Angular frequency (rad/s); 0 of an unstable mode. */
    double angular_frequency() const
    {
      return eigenvalue > 0 ? std::sqrt(eigenvalue) : 0.;
    }

    /** Of an unstable mode, at which rate it grows (1/s); else 0. */
    double growth_rate() const
    {
      return eigenvalue < 0 ? std::sqrt(-eigenvalue) : 0.;
    }
  };

  /** Modes by rising eigenvalue. */
  struct NaturalModes
  {
    std::vector<NaturalMode> modes;
    /** Sigma (1/s2). */
    double shift;
    /** Whether an inertia of the tangent (Sylvester) tells that there are no
     * others below the last; nothing where none is known (iterative solvers).
     */
    bool is_counted = false;
    /** Whether that inertia tells another number below the last than was found.
     */
    bool count_differs = false;
    /** Eigenvalues that this mesh can have at most. */
    unsigned int n_possible = 0;
    /** More negative eigenvalues than are among the modes. */
    unsigned long n_further_negative = 0;

    /** Damped modes that belong to none of the modes. */
    std::vector<NaturalMode::Damped> further_damped = {};
    /** Up to this |s| (rad/s) all damped modes were found, as far as the Krylov
     * space tells; none where they were not asked for or it has not converged.
     */
    std::optional<double> damped_limit = {};
  };

  /** Whether the stiffness of @p state is symmetric, as it is without loads
   * that follow their joints, so that it has natural modes. Collective. */
  bool has_natural_modes(TangentSolver &solver, const State &state);

  /** Of the stiffness of natural_modes(). */
  enum class StiffnessPart
  {
    whole,
    symmetric ///< (K + K^T)/2: no state vibrates so under loads that follow
  };

  /**
   * The @p n lowest natural modes of small vibrations about @p state, at rest
   * there, without damping: K is the stiffness of the equilibrium, with Maxwell
   * elements relaxed, M the mass matrix. Fewer where the mesh has not
   * so many. Throws ComputationError if none is
   * found, and InputError where K, whole, is not symmetric. Collective.
   */
  NaturalModes natural_modes(TangentSolver &solver,
                             const State   &state,
                             unsigned int   n,
                             StiffnessPart  part = StiffnessPart::whole);

  /**
   * Eigenvalues of finer elements near those of @p coarse: one inverse iteration
   * of its modes together, whose error is that of the shapes, squared (Xu and
   * Zhou 2001).
   * @param solver, state of the finer elements
   * @param shapes of the modes, of all local unknowns of the finer elements
   * Throws ComputationError. Collective.
   */
  FinerValues finer_eigenvalues(TangentSolver             &solver,
                                const State               &state,
                                const NaturalModes        &coarse,
                                const std::vector<Vector> &shapes);
} // namespace auxfem

#endif
