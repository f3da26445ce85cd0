#ifndef auxfem_analysis_small_motions_dynamic_stiffness_h
#define auxfem_analysis_small_motions_dynamic_stiffness_h

#include <auxfem/equations/mode_space.h>
#include <auxfem/equations/tangent_solver.h>
#include <auxfem/scene/scene.h>

#include <complex>
#include <vector>

namespace auxfem
{
  /** Whether small motions lose energy to connectors and struts. */
  enum class Damping
  {
    none, ///< Maxwell elements are relaxed and carry no force
    all
  };

  /**
   * Dynamic stiffness A(s) = W + i T (W, T real) of small motions x e^(s t)
   * about an equilibrium, with or without damping. Vectors hold the real parts
   * of owned rows, then the imaginary parts. In prescribed rows A is the
   * identity. Functions that compute are collective.
   */
  class DynamicStiffness
  {
  public:
    using Values = std::vector<double>;

    /** @param solver must outlive the object; its matrix becomes W. */
    DynamicStiffness(TangentSolver &solver,
                     const State   &equilibrium,
                     Damping        damping = Damping::all);

    /** Evaluation of the equations at the equilibrium. */
    Evaluation evaluation()
    {
      return Evaluation::equilibrium(start_state, end_state);
    }

    /** Assembles A at @p s (1/s). */
    void set(std::complex<double> s);

    /** @p matrix becomes the mass matrix M, which s^2 multiplies in A. */
    void assemble_mass(TangentMatrix &matrix);

    /** Equations::relaxing_stiffness(). */
    void assemble_relaxing_stiffness(double time, TangentMatrix &matrix);

    /** @p y = A x. */
    void multiply(const double *x, double *y) const;

    /** Factorizes W for solve(); false if it is singular,
     * solver.last_failure(). */
    bool factorize()
    {
      return solver.factorize();
    }

    /**
     * Solves A x = b to round-off from the initial guess in @p x. Returns an
     * empty text, or the reason of a failure.
     */
    std::string solve(const Values &b, Values &x);

    /** x.A x, without conjugation. */
    std::complex<double> form(const Values &x) const;

    /**
     * Owned rows of A times the local values @p real and @p imaginary.
     * Prescribed rows contain the support forces.
     */
    std::pair<Vector, Vector> forces(const Vector &real,
                                     const Vector &imaginary) const;

  private:
    TangentSolver       &solver;
    const Equations     &equations;
    const UnknownLayout &layout;
    const Damping        damping;
    const ModeSpace      space;
    const State          start_state;
    State                end_state;
    EvaluationResults    results;
    TangentMatrix        imaginary;
  };

  /**
   * Turns on damping that is `auto`, because the rate of loading does not show
   * whether vibrations are damped.
   */
  void include_damping(EffectSwitches &effects);

  /**
   * A small motion that decays as e^(-rate t), without oscillation or with a
   * damping ratio of at least 0.99.
   */
  struct Relaxation
  {
    double rate;     ///< 1/s
    double residual; ///< |A(s) x| over |s A'(s) x|, s = -rate

    /** Relaxation time (s): the motion decays to 1/e. */
    double time() const
    {
      return 1 / rate;
    }
  };

  /** Relaxations, sorted by increasing rate. */
  using Relaxations = std::vector<Relaxation>;

  /**
   * Computes the @p n slowest relaxations about the rest state @p state with
   * all damping. The search covers roots nearest to the Maxwell relaxation
   * rates, to the lowest frequency and to zero (MotionPencil). Returns fewer if
   * there are fewer. Collective.
   */
  Relaxations
  relaxations(TangentSolver &solver, const State &state, unsigned int n);
} // namespace auxfem

#endif
