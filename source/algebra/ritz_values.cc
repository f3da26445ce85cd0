#include <auxfem/algebra/ritz_values.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace auxfem
{
  namespace
  {
    /** Cholesky's factor of a matrix without the rows that depend on those
     * before. */
    struct IndependentRows
    {
      explicit IndependentRows(const dealii::FullMatrix<double> &matrix)
        : lower(matrix.m(), matrix.m())
      {
        constexpr double dependent = 1e-10;
        for (unsigned int i = 0; i < matrix.m(); ++i)
          {
            const unsigned int k    = kept.size();
            double             rest = matrix(i, i);
            for (unsigned int c = 0; c < k; ++c)
              {
                double entry = matrix(i, kept[c]);
                for (unsigned int d = 0; d < c; ++d)
                  entry -= lower(k, d) * lower(c, d);
                lower(k, c) = entry / lower(c, c);
                rest -= lower(k, c) * lower(k, c);
              }
            if (!(rest > dependent * matrix(i, i)))
              continue;
            lower(k, k) = std::sqrt(rest);
            kept.push_back(i);
          }
      }

      /** L^-1 S L^-T of the kept rows and columns, row after row, then column
       * after column. */
      dealii::LAPACKFullMatrix<double>
      reduced(const dealii::FullMatrix<double> &matrix) const
      {
        const unsigned int               m = kept.size();
        dealii::LAPACKFullMatrix<double> result(m);
        for (unsigned int i = 0; i < m; ++i)
          for (unsigned int j = 0; j < m; ++j)
            {
              double entry = matrix(kept[i], kept[j]);
              for (unsigned int d = 0; d < i; ++d)
                entry -= lower(i, d) * result(d, j);
              result(i, j) = entry / lower(i, i);
            }
        for (unsigned int i = 0; i < m; ++i)
          for (unsigned int j = 0; j < m; ++j)
            {
              double entry = result(i, j);
              for (unsigned int d = 0; d < j; ++d)
                entry -= lower(j, d) * result(i, d);
              result(i, j) = entry / lower(j, j);
            }
        return result;
      }

      /** L^-T of column @p j of @p vectors becomes column @p to of @p result,
       * in the rows that are kept. */
      void expand(const dealii::FullMatrix<double> &vectors,
                  const unsigned int                j,
                  const unsigned int                to,
                  dealii::FullMatrix<double>       &result) const
      {
        for (unsigned int i = kept.size(); i-- > 0;)
          {
            double entry = vectors(i, j);
            for (unsigned int d = i + 1; d < kept.size(); ++d)
              entry -= lower(d, i) * result(kept[d], to);
            result(kept[i], to) = entry / lower(i, i);
          }
      }

      std::vector<unsigned int>  kept;
      dealii::FullMatrix<double> lower;
    };
  } // namespace

  RitzPairs ritz_pairs(const dealii::FullMatrix<double> &numerator,
                       const dealii::FullMatrix<double> &denominator)
  {
    const IndependentRows independent(denominator);
    const unsigned int    m = independent.kept.size();
    RitzPairs             pairs;
    if (m == 0)
      return pairs;
    dealii::LAPACKFullMatrix<double> reduced = independent.reduced(numerator);
    dealii::FullMatrix<double>       vectors;
    dealii::Vector<double>           found;
    reduced.set_property(dealii::LAPACKSupport::symmetric);
    const double bound = std::max(1., reduced.frobenius_norm());
    reduced.compute_eigenvalues_symmetric(-2 * bound,
                                          2 * bound,
                                          0.,
                                          found,
                                          vectors);
    std::vector<unsigned int> order(found.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(),
              order.end(),
              [&found](const unsigned int one, const unsigned int other) {
                return found[one] > found[other];
              });
    pairs.coefficients.reinit(denominator.m(), order.size());
    for (unsigned int j = 0; j < order.size(); ++j)
      {
        pairs.values.push_back(found[order[j]]);
        independent.expand(vectors, order[j], j, pairs.coefficients);
      }
    return pairs;
  }

  std::vector<double> ritz_values(const dealii::FullMatrix<double> &numerator,
                                  const dealii::FullMatrix<double> &denominator)
  {
    return ritz_pairs(numerator, denominator).values;
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
        // Conjugate pairs come together, that above the real axis first.
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
