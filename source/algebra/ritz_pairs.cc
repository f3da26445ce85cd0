#include <auxfem/algebra/ritz_pairs.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace auxfem
{
  namespace
  {
    /** Cholesky factor of a matrix without linearly dependent rows. */
    struct IndependentRows
    {
      explicit IndependentRows(const dealii::FullMatrix<double> &matrix)
        : lower(matrix.m(), matrix.m())
      {
        constexpr double dependent = 1e-10;
        for (unsigned int i = 0; i < matrix.m(); ++i)
          {
            const unsigned int k         = rows.size();
            double             remainder = matrix(i, i);
            for (unsigned int c = 0; c < k; ++c)
              {
                double entry = matrix(i, rows[c]);
                for (unsigned int d = 0; d < c; ++d)
                  entry -= lower(k, d) * lower(c, d);
                lower(k, c) = entry / lower(c, c);
                remainder -= lower(k, c) * lower(k, c);
              }
            if (!(remainder > dependent * matrix(i, i)))
              continue;
            lower(k, k) = std::sqrt(remainder);
            rows.push_back(i);
          }
      }

      /** L^-1 S L^-T of the independent rows and columns. */
      dealii::LAPACKFullMatrix<double>
      reduced(const dealii::FullMatrix<double> &matrix) const
      {
        const unsigned int               m = rows.size();
        dealii::LAPACKFullMatrix<double> result(m);
        for (unsigned int i = 0; i < m; ++i)
          for (unsigned int j = 0; j < m; ++j)
            {
              double entry = matrix(rows[i], rows[j]);
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

      /**
       * Writes L^-T times column @p j of @p vectors to column @p to of @p
       * result, in the independent rows.
       */
      void expand(const dealii::FullMatrix<double> &vectors,
                  const unsigned int                j,
                  const unsigned int                to,
                  dealii::FullMatrix<double>       &result) const
      {
        for (unsigned int i = rows.size(); i-- > 0;)
          {
            double entry = vectors(i, j);
            for (unsigned int d = i + 1; d < rows.size(); ++d)
              entry -= lower(d, i) * result(rows[d], to);
            result(rows[i], to) = entry / lower(i, i);
          }
      }

      std::vector<unsigned int>  rows;
      dealii::FullMatrix<double> lower;
    };
  } // namespace

  RitzPairs ritz_pairs(const dealii::FullMatrix<double> &numerator,
                       const dealii::FullMatrix<double> &denominator)
  {
    const IndependentRows independent(denominator);
    const unsigned int    m = independent.rows.size();
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

  RitzPairs independent_pairs(const dealii::FullMatrix<double> &numerator,
                              const dealii::FullMatrix<double> &denominator,
                              const unsigned int                n)
  {
    const unsigned int               m = numerator.m();
    dealii::LAPACKFullMatrix<double> minus_numerator(m), copy(m);
    minus_numerator = numerator;
    // LAPACK ascends.
    minus_numerator *= -1;
    copy = denominator;
    std::vector<dealii::Vector<double>> vectors(n, dealii::Vector<double>(m));
    minus_numerator.compute_generalized_eigenvalues_symmetric(copy, vectors);
    RitzPairs pairs;
    for (unsigned int j = 0; j < m; ++j)
      pairs.values.push_back(-minus_numerator.eigenvalue(j).real());
    pairs.coefficients.reinit(m, n);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < m; ++i)
        pairs.coefficients(i, j) = vectors[j][i];
    return pairs;
  }

  std::vector<double> ritz_values(const dealii::FullMatrix<double> &numerator,
                                  const dealii::FullMatrix<double> &denominator)
  {
    return ritz_pairs(numerator, denominator).values;
  }
} // namespace auxfem
