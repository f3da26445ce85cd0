#include <auxfem/algebra/eigen_solver.h>
#include <auxfem/analysis/infinite_lattice/bloch_waves.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <set>

namespace auxfem
{
  namespace
  {
    /** @p basis^T @p matrix @p basis. */
    dealii::FullMatrix<double>
    projected(const dealii::FullMatrix<double> &matrix,
              const dealii::FullMatrix<double> &basis)
    {
      dealii::FullMatrix<double> images(basis.m(), basis.n()),
        product(basis.n(), basis.n());
      matrix.mmult(images, basis);
      basis.Tmmult(product, images);
      return product;
    }
  } // namespace

  dealii::FullMatrix<double>
  BlochWaves::damped_basis(const WavePhases &phases, const unsigned int n) const
  {
    // Each wave is there twice, as a vector and i times it.
    const RitzPairs    undamped = quotients(phases, 4 * n + 20);
    const unsigned int n_period = mass.size(),
                       n_waves  = undamped.coefficients.n();
    std::set<unsigned int> damped;
    for (const unsigned int u : damping.unknowns())
      damped.insert(u);
    for (const auto &[time, matrix] : relaxing)
      for (const unsigned int u : matrix.unknowns())
        damped.insert(u);
    // Damping everywhere, as by struts, hardly couples high waves to low ones.
    const bool is_local = damped.size() < n_period / 2;
    if (!is_local)
      damped.clear();
    const auto                 shifted_now = shifted.at(phases);
    dealii::FullMatrix<double> vectors(2 * n_period,
                                       n_waves + 2 * damped.size());
    for (unsigned int i = 0; i < 2 * n_period; ++i)
      for (unsigned int j = 0; j < n_waves; ++j)
        vectors(i, j) = undamped.coefficients(i, j);
    if (!damped.empty())
      {
        dealii::FullMatrix<double> flexibility = shifted_now;
        flexibility.gauss_jordan();
        unsigned int column = n_waves;
        for (const unsigned int u : damped)
          for (const unsigned int row : {u, n_period + u})
            {
              // Residual vectors are as long as waves, in the norm of energy.
              const double size = std::sqrt(flexibility(row, row));
              for (unsigned int i = 0; i < 2 * n_period; ++i)
                vectors(i, column) = flexibility(i, row) / size;
              ++column;
            }
      }
    const RitzPairs combined = ritz_pairs(projected(mass.at(phases), vectors),
                                          projected(shifted_now, vectors));
    dealii::FullMatrix<double> basis(2 * n_period, combined.values.size());
    vectors.mmult(basis, combined.coefficients);
    const auto stiffnesses = projected(shifted_now, basis);
    for (unsigned int j = 0; j < basis.n(); ++j)
      for (unsigned int i = 0; i < basis.m(); ++i)
        basis(i, j) /= std::sqrt(stiffnesses(j, j));
    return basis;
  }

  std::vector<DampedWave> BlochWaves::damped_waves(const WavePhases  &phases,
                                                   const unsigned int n) const
  {
    const auto basis     = damped_basis(phases, n);
    const auto masses    = projected(mass.at(phases), basis),
               C         = projected(damping.at(phases), basis);
    const unsigned int m = basis.n(), size = m * (2 + relaxing.size());
    // d/dt of motions x, velocities v, and extensions z of the springs of
    // Maxwell elements; columns of a square matrix.
    std::vector<double> matrix(std::size_t(size) * size, 0.);
    const auto          entry = [&](const unsigned int row,
                           const unsigned int column) -> double          &{
      return matrix[std::size_t(column) * size + row];
    };
    for (unsigned int i = 0; i < m; ++i)
      {
        entry(i, m + i) = 1;
        entry(m + i, i) = shift - 1 / masses(i, i);
        for (unsigned int j = 0; j < m; ++j)
          entry(m + i, m + j) = -C(i, j) / masses(i, i);
      }
    for (unsigned int r = 0; r < relaxing.size(); ++r)
      {
        const auto         E = projected(relaxing[r].second.at(phases), basis);
        const unsigned int first = m * (2 + r);
        for (unsigned int i = 0; i < m; ++i)
          {
            entry(first + i, m + i)     = 1;
            entry(first + i, first + i) = -1 / relaxing[r].first;
            for (unsigned int j = 0; j < m; ++j)
              entry(m + i, first + j) = -E(i, j) / masses(i, i);
          }
      }
    // Waves without stiffness stay so: their frequency is zero.
    std::vector<DampedWave> waves;
    for (const double frequency : frequencies(phases, n))
      if (frequency * frequency <= 1e-6 * shift)
        waves.push_back({0, 0});
    std::vector<std::complex<double>> roots;
    for (const ComplexEigenpair &pair : general_eigenpairs(matrix, size))
      if (pair.value.imag() > 0 && std::norm(pair.value) > 1e-3 * shift)
        roots.push_back(pair.value);
    std::sort(roots.begin(),
              roots.end(),
              [](const auto &one, const auto &other) {
                return one.imag() < other.imag();
              });
    for (std::size_t i = 0; i + 1 < roots.size() && waves.size() < n; i += 2)
      waves.push_back({roots[i].imag(), -roots[i].real()});
    return waves;
  }
} // namespace auxfem
