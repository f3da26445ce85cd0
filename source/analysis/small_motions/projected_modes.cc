#include <auxfem/algebra/dense_block.h>
#include <auxfem/analysis/small_motions/projected_modes.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Entry   = std::complex<double>;
    using Entries = std::vector<Entry>;

    /** A square complex matrix by LU, as the real one of twice the size. */
    class ComplexFactors
    {
    public:
      /** @param a n rows of n entries */
      ComplexFactors(const Entries &a, const unsigned int n)
        : n(n)
        , factors(4 * std::size_t(n) * n)
        , exchanges(2 * n)
      {
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            {
              const Entry entry                = a[i * n + j];
              factors[2 * n * i + j]           = entry.real();
              factors[2 * n * i + n + j]       = -entry.imag();
              factors[2 * n * (n + i) + j]     = entry.imag();
              factors[2 * n * (n + i) + n + j] = entry.real();
            }
        regular =
          factorize_general_block(factors.data(), 2 * n, exchanges.data(), 0.);
      }

      bool is_regular() const
      {
        return regular;
      }

      /** @p b, n rows of m entries, becomes the solution. */
      void solve(Entries &b, const unsigned int m) const
      {
        std::vector<double> both(2 * b.size());
        for (std::size_t i = 0; i < b.size(); ++i)
          {
            both[i]            = b[i].real();
            both[b.size() + i] = b[i].imag();
          }
        solve_with_block(factors.data(),
                         exchanges.data(),
                         2 * n,
                         both.data(),
                         m);
        for (std::size_t i = 0; i < b.size(); ++i)
          b[i] = {both[i], both[b.size() + i]};
      }

    private:
      const unsigned int  n;
      std::vector<double> factors;
      std::vector<int>    exchanges;
      bool                regular;
    };

    /** V^T A(s) V and its roots. */
    class Projection
    {
    public:
      Projection(DynamicStiffness               &stiffness,
                 const UnknownLayout            &layout,
                 const std::vector<NaturalMode> &modes)
        : stiffness(stiffness)
        , layout(layout)
        , modes(modes)
        , n(modes.size())
      {}

      /** One pair of guesses for each mode that swings. They are not conjugate:
       * two may so become real. Those of equal frequencies differ. */
      std::vector<Entry> guesses() const
      {
        constexpr double   decay = 0.02, golden_ratio = 0.6180339887498949;
        std::vector<Entry> all;
        for (unsigned int i = 0; i < n; ++i)
          if (const double omega = modes[i].angular_frequency(); omega > 0)
            {
              const double spread =
                decay * (1 + std::fmod(i * golden_ratio, 1));
              all.push_back(omega * Entry(-spread, 1.));
              all.push_back(omega * Entry(-2 * spread, -1.));
            }
        return all;
      }

      /**
       * One sweep over @p roots.
       * @param settled of which no more is asked; what settles is entered
       * @return whether all have
       */
      bool sweep(std::vector<Entry> &roots, std::vector<char> &settled)
      {
        constexpr double small = 1e-8;
        bool             all   = true;
        for (std::size_t i = 0; i < roots.size(); ++i)
          if (!settled[i])
            {
              const Entry change = step(roots, i);
              roots[i] -= change;
              settled[i] = std::abs(change) <= small * std::abs(roots[i]);
              all        = all && settled[i];
            }
        return all;
      }

      /** The parts of the mode at the root @p s. */
      Entries parts(const Entry s)
      {
        constexpr unsigned int n_iterations = 3;
        const ComplexFactors   factors(at(s * (1. + 1e-9)), n);
        Entries                y(n, Entry(1.));
        // Without symmetry, which a mode may lack.
        for (unsigned int i = 0; i < n; ++i)
          y[i] += 0.1 * (i % 7);
        for (unsigned int i = 0; i < n_iterations && factors.is_regular(); ++i)
          {
            factors.solve(y, 1);
            double length = 0;
            for (const Entry &part : y)
              length += std::norm(part);
            for (Entry &part : y)
              part /= std::sqrt(length);
          }
        return y;
      }

    private:
      Entries at(const Entry s)
      {
        stiffness.set(s);
        const unsigned int  n_owned = layout.n_owned();
        std::vector<double> mine(2 * std::size_t(n) * n),
          x(2 * std::size_t(n_owned)), product(x.size());
        for (unsigned int j = 0; j < n; ++j)
          {
            std::fill(x.begin(), x.end(), 0.);
            std::copy_n(modes[j].shape.begin(), n_owned, x.begin());
            stiffness.multiply(x.data(), product.data());
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int k = 0; k < n_owned; ++k)
                {
                  mine[2 * (i * n + j)] += modes[i].shape[k] * product[k];
                  mine[2 * (i * n + j) + 1] +=
                    modes[i].shape[k] * product[n_owned + k];
                }
          }
        const std::vector<double> sums = layout.sum(mine);
        Entries                   matrix(std::size_t(n) * n);
        for (std::size_t i = 0; i < matrix.size(); ++i)
          matrix[i] = {sums[2 * i], sums[2 * i + 1]};
        return matrix;
      }

      /** By which root @p i errs: 1 / (d'/d - sum over others of 1 / (s - s_j))
       * with the determinant d, d'/d = tr(A^-1 A'). */
      Entry step(const std::vector<Entry> &roots, const std::size_t i)
      {
        constexpr double     step_of_difference = 1e-6;
        const Entry          s = roots[i], step = step_of_difference * s;
        const Entries        here   = at(s);
        Entries              change = at(s + step);
        const ComplexFactors factors(here, n);
        if (!factors.is_regular())
          return 0.;
        for (std::size_t k = 0; k < change.size(); ++k)
          change[k] = (change[k] - here[k]) / step;
        factors.solve(change, n);
        Entry slope = 0;
        for (unsigned int k = 0; k < n; ++k)
          slope += change[k * n + k];
        for (std::size_t j = 0; j < roots.size(); ++j)
          if (j != i && roots[j] != s)
            slope -= 1. / (s - roots[j]);
        return 1. / slope;
      }

      DynamicStiffness               &stiffness;
      const UnknownLayout            &layout;
      const std::vector<NaturalMode> &modes;
      const unsigned int              n;
    };
  } // namespace

  std::vector<ProjectedMode>
  projected_modes(DynamicStiffness               &stiffness,
                  const UnknownLayout            &layout,
                  const std::vector<NaturalMode> &modes)
  {
    constexpr unsigned int most_sweeps = 40;
    constexpr double       no_swing    = 1e-6;
    Projection             projection(stiffness, layout, modes);
    std::vector<Entry>     roots = projection.guesses();
    std::vector<char>      settled(roots.size(), false);
    for (unsigned int i = 0; i < most_sweeps; ++i)
      if (projection.sweep(roots, settled))
        break;
    std::vector<ProjectedMode> found;
    for (std::size_t i = 0; i < roots.size(); ++i)
      if (settled[i] && roots[i].imag() > no_swing * std::abs(roots[i]))
        found.push_back({roots[i], projection.parts(roots[i])});
    std::sort(found.begin(),
              found.end(),
              [](const ProjectedMode &one, const ProjectedMode &other) {
                return std::abs(one.s) < std::abs(other.s);
              });
    return found;
  }
} // namespace auxfem
