#ifndef auxfem_analysis_small_motions_motion_pencil_h
#define auxfem_analysis_small_motions_motion_pencil_h

#include <auxfem/analysis/small_motions/dynamic_stiffness.h>

#include <functional>
#include <optional>
#include <vector>

namespace auxfem
{
  /**
   * Shift of MotionPencil::nearest() over the magnitude of the smallest root.
   * It is below 1 and no simple fraction, so that it does not hit a root.
   */
  constexpr double shift_below_roots = 0.0917;

  /** A small motion x e^(s t): A(s) x = 0. */
  struct MotionRoot
  {
    std::complex<double> s; ///< 1/s; of a conjugate pair the one with Im s > 0
    /** Owned rows, real parts before imaginary ones, of unit norm. */
    std::vector<double> shape;
    /** |A(s) x| over |s A'(s) x|. */
    double residual;
    /** Round-off of s (1/s). */
    double uncertainty;
  };

  /**
   * The eigenvalue problem of first order of small motions about an
   * equilibrium,
   *
   *     x' = v,  M v' = -K x - C v - sum_j (E_j x - q_j),  tau_j q_j' = E_j x -
   * q_j,
   *
   * with the forces q_j of the dashpots of Maxwell elements of relaxation time
   * tau_j as further unknowns, so A(s) = K + s C + s^2 M + sum_j E_j s tau_j /
   * (1 + s tau_j). Complex modes, damped modes and relaxations are its roots.
   * Functions that compute are collective.
   */
  class MotionPencil
  {
  public:
    using Complex = std::complex<double>;

    /** @param solver must outlive the object; its matrix is used. */
    MotionPencil(TangentSolver &solver,
                 const State   &equilibrium,
                 Damping        damping);

    /** Selects the roots that nearest() returns. */
    struct RootSelection
    {
      std::function<bool(Complex)> accepts; ///< filter for roots
      unsigned int n; ///< number of roots, an estimate with max_magnitude
      /** If set, selects all roots with |s| up to this (1/s) instead of n. */
      std::optional<double> max_magnitude = {};
    };

    /** Roots, sorted by increasing distance from the shift. */
    struct Roots
    {
      std::vector<MotionRoot> roots;
      /**
       * Whether these are all selected roots, as far as the Krylov space shows.
       */
      bool is_complete;
    };

    /**
     * Computes the roots nearest to the real @p shift (1/s) by shift-and-invert
     * Arnoldi, which factorizes A(shift) once. A block of three start vectors
     * finds multiple roots. For symmetric A, each root is improved by the
     * Rayleigh quotient x.A(s) x = 0. Throws ComputationError if the
     * factorization fails.
     */
    Roots nearest(double shift, const RootSelection &selection);

    /** x.M x of the real vector @p x and the complex @p shape. */
    Complex mass_product(const Vector              &x,
                         const std::vector<double> &shape) const;

  private:
    class Arnoldi;

    std::vector<double> multiply(const TangentMatrix &matrix,
                                 const double        *x) const;
    /**
     * Rate (1/s) at which stiffness and inertia of single rows balance.
     * Requires A(0) as the matrix of the solver.
     */
    double              fastest_rate() const;
    MotionRoot          root(Complex s, std::vector<double> shape);
    void                improve(MotionRoot &root);
    std::vector<double> derivative(Complex s, const std::vector<double> &x);

    TangentSolver       &solver;
    const UnknownLayout &layout;
    ModeSpace            space;
    DynamicStiffness     stiffness;
    TangentMatrix        mass, damping_matrix;
    bool                 is_symmetric;

    /** Maxwell elements with a common relaxation time (s). */
    struct RelaxationGroup
    {
      double        time;
      TangentMatrix stiffness;
    };
    std::vector<RelaxationGroup> relaxing;
  };

  /** Whether a motion oscillates: Im s > 0 by more than round-off. */
  bool swings(std::complex<double> s);

  /** Whether a motion decays with a damping ratio above 0.99. */
  bool relaxes(std::complex<double> s);
} // namespace auxfem

#endif
