#include <auxfem/algebra/eigen_solver_dense.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Dense = dealii::LAPACKFullMatrix<double>;

    /** Eigenvalues of a symmetric matrix by size, with vectors as columns. */
    struct SymmetricEigenpairs
    {
      explicit SymmetricEigenpairs(Dense &matrix)
        : values(matrix.m())
        , vectors(matrix.m())
      {
        // By rotations of the whole matrix (dsygv): bisection (dsyevx) would
        // leave vectors of near values with half the digits.
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

    /** Columns of @p act on unit vectors of all ranks, known on all. */
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

    /** L of M = L L^T, as many columns as M has rank. */
    dealii::FullMatrix<double> root(Dense mass)
    {
      constexpr double          round_off = 1e-14;
      const SymmetricEigenpairs of_mass(mass);
      const unsigned int        n     = of_mass.values.size();
      const double              least = round_off * of_mass.values(n - 1);
      unsigned int              first = 0;
      while (first < n && !(of_mass.values(first) > least))
        ++first;
      dealii::FullMatrix<double> factor(n, n - first);
      for (unsigned int j = first; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          factor(i, j - first) =
            of_mass.vectors(i, j) * std::sqrt(of_mass.values(j));
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
    /** A column on the rows of all ranks from what they own. */
    std::vector<double> of_all(const UnknownLayout       &layout,
                               const std::vector<double> &mine)
    {
      std::vector<double> all(layout.n_global(), 0.);
      for (unsigned int i = 0; i < mine.size(); ++i)
        all[layout.global(i)] = mine[i];
      return layout.sum(all);
    }

    /** A F; @p act on owned rows of a column. */
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
          const std::vector<double> all = of_all(layout, x);
          for (unsigned int i = 0; i < all.size(); ++i)
            result(i, j) = all[i];
        }
      return result;
    }

    /** F^T B for symmetric F^T B. */
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

    /** Numbers of the @p n largest values, by size or, with @p only_positive,
     * among the positive ones; not those that are round-off. */
    std::vector<unsigned int> largest(const dealii::Vector<double> &values,
                                      const unsigned int            n,
                                      const bool only_positive)
    {
      // Of motions that constraints forbid theta is zero.
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
     * Pairs from those of theta y = F^T (...) F y, theta = 1 / (lambda -
     * sigma).
     * @param shapes of which a pair's y makes its vector
     * @param per_theta whether that is still to be divided by theta
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
} // namespace auxfem
