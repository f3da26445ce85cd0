#include <auxfem/algebra/ritz_values.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  std::vector<double> ritz_values(const dealii::FullMatrix<double> &numerator,
                                  const dealii::FullMatrix<double> &denominator)
  {
    constexpr double          dependent = 1e-10;
    const unsigned int        n         = denominator.m();
    std::vector<unsigned int> kept;
    // Cholesky's method on unit lengths; vectors that depend on those before
    // are left out.
    dealii::FullMatrix<double> lower(n, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int k    = kept.size();
        double             rest = denominator(i, i);
        for (unsigned int c = 0; c < k; ++c)
          {
            double entry = denominator(i, kept[c]);
            for (unsigned int d = 0; d < c; ++d)
              entry -= lower(k, d) * lower(c, d);
            lower(k, c) = entry / lower(c, c);
            rest -= lower(k, c) * lower(k, c);
          }
        if (!(rest > dependent * denominator(i, i)))
          continue;
        lower(k, k) = std::sqrt(rest);
        kept.push_back(i);
      }
    // L^-1 S L^-T, row after row, then column after column.
    const unsigned int               m = kept.size();
    dealii::LAPACKFullMatrix<double> reduced(m);
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < m; ++j)
        {
          double entry = numerator(kept[i], kept[j]);
          for (unsigned int d = 0; d < i; ++d)
            entry -= lower(i, d) * reduced(d, j);
          reduced(i, j) = entry / lower(i, i);
        }
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < m; ++j)
        {
          double entry = reduced(i, j);
          for (unsigned int d = 0; d < j; ++d)
            entry -= lower(j, d) * reduced(i, d);
          reduced(i, j) = entry / lower(j, j);
        }
    std::vector<double> values;
    if (m == 0)
      return values;
    dealii::FullMatrix<double> vectors;
    dealii::Vector<double>     found;
    reduced.set_property(dealii::LAPACKSupport::symmetric);
    const double bound = std::max(1., reduced.frobenius_norm());
    reduced.compute_eigenvalues_symmetric(-2 * bound,
                                          2 * bound,
                                          0.,
                                          found,
                                          vectors);
    values.assign(found.begin(), found.end());
    std::sort(values.rbegin(), values.rend());
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
