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
    none, ///< Maxwell elements carry nothing, as slow motions leave them
    all
  };

  /**
   * The equations of small motions about an equilibrium that go as e^(s t),
   * with or without damping: A(s) x = b, A = W + i T with real W and T. Vectors
   * are real parts of owned rows, then imaginary ones; in prescribed rows A is
   * the identity. What computes is collective.
   */
  class DynamicStiffness
  {
  public:
    using Values = std::vector<double>;

    /** @param solver must outlive the object; its matrix becomes W. */
    DynamicStiffness(TangentSolver &solver,
                     const State   &equilibrium,
                     Damping        damping = Damping::all);

    /** The evaluation at the equilibrium. */
    Evaluation evaluation()
    {
      return Evaluation::equilibrium(at_rest, now);
    }

    /** Finds A at @p s (1/s). */
    void set(std::complex<double> s);

    /** @p matrix becomes the mass matrix M, which s^2 multiplies in A. */
    void find_mass(TangentMatrix &matrix);

    /** Equations::relaxing_stiffness(). */
    void find_relaxing(double time, TangentMatrix &matrix);

    /** @p y = A x. */
    void multiply(const double *x, double *y) const;

    /** Factorizes W for solve(); false if it is singular, solver.why(). */
    bool factorize()
    {
      return solver.factorize();
    }

    /** Solves A x = b to round-off, the first guess in @p x. Returns an empty
     * text or why that failed. */
    std::string solve(const Values &b, Values &x);

    /** x.A x, without conjugation. */
    std::complex<double> form(const Values &x) const;

    /** A times local @p real and @p imaginary values, of owned rows; prescribed
     * ones have the forces of supports. */
    std::pair<Vector, Vector> forces(const Vector &real,
                                     const Vector &imaginary) const;

  private:
    TangentSolver       &solver;
    const Equations     &equations;
    const UnknownLayout &layout;
    const Damping        damping;
    const ModeSpace      space;
    const State          at_rest;
    State                now;
    EvaluationResults    results;
    TangentMatrix        imaginary;
  };

  /** Turns on the damping that is `auto`: the speed of loads tells nothing of
   * vibrations. */
  void include_damping(EffectSwitches &effects);

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
