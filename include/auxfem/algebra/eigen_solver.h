#ifndef auxfem_algebra_eigen_solver_h
#define auxfem_algebra_eigen_solver_h

#include <auxfem/algebra/unknown_layout.h>

#include <functional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * K x = lambda M x with symmetric K and M, as operators on the owned rows of
   * all ranks: M positive semidefinite, or else K - sigma M positive definite.
   * What they compute is collective.
   */
  struct ShiftedEigenproblem
  {
    const UnknownLayout &layout;
    /** Sigma: not an eigenvalue itself. */
    double shift;
    /** y = M x. */
    std::function<void(const double *x, double *y)> multiply_mass;
    /** x becomes (K - sigma M)^-1 x; returns whether that succeeded. */
    std::function<bool(double *x)> solve;
    /** How many eigenvalues are finite, at most. */
    unsigned int n_finite;
    /** y = (K - sigma M) x, where M is not semidefinite: the product in which
     * vectors have unit length. Else none, and it is that by M. */
    std::function<void(const double *x, double *y)> multiply_definite = {};
    /** Whether eigenvalues below the shift do not count. */
    bool only_above = false;
  };

  struct Eigenpair
  {
    double value;
    /** Owned rows, of unit length in the norm by M, or by K - sigma M where
     * that is the definite one. */
    std::vector<double> vector;
  };

  /** What was found, by rising eigenvalue; `why` tells if it is not all. */
  struct Eigenpairs
  {
    std::vector<Eigenpair> pairs;
    std::string            why;
  };

  /**
   * The @p n eigenvalues nearest to the shift with their vectors: by
   * dense_eigenpairs() where few are finite, else by krylov_eigenpairs(). Of
   * equal eigenvalues the latter may miss some: count them by an inertia.
   * Collective.
   */
  Eigenpairs nearest_eigenpairs(const ShiftedEigenproblem &problem,
                                unsigned int               n);
} // namespace auxfem

#endif
