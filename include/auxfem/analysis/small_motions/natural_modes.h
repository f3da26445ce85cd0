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
    /**
     * Values of all local unknowns; rotations as vectors in the global frame.
     */
    Vector shape;
    /** x.M r with r a unit translation along x, y, z of all nodes, supports
     * too (kg^1/2). Its square is the effective mass (kg). */
    std::array<double, 3> participation;

    /** Damped motion e^(growth t) cos(omega t). */
    struct Damped
    {
      double growth;            ///< minus the decay (1/s)
      double angular_frequency; ///< omega (rad/s)

      /** Damping ratio. */
      double ratio() const
      {
        return -growth / std::hypot(growth, angular_frequency);
      }
    };
    /** Damped counterpart, if requested (add_damped_modes()) and found. */
    std::optional<Damped> damped = {};

    /**
     * Relative discretization error of the frequency, or of the damped one if
     * that is larger; NaN: unknown.
     */
    double mesh_error = std::numeric_limits<double>::quiet_NaN();

    /** Angular frequency (rad/s); 0 for an unstable mode. */
    double angular_frequency() const
    {
      return eigenvalue > 0 ? std::sqrt(eigenvalue) : 0.;
    }

    /** Growth rate of an unstable mode (1/s); else 0. */
    double growth_rate() const
    {
      return eigenvalue < 0 ? std::sqrt(-eigenvalue) : 0.;
    }
  };

  /** Natural modes, sorted by increasing eigenvalue. */
  struct NaturalModes
  {
    std::vector<NaturalMode> modes;
    /** Shift sigma of the eigenproblem (1/s2). */
    double shift;
    /**
     * Whether Sylvester's law of inertia proves that no mode below the last one
     * is missing; false with iterative solvers, which give no inertia.
     */
    bool is_counted = false;
    /**
     * Whether the inertia contradicts the number of modes found below the last.
     */
    bool count_differs = false;
    /** Upper bound of the number of eigenvalues on this mesh. */
    unsigned int n_possible = 0;
    /** Number of negative eigenvalues that are not among the modes. */
    unsigned long n_further_negative = 0;

    /** Damped modes that are assigned to no natural mode. */
    std::vector<NaturalMode::Damped> further_damped = {};
    /**
     * All damped modes up to this |s| (rad/s) were found, as far as the Krylov
     * space shows. Empty if not requested or not converged.
     */
    std::optional<double> damped_limit = {};
  };

  /**
   * Whether natural modes exist: the stiffness at @p state is symmetric, that
   * is, no load follows its joint. Collective.
   */
  bool has_natural_modes(TangentSolver &solver, const State &state);

  /** Part of the stiffness that natural_modes() uses. */
  enum class StiffnessPart
  {
    whole,
    symmetric ///< (K + K^T)/2; not physical under follower loads
  };

  /**
   * Computes the @p n lowest natural modes about the rest state @p state
   * without damping. K is the stiffness of the equilibrium with relaxed Maxwell
   * elements, M the mass matrix. Returns fewer if the mesh has fewer. Throws
   * ComputationError if none is found, and InputError if the whole K is
   * unsymmetric. Collective.
   */
  NaturalModes natural_modes(TangentSolver &solver,
                             const State   &state,
                             unsigned int   n,
                             StiffnessPart  part = StiffnessPart::whole);

  /**
   * Eigenvalues near those of @p base, of finer elements or of a lattice that
   * differs little, by one block inverse iteration of its modes. Their error is
   * the squared error of the shapes (Xu and Zhou 2001). Throws
   * ComputationError. Collective.
   * @param solver, state those of the other elements or lattice
   * @param shapes mode shapes, values of all local unknowns of @p solver
   */
  FinerValues nearby_eigenvalues(TangentSolver             &solver,
                                 const State               &state,
                                 const NaturalModes        &base,
                                 const std::vector<Vector> &shapes);
} // namespace auxfem

#endif
