#ifndef auxfem_algebra_complex_factors_h
#define auxfem_algebra_complex_factors_h

#include <auxfem/algebra/sparse_assembly.h>

#include <complex>
#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * Factors L U of a complex matrix A = W + i T between free unknowns, by KLU.
   * Every rank has the whole matrix: for matrices of moderate size. What
   * computes is collective.
   */
  class ComplexFactors
  {
  public:
    /** @param pattern of both parts; must outlive the object, and not change. */
    explicit ComplexFactors(const TangentPattern &pattern);
    ~ComplexFactors();

    /** Factorizes; false if A is singular or there is no room. */
    bool factorize(const TangentMatrix &real, const TangentMatrix &imaginary);

    /** The logarithm of the determinant of A, up to multiples of 2 pi i. */
    std::complex<double> log_determinant() const;

    /** Which of both matrices is solved with. */
    enum class Side
    {
      right, ///< A x = b
      left   ///< A^T x = b, without conjugation
    };

    /** @p x, real parts of owned rows before imaginary ones, becomes the
     * solution, zero in prescribed rows. */
    void solve(std::vector<double> &x, Side side = Side::right) const;

  private:
    class Klu;

    /** The entries of one part on all ranks, row by row.
     * @param of_prescribed diagonal entry of prescribed rows */
    std::vector<double> gather(const TangentMatrix &part, double of_prescribed);

    const UnknownLayout  &layout;
    const TangentPattern &pattern;
    std::vector<char>     is_prescribed; ///< of owned rows
    SparseAssembly        assembly;
    std::unique_ptr<Klu>  klu;
  };
} // namespace auxfem

#endif
