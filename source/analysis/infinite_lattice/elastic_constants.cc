#include <auxfem/algebra/ritz_pairs.h>
#include <auxfem/analysis/infinite_lattice/elastic_constants.h>
#include <auxfem/mathematics/rotation.h>
#include <auxfem/mathematics/voigt.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Matrix = dealii::FullMatrix<double>;

    /** The inverse of a symmetric matrix unless it is singular to
     * round-off. */
    std::optional<Matrix> inverse(const Matrix &matrix)
    {
      constexpr double   singular = 1e-13;
      const unsigned int n        = matrix.m();
      const RitzPairs    pairs =
        ritz_pairs(matrix, Matrix(dealii::IdentityMatrix(n)));
      if (!(pairs.values.back() > singular * pairs.values.front()))
        return std::nullopt;
      Matrix result(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int k = 0; k < n; ++k)
            result(i, j) += pairs.coefficients(i, k) *
              pairs.coefficients(j, k) / pairs.values[k];
      return result;
    }

    /** The isotropic stiffness nearest to @p C: that with its invariants. */
    Matrix nearest_isotropic(const Matrix &C, const unsigned int dimension)
    {
      const unsigned int n              = C.m();
      double             trace_of_means = 0, trace = 0; // C_iijj and C_ijij
      for (unsigned int i = 0; i < dimension; ++i)
        for (unsigned int j = 0; j < dimension; ++j)
          trace_of_means += C(i, j);
      for (unsigned int i = 0; i < n; ++i)
        trace += (i < dimension ? 1 : 2) * C(i, i);
      const double d    = dimension;
      const double bulk = trace_of_means / (d * d);
      // C_ijij = d K + (d - 1) (d + 2) G
      const double shear = (trace - d * bulk) / ((d - 1) * (d + 2));
      Matrix       isotropic(n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          if (i < dimension && j < dimension)
            isotropic(i, j) = bulk - 2 * shear / d + (i == j ? 2 * shear : 0);
          else if (i == j)
            isotropic(i, j) = shear;
      return isotropic;
    }

    double tensor_norm(const Matrix &C, const unsigned int dimension)
    {
      double sum = 0;
      for (unsigned int i = 0; i < C.m(); ++i)
        for (unsigned int j = 0; j < C.m(); ++j)
          sum += (i < dimension ? 1 : 2) * (j < dimension ? 1 : 2) * C(i, j) *
            C(i, j);
      return std::sqrt(sum);
    }
  } // namespace

  ElasticConstants::ElasticConstants(const Matrix &stiffness) : C(stiffness)
  {
    double difference = 0;
    for (unsigned int i = 0; i < C.m(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          difference = std::max(difference, std::abs(C(i, j) - C(j, i)));
          C(i, j) = C(j, i) = (C(i, j) + C(j, i)) / 2;
        }
    asymmetric_part = difference / C.linfty_norm();
    S               = inverse(C);
  }

  double ElasticConstants::compliance_along(const Direction &a,
                                            const Direction &b,
                                            const Direction &c,
                                            const Direction &d) const
  {
    // S_ijkl is the Voigt entry over 1, 2 or 4; both orders of axes count.
    double sum = 0;
    for (unsigned int i = 0; i < S->m(); ++i)
      for (unsigned int j = 0; j < S->m(); ++j)
        {
          const auto [p, q] = axes_of_component(i, dimension());
          const auto [r, s] = axes_of_component(j, dimension());
          const double first =
            p == q ? a[p] * b[p] : (a[p] * b[q] + a[q] * b[p]) / 2;
          const double second =
            r == s ? c[r] * d[r] : (c[r] * d[s] + c[s] * d[r]) / 2;
          sum += first * (*S)(i, j) * second;
        }
    return sum;
  }

  double ElasticConstants::youngs_modulus(const Direction &n) const
  {
    return 1 / compliance_along(n, n, n, n);
  }

  double ElasticConstants::poissons_ratio(const Direction &n,
                                          const Direction &m) const
  {
    return -compliance_along(n, n, m, m) / compliance_along(n, n, n, n);
  }

  double ElasticConstants::shear_modulus(const Direction &n,
                                         const Direction &m) const
  {
    return 1 / (4 * compliance_along(n, m, n, m));
  }

  template <class Form>
  std::array<double, 2> ElasticConstants::range_across(const Direction &n,
                                                       const Form &form) const
  {
    if (dimension() == 2)
      {
        const Direction m     = dealii::Point<3>(-n[1], n[0], 0);
        const double    value = form(m, m);
        return {{value, value}};
      }
    const SpaceTensor frame = section_frame(n, default_reference(n));
    Direction         a, b;
    for (unsigned int c = 0; c < 3; ++c)
      {
        a[c] = frame[c][1];
        b[c] = frame[c][2];
      }
    const double mean   = (form(a, a) + form(b, b)) / 2,
                 radius = std::hypot((form(a, a) - form(b, b)) / 2, form(a, b));
    return {{mean - radius, mean + radius}};
  }

  std::array<double, 2>
  ElasticConstants::poissons_ratios(const Direction &n) const
  {
    const double along = compliance_along(n, n, n, n);
    return range_across(n, [&](const Direction &a, const Direction &b) {
      return -compliance_along(n, n, a, b) / along;
    });
  }

  std::array<double, 2> ElasticConstants::shear_moduli(const Direction &n) const
  {
    const auto [least, most] =
      range_across(n, [&](const Direction &a, const Direction &b) {
        return 4 * compliance_along(n, a, n, b);
      });
    return {{1 / most, 1 / least}};
  }

  double ElasticConstants::bulk_modulus() const
  {
    double sum = 0;
    for (unsigned int i = 0; i < dimension(); ++i)
      for (unsigned int j = 0; j < dimension(); ++j)
        sum += (*S)(i, j);
    return 1 / sum;
  }

  double ElasticConstants::anisotropy() const
  {
    Matrix difference = nearest_isotropic(C, dimension());
    difference.add(-1., C);
    return tensor_norm(difference, dimension()) / tensor_norm(C, dimension());
  }
} // namespace auxfem
