#include <auxfem/algebra/eigen_solver.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace auxfem
{
  namespace
  {
    void scale(const ShiftedEigenproblem &problem, std::vector<double> &vector)
    {
      std::vector<double> weighted(vector.size());
      (problem.multiply_definite
         ? problem.multiply_definite
         : problem.multiply_mass)(vector.data(), weighted.data());
      double square = 0;
      for (std::size_t i = 0; i < weighted.size(); ++i)
        square += vector[i] * weighted[i];
      square = problem.layout.sum(square);
      for (double &value : vector)
        value /= std::sqrt(square);
    }
  } // namespace

  Eigenpairs nearest_eigenpairs(const ShiftedEigenproblem &problem,
                                const unsigned int         n)
  {
    /**
     * Size up to which eigenproblems with many equal eigenvalues, e.g. of
     * mechanisms, are solved by dense matrices.
     * @tuned [unknowns] measured: these take some seconds
     */
    constexpr unsigned int most_dense = 1500;
    const bool are_few = problem.n_finite < 4 * n_krylov_directions(n);
    Eigenpairs found =
      are_few ? dense_eigenpairs(problem, n) : krylov_eigenpairs(problem, n);
    if (!are_few && !found.failure_reason.empty() &&
        problem.layout.n_global() <= most_dense)
      found = dense_eigenpairs(problem, n);
    std::sort(found.pairs.begin(),
              found.pairs.end(),
              [](const Eigenpair &one, const Eigenpair &other) {
                return one.value < other.value;
              });
    for (Eigenpair &pair : found.pairs)
      scale(problem, pair.vector);
    return found;
  }

  namespace
  {
    using Dense = dealii::LAPACKFullMatrix<double>;

    /**
     * Eigenpairs of a symmetric matrix by ascending eigenvalue, vectors as
     * columns.
     */
    struct SymmetricEigenpairs
    {
      explicit SymmetricEigenpairs(Dense &matrix)
        : values(matrix.m())
        , vectors(matrix.m())
      {
        // dsygv reduces the whole matrix; the bisection of dsyevx would halve
        // the digits of vectors of close eigenvalues.
        const unsigned int                  n = matrix.m();
        Dense                               identity(n);
        std::vector<dealii::Vector<double>> columns(n);
        for (unsigned int i = 0; i < n; ++i)
          {
            identity(i, i) = 1;
            columns[i].reinit(n);
          }
        matrix.compute_generalized_eigenvalues_symmetric(identity, columns);
        for (unsigned int j = 0; j < n; ++j)
          {
            values(j) = matrix.eigenvalue(j).real();
            for (unsigned int i = 0; i < n; ++i)
              vectors(i, j) = columns[j](i);
          }
      }

      dealii::Vector<double>     values;
      dealii::FullMatrix<double> vectors;
    };

    /** Dense matrix of the operator @p act, the same on all ranks. */
    template <class Action>
    Dense dense(const UnknownLayout &layout, const Action &act)
    {
      const unsigned int n = layout.n_global();
      Dense              matrix(n);
      for (unsigned int j = 0; j < n; ++j)
        {
          std::vector<double> unit(layout.n_owned(), 0.), column(n, 0.);
          const int           local = layout.local(j);
          if (layout.is_owned(local))
            unit[local] = 1;
          act(unit);
          for (unsigned int i = 0; i < unit.size(); ++i)
            column[layout.global(i)] = unit[i];
          column = layout.sum(column);
          for (unsigned int i = 0; i < n; ++i)
            matrix(i, j) = column[i];
        }
      return matrix;
    }

    void make_symmetric(Dense &matrix)
    {
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < i; ++j)
          matrix(i, j) = matrix(j, i) = (matrix(i, j) + matrix(j, i)) / 2;
    }

    /** Factor L of M = L L^T with as many columns as the rank of M. */
    dealii::FullMatrix<double> root(Dense mass)
    {
      constexpr double          round_off = 1e-14;
      const SymmetricEigenpairs mass_pairs(mass);
      const unsigned int        n     = mass_pairs.values.size();
      const double              least = round_off * mass_pairs.values(n - 1);
      unsigned int              first = 0;
      while (first < n && !(mass_pairs.values(first) > least))
        ++first;
      dealii::FullMatrix<double> factor(n, n - first);
      for (unsigned int j = first; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          factor(i, j - first) =
            mass_pairs.vectors(i, j) * std::sqrt(mass_pairs.values(j));
      return factor;
    }

    std::vector<double> owned(const UnknownLayout          &layout,
                              const dealii::Vector<double> &all)
    {
      std::vector<double> mine(layout.n_owned());
      for (unsigned int i = 0; i < mine.size(); ++i)
        mine[i] = all(layout.global(i));
      return mine;
    }
  } // namespace

  namespace
  {
    /** Global column from the owned rows of all ranks. */
    std::vector<double> gather_all(const UnknownLayout       &layout,
                                   const std::vector<double> &mine)
    {
      std::vector<double> all(layout.n_global(), 0.);
      for (unsigned int i = 0; i < mine.size(); ++i)
        all[layout.global(i)] = mine[i];
      return layout.sum(all);
    }

    /** Product A F; @p act multiplies owned rows of a column by A. */
    template <class Action>
    dealii::FullMatrix<double> product(const UnknownLayout              &layout,
                                       const dealii::FullMatrix<double> &factor,
                                       const Action                     &act)
    {
      dealii::FullMatrix<double> result(factor.m(), factor.n());
      for (unsigned int j = 0; j < factor.n(); ++j)
        {
          dealii::Vector<double> column(factor.m());
          for (unsigned int i = 0; i < column.size(); ++i)
            column(i) = factor(i, j);
          std::vector<double> x = owned(layout, column);
          act(x);
          const std::vector<double> all = gather_all(layout, x);
          for (unsigned int i = 0; i < all.size(); ++i)
            result(i, j) = all[i];
        }
      return result;
    }

    /** Product F^T B, which is symmetric. */
    Dense projection(const dealii::FullMatrix<double> &factor,
                     const dealii::FullMatrix<double> &product)
    {
      const unsigned int n = factor.n();
      Dense              projected(n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            double sum = 0;
            for (unsigned int k = 0; k < factor.m(); ++k)
              sum += factor(k, i) * product(k, j);
            projected(i, j) = sum;
          }
      make_symmetric(projected);
      return projected;
    }

    /**
     * Indices of the @p n largest values by size, or with @p only_positive of
     * the positive ones, without those at round-off.
     */
    std::vector<unsigned int> largest(const dealii::Vector<double> &values,
                                      const unsigned int            n,
                                      const bool only_positive)
    {
      // theta is zero for motions that constraints prevent.
      constexpr double          round_off = 1e-13;
      const double              least     = round_off * values.linfty_norm();
      std::vector<unsigned int> order;
      for (unsigned int j = 0; j < values.size(); ++j)
        if ((only_positive ? values(j) : std::abs(values(j))) > least)
          order.push_back(j);
      std::sort(order.begin(),
                order.end(),
                [&](const unsigned int i, const unsigned int j) {
                  return std::abs(values(i)) > std::abs(values(j));
                });
      order.resize(std::min<std::size_t>(order.size(), n));
      return order;
    }

    /**
     * Eigenpairs from those of theta y = F^T (...) F y, theta = 1 / (lambda -
     * sigma).
     * @param shapes matrix that maps y to the vector of the pair
     * @param per_theta whether to divide the result by theta
     */
    Eigenpairs pairs_from(const ShiftedEigenproblem        &problem,
                          const SymmetricEigenpairs        &inverse,
                          const dealii::FullMatrix<double> &shapes,
                          const bool                        per_theta,
                          const unsigned int                n)
    {
      Eigenpairs found;
      for (const unsigned int j :
           largest(inverse.values, n, problem.only_above))
        {
          const double           theta = inverse.values(j);
          dealii::Vector<double> shape(shapes.m()), y(shapes.n());
          for (unsigned int i = 0; i < y.size(); ++i)
            y(i) = inverse.vectors(i, j) / (per_theta ? theta : 1.);
          shapes.vmult(shape, y);
          found.pairs.push_back(
            {problem.shift + 1 / theta, owned(problem.layout, shape)});
        }
      return found;
    }

    /** L^T (K - sigma M)^-1 L y = theta y with M = L L^T and y = L^T x. */
    Eigenpairs by_root_of_mass(const ShiftedEigenproblem &problem,
                               const unsigned int         n,
                               bool                      &solved)
    {
      Dense mass = dense(problem.layout, [&](std::vector<double> &x) {
        const std::vector<double> unit = x;
        problem.multiply_mass(unit.data(), x.data());
      });
      make_symmetric(mass);
      const dealii::FullMatrix<double> factor = root(mass),
                                       solutions =
                                         product(problem.layout,
                                                 factor,
                                                 [&](std::vector<double> &x) {
                                                   solved =
                                                     problem.solve(x.data()) &&
                                                     solved;
                                                 });
      Dense                     projected = projection(factor, solutions);
      const SymmetricEigenpairs inverse(projected);
      // x = (K - sigma M)^-1 L y / theta
      return pairs_from(problem, inverse, solutions, /*per_theta=*/true, n);
    }

    /** F^T M F y = theta y with (K - sigma M)^-1 = F F^T and x = F y. */
    Eigenpairs by_root_of_inverse(const ShiftedEigenproblem &problem,
                                  const unsigned int         n,
                                  bool                      &solved)
    {
      Dense inverse = dense(problem.layout, [&](std::vector<double> &x) {
        solved = problem.solve(x.data()) && solved;
      });
      make_symmetric(inverse);
      const dealii::FullMatrix<double>
        factor = root(inverse),
        images = product(problem.layout, factor, [&](std::vector<double> &x) {
          const std::vector<double> column = x;
          problem.multiply_mass(column.data(), x.data());
        });
      Dense                     projected = projection(factor, images);
      const SymmetricEigenpairs values(projected);
      return pairs_from(problem, values, factor, /*per_theta=*/false, n);
    }
  } // namespace

  Eigenpairs dense_eigenpairs(const ShiftedEigenproblem &problem,
                              const unsigned int         n)
  {
    bool       solved = true;
    Eigenpairs found  = problem.multiply_definite
       ? by_root_of_inverse(problem, n, solved)
       : by_root_of_mass(problem, n, solved);
    if (!solved)
      return {{}, "a linear solution failed"};
    return found;
  }

  std::vector<double>
  symmetric_eigenvalues(const dealii::FullMatrix<double> &matrix)
  {
    const int           n = matrix.m();
    std::vector<double> entries, values(n), work(std::max(1, 40 * n));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        entries.push_back(matrix(i, j));
    int length = work.size(), info = 0;
    dealii::syev("N",
                 "U",
                 &n,
                 entries.data(),
                 &n,
                 values.data(),
                 work.data(),
                 &length,
                 &info);
    if (info != 0)
      values.assign(n, std::numeric_limits<double>::quiet_NaN());
    return values;
  }

  std::vector<ComplexEigenpair> general_eigenpairs(std::vector<double> matrix,
                                                   const int           n)
  {
    std::vector<double> real(n), imaginary(n), vectors(std::size_t(n) * n),
      work(8 * n);
    double none   = 0;
    int    length = work.size(), one = 1, info = 0;
    dealii::geev("N",
                 "V",
                 &n,
                 matrix.data(),
                 &n,
                 real.data(),
                 imaginary.data(),
                 &none,
                 &one,
                 vectors.data(),
                 &n,
                 work.data(),
                 &length,
                 &info);
    std::vector<ComplexEigenpair> pairs;
    for (int j = 0; j < n && info == 0; ++j)
      {
        // Conjugate pairs are adjacent, the one above the real axis first.
        if (imaginary[j] < 0)
          continue;
        ComplexEigenpair pair{{real[j], imaginary[j]},
                              std::vector<std::complex<double>>(n)};
        for (int i = 0; i < n; ++i)
          pair.vector[i] = {vectors[std::size_t(j) * n + i],
                            imaginary[j] > 0
                              ? vectors[std::size_t(j + 1) * n + i]
                              : 0.};
        pairs.push_back(std::move(pair));
      }
    return pairs;
  }
} // namespace auxfem
