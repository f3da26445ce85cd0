#ifndef auxfem_analysis_small_motions_motion_pencil_h
#define auxfem_analysis_small_motions_motion_pencil_h

#include <auxfem/analysis/small_motions/dynamic_stiffness.h>

#include <functional>
#include <optional>
#include <vector>

namespace auxfem
{
  /** Shift of MotionPencil::nearest() over the size of the smallest root: below
   * it, and no simple fraction, so that it is hardly a root itself. */
  constexpr double shift_below_roots = 0.0917;

  /** A small motion x e^(s t): A(s) x = 0. */
  struct MotionRoot
  {
    std::complex<double> s; ///< 1/s; of two conjugate ones that above
    /** Owned rows: real parts before imaginary ones, of unit length. */
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
   * (1 + s tau_j). What computes is collective.
   */
  class MotionPencil
  {
  public:
    using Complex = std::complex<double>;

    /** @param solver must outlive the object; its matrix is used. */
    MotionPencil(TangentSolver &solver,
                 const State   &equilibrium,
                 Damping        damping);

    /** Which roots nearest() is to find. */
    struct Wanted
    {
      std::function<bool(Complex)> counts; ///< of these alone
      unsigned int n; ///< so many are enough, or are expected with a reach
      /** In place of n all with |s| up to this (1/s). */
      std::optional<double> reach = {};
    };

    /** By rising distance from the shift. */
    struct Roots
    {
      std::vector<MotionRoot> roots;
      /** Whether they are all that are wanted, as far as the Krylov space
       * tells. */
      bool is_complete;
    };

    /**
     * The roots nearest to the real @p shift (1/s) by Arnoldi's method for the
     * shifted and inverted problem, which factorizes the real A(shift) once.
     * A block of three start vectors finds roots that are equal. Symmetric A
     * improve each root by Rayleigh's quotient x.A(s) x = 0. Throws
     * ComputationError where A(shift) cannot be factorized.
     */
    Roots nearest(double shift, const Wanted &wanted);

    /** x.M x of the real vector @p x and the complex @p shape. */
    Complex mass_product(const Vector              &x,
                         const std::vector<double> &shape) const;

  private:
    class Arnoldi;

    std::vector<double> multiply(const TangentMatrix &matrix,
                                 const double        *x) const;
    /** Size of rates (1/s) at which stiffness and inertia of single rows are
     * alike, if A(0) is the matrix of the solver. */
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

    /** Maxwell elements of one relaxation time. */
    struct Relaxing
    {
      double        time;
      TangentMatrix stiffness;
    };
    std::vector<Relaxing> relaxing;
  };

  /** Whether a motion swings: Im s > 0 by more than round-off. */
  bool swings(std::complex<double> s);

  /** Whether it relaxes: it decays with more than 0.99 of critical damping. */
  bool relaxes(std::complex<double> s);
} // namespace auxfem

#endif
