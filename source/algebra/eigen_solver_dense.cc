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

  Eigenpairs dense_eigenpairs(const ShiftedEigenproblem &problem,
                              const unsigned int         n)
  {
    const UnknownLayout &layout = problem.layout;
    bool                 solved = true;
    Dense                mass   = dense(layout, [&](std::vector<double> &x) {
      const std::vector<double> unit = x;
      problem.multiply_mass(unit.data(), x.data());
    });
    make_symmetric(mass);
    const dealii::FullMatrix<double> factor = root(mass);

    // L^T (K - sigma M)^-1 L y = theta y with y = L^T x.
    const unsigned int         rank = factor.n();
    dealii::FullMatrix<double> solutions(factor.m(), rank);
    for (unsigned int j = 0; j < rank; ++j)
      {
        dealii::Vector<double> column(factor.m());
        for (unsigned int i = 0; i < column.size(); ++i)
          column(i) = factor(i, j);
        std::vector<double> x = owned(layout, column);
        solved                = problem.solve(x.data()) && solved;
        std::vector<double> all(layout.n_global(), 0.);
        for (unsigned int i = 0; i < x.size(); ++i)
          all[layout.global(i)] = x[i];
        all = layout.sum(all);
        for (unsigned int i = 0; i < all.size(); ++i)
          solutions(i, j) = all[i];
      }
    Eigenpairs found;
    if (!solved)
      {
        found.why = "a linear solution failed";
        return found;
      }
    Dense projected(rank);
    for (unsigned int i = 0; i < rank; ++i)
      for (unsigned int j = 0; j < rank; ++j)
        {
          double sum = 0;
          for (unsigned int k = 0; k < factor.m(); ++k)
            sum += factor(k, i) * solutions(k, j);
          projected(i, j) = sum;
        }
    make_symmetric(projected);
    const SymmetricEigenpairs inverse(projected);

    // Of motions that constraints forbid theta is zero.
    constexpr double round_off = 1e-13;
    const double     least     = round_off *
      std::max(std::abs(inverse.values(0)), std::abs(inverse.values(rank - 1)));
    std::vector<unsigned int> order;
    for (unsigned int j = 0; j < rank; ++j)
      if (std::abs(inverse.values(j)) > least)
        order.push_back(j);
    std::sort(order.begin(),
              order.end(),
              [&](const unsigned int i, const unsigned int j) {
                return std::abs(inverse.values(i)) >
                  std::abs(inverse.values(j));
              });
    order.resize(std::min<std::size_t>(order.size(), n));
    for (const unsigned int j : order)
      {
        // x = (K - sigma M)^-1 L y / theta
        dealii::Vector<double> shape(factor.m()), y(rank);
        for (unsigned int i = 0; i < rank; ++i)
          y(i) = inverse.vectors(i, j) / inverse.values(j);
        solutions.vmult(shape, y);
        found.pairs.push_back(
          {problem.shift + 1 / inverse.values(j), owned(layout, shape)});
      }
    return found;
  }
} // namespace auxfem
