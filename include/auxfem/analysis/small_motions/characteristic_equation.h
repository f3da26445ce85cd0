#ifndef auxfem_analysis_small_motions_characteristic_equation_h
#define auxfem_analysis_small_motions_characteristic_equation_h

#include <auxfem/analysis/small_motions/dynamic_stiffness.h>

#include <map>
#include <optional>

namespace auxfem
{
  /**
   * D(s) = det A(s) prod (1 + s tau) = 0 of a dynamic stiffness A, with the
   * relaxation times tau of Maxwell elements: it has no poles, and its roots
   * are the complex modes. What computes is collective.
   */
  class CharacteristicEquation
  {
  public:
    using Complex = std::complex<double>;
    using Values  = DynamicStiffness::Values;

    /** @param solver must outlive the object; its matrix is used. */
    CharacteristicEquation(TangentSolver &solver,
                           const State   &equilibrium,
                           Damping        damping);

    /** Whether matrices of this size are factorized as complex ones. */
    static bool is_within_reach(const TangentSolver &solver);

    /** log D(s), up to multiples of 2 pi i, and its derivative (s). */
    struct Logarithm
    {
      Complex value, slope;
    };

    /** At @p s (1/s); none where A is singular. */
    std::optional<Logarithm> at(Complex s);

    /** A root and its shape, on owned rows: real parts before imaginary ones.
     */
    struct Root
    {
      Complex s; ///< 1/s
      Values  shape;
      /** |A(s) x| over |s A'(s) x|. */
      double residual;
      /** By which s still changes, from round-off (1/s). */
      double uncertainty;
    };

    /**
     * The root near @p guess with its shape, by inverse iteration and
     * Rayleigh's quotient with shapes of both sides, y.A x / y.A' x (Ostrowski
     * 1959; for roots of any A(s) Schreiber 2008); none where that does not
     * settle.
     * @param number of the vector that the iteration begins with
     */
    std::optional<Root> refine(Complex guess, unsigned int number);

    /** Complex factorizations until now. */
    unsigned long n_factorizations() const
    {
      return n_done;
    }

  private:
    bool                   factorize(Complex s);
    std::optional<Complex> logarithm(Complex s);
    Values                 beginning(unsigned int number) const;
    Values                 derivative(Complex s, const Values &x);
    std::optional<Complex> step(Complex s, Values &x, Values &y);

    const UnknownLayout &layout;
    DynamicStiffness     stiffness;
    ComplexFactors       factors;
    /** By how often there are such; empty without damping. */
    const std::map<double, unsigned int> relaxation_times;
    unsigned long                        n_done = 0;
  };
} // namespace auxfem

#endif
