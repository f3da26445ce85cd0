#include <auxfem/algebra/inner_elimination.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** A pivot below this part of the terms it is the sum of is round-off. */
    constexpr double round_off = 16 * std::numeric_limits<double>::epsilon();

    template <int n_inner, int n_ends>
    class EliminationOfSize : public InnerElimination
    {
    public:
      std::size_t factor_size(const Symmetry symmetry) const override
      {
        // A row exchange is kept as a number beside each row of L U.
        return symmetry == Symmetry::none ? n_inner * (n_inner + 1)
                                          : n_inner * (n_inner + 1) / 2;
      }

      EliminationResult eliminate(const double  *block,
                                  const double  *added,
                                  const Symmetry symmetry,
                                  double        *factors,
                                  double        *condensed) const override
      {
        double inner[n_inner][n_inner], to_ends[n_inner][n_ends];
        gather(block, added, symmetry == Symmetry::enforced, inner, to_ends);
        if (symmetry != Symmetry::none)
          return eliminate_symmetric(block,
                                     symmetry == Symmetry::enforced,
                                     inner,
                                     to_ends,
                                     factors,
                                     condensed);
        return eliminate_unsymmetric(block, inner, to_ends, factors, condensed);
      }

      void reduce(const double               *factors,
                  const EliminationCouplings &couplings,
                  const Symmetry              symmetry,
                  const double               *of_inner,
                  double                     *of_ends) const override
      {
        double inner[n_inner];
        std::copy(of_inner, of_inner + n_inner, inner);
        solve(factors, symmetry, inner);
        const double part = symmetry == Symmetry::enforced ? 0.5 : 1.;
        if (symmetry != Symmetry::none)
          for (int i = 0; i < n_inner; ++i)
            {
              const double *const row =
                couplings.inner_ends + i * couplings.inner_ends_stride;
              for (int e = 0; e < n_ends; ++e)
                of_ends[e] -= part * row[e] * inner[i];
            }
        if (symmetry != Symmetry::given)
          for (int e = 0; e < n_ends; ++e)
            {
              const double *const row =
                couplings.ends_inner + e * couplings.ends_inner_stride;
              double sum = 0;
              for (int i = 0; i < n_inner; ++i)
                sum += row[i] * inner[i];
              of_ends[e] -= part * sum;
            }
      }

      void expand(const double               *factors,
                  const EliminationCouplings &couplings,
                  const Symmetry              symmetry,
                  const double               *of_ends,
                  double                     *of_inner) const override
      {
        const double part = symmetry == Symmetry::enforced ? 0.5 : 1.;
        for (int i = 0; i < n_inner; ++i)
          {
            const double *const row =
              couplings.inner_ends + i * couplings.inner_ends_stride;
            double sum = 0;
            for (int e = 0; e < n_ends; ++e)
              sum += row[e] * of_ends[e];
            of_inner[i] -= part * sum;
          }
        if (symmetry == Symmetry::enforced)
          for (int e = 0; e < n_ends; ++e)
            {
              const double *const row =
                couplings.ends_inner + e * couplings.ends_inner_stride;
              for (int i = 0; i < n_inner; ++i)
                of_inner[i] -= part * row[i] * of_ends[e];
            }
        solve(factors, symmetry, of_inner);
      }

    private:
      static constexpr int n = n_inner + n_ends;

      using Inner  = double[n_inner][n_inner];
      using ToEnds = double[n_inner][n_ends];

      /** A_II and A_IE. */
      static void gather(const double *block,
                         const double *added,
                         const bool    enforces_symmetry,
                         Inner         inner,
                         ToEnds        to_ends)
      {
        for (int i = 0; i < n_inner; ++i)
          {
            const double *const row = block + (n_ends + i) * n;
            std::copy(row, row + n_ends, to_ends[i]);
            std::copy(row + n_ends, row + n, inner[i]);
          }
        if (enforces_symmetry)
          for (int i = 0; i < n_inner; ++i)
            {
              for (int e = 0; e < n_ends; ++e)
                to_ends[i][e] = (to_ends[i][e] + block[e * n + n_ends + i]) / 2;
              for (int j = 0; j < i; ++j)
                inner[i][j] = inner[j][i] = (inner[i][j] + inner[j][i]) / 2;
            }
        if (added != nullptr)
          for (int i = 0; i < n_inner; ++i)
            inner[i][i] += added[i];
      }

      /** Rows of L^T, each behind the inverse of its pivot. */
      static EliminationResult eliminate_symmetric(const double *block,
                                                   const bool enforces_symmetry,
                                                   Inner      inner,
                                                   ToEnds     to_ends,
                                                   double    *factors,
                                                   double    *condensed)
      {
        for (int e = 0; e < n_ends; ++e)
          for (int p = e; p < n_ends; ++p)
            condensed[e * n_ends + p] = enforces_symmetry
              ? (block[e * n + p] + block[p * n + e]) / 2
              : block[e * n + p];

        EliminationResult result;
        double            terms[n_inner];
        for (int i = 0; i < n_inner; ++i)
          terms[i] = std::abs(inner[i][i]);
        for (int j = 0; j < n_inner; ++j)
          {
            const double pivot = inner[j][j];
            // Written so that a pivot that is no number is not regular.
            if (!(std::abs(pivot) > round_off * terms[j]))
              {
                result.is_regular = false;
                return result;
              }
            if (pivot < 0)
              ++result.n_negative;
            const double inverse = 1 / pivot;
            *factors++           = inverse;
            for (int i = j + 1; i < n_inner; ++i)
              {
                const double factor = inner[j][i] * inverse;
                *factors++          = factor;
                terms[i] += std::abs(factor * inner[j][i]);
                for (int p = i; p < n_inner; ++p)
                  inner[i][p] -= factor * inner[j][p];
                for (int e = 0; e < n_ends; ++e)
                  to_ends[i][e] -= factor * to_ends[j][e];
              }
            for (int e = 0; e < n_ends; ++e)
              {
                const double factor = to_ends[j][e] * inverse;
                for (int p = e; p < n_ends; ++p)
                  condensed[e * n_ends + p] -= factor * to_ends[j][p];
              }
          }
        for (int e = 0; e < n_ends; ++e)
          for (int p = 0; p < e; ++p)
            condensed[e * n_ends + p] = condensed[p * n_ends + e];
        return result;
      }

      /**
       * Rows of L and U with the inverse of the pivots on the diagonal, then
       * for each the row that it was exchanged with. The row is taken whose
       * pivot is largest in units of the original diagonal.
       */
      static EliminationResult eliminate_unsymmetric(const double *block,
                                                     Inner         inner,
                                                     ToEnds        to_ends,
                                                     double       *factors,
                                                     double       *condensed)
      {
        double units[n_inner], row_units[n_inner];
        for (int i = 0; i < n_inner; ++i)
          {
            units[i] = std::sqrt(std::abs(inner[i][i]));
            if (units[i] == 0)
              units[i] = std::sqrt(
                std::abs(*std::max_element(inner[i],
                                           inner[i] + n_inner,
                                           [](const double a, const double b) {
                                             return std::abs(a) < std::abs(b);
                                           })));
            row_units[i] = units[i];
          }
        double *const exchanged = factors + n_inner * n_inner;
        for (int j = 0; j < n_inner; ++j)
          {
            int    pivot_row = j;
            double largest   = -1;
            for (int i = j; i < n_inner; ++i)
              {
                const double size = std::abs(inner[i][j]) / row_units[i];
                if (size > largest)
                  {
                    largest   = size;
                    pivot_row = i;
                  }
              }
            // Written so that a pivot that is no number is not regular.
            if (!(largest > round_off * units[j]))
              {
                EliminationResult result;
                result.is_regular = false;
                return result;
              }
            exchanged[j] = pivot_row;
            std::swap_ranges(inner[j], inner[j] + n_inner, inner[pivot_row]);
            std::swap_ranges(to_ends[j],
                             to_ends[j] + n_ends,
                             to_ends[pivot_row]);
            std::swap(row_units[j], row_units[pivot_row]);
            inner[j][j] = 1 / inner[j][j];
            for (int i = j + 1; i < n_inner; ++i)
              {
                const double factor = inner[i][j] *= inner[j][j];
                for (int p = j + 1; p < n_inner; ++p)
                  inner[i][p] -= factor * inner[j][p];
                for (int e = 0; e < n_ends; ++e)
                  to_ends[i][e] -= factor * to_ends[j][e];
              }
          }
        std::copy(&inner[0][0], &inner[0][0] + n_inner * n_inner, factors);

        for (int e = 0; e < n_ends; ++e)
          {
            double        row[n_inner];
            double *const of_end = condensed + e * n_ends;
            std::copy(block + e * n, block + e * n + n_ends, of_end);
            std::copy(block + e * n + n_ends, block + (e + 1) * n, row);
            for (int j = 0; j < n_inner; ++j)
              {
                row[j] *= inner[j][j];
                for (int p = j + 1; p < n_inner; ++p)
                  row[p] -= row[j] * inner[j][p];
                for (int p = 0; p < n_ends; ++p)
                  of_end[p] -= row[j] * to_ends[j][p];
              }
          }
        return {};
      }

      static void
      solve(const double *factors, const Symmetry symmetry, double *x)
      {
        if (symmetry == Symmetry::none)
          solve_unsymmetric(factors, x);
        else
          solve_symmetric(factors, x);
      }

      static void solve_symmetric(const double *factors, double *x)
      {
        for (int j = 0; j < n_inner; ++j)
          {
            const double *const row = factors + row_begin(j);
            for (int p = j + 1; p < n_inner; ++p)
              x[p] -= row[p - j] * x[j];
            x[j] *= row[0];
          }
        for (int j = n_inner - 1; j >= 0; --j)
          {
            const double *const row = factors + row_begin(j);
            for (int p = j + 1; p < n_inner; ++p)
              x[j] -= row[p - j] * x[p];
          }
      }

      /** Index of row j of L^T in the factors. */
      static constexpr int row_begin(const int j)
      {
        return j * n_inner - j * (j - 1) / 2;
      }

      static void solve_unsymmetric(const double *factors, double *x)
      {
        const double *const exchanged = factors + n_inner * n_inner;
        for (int j = 0; j < n_inner; ++j)
          std::swap(x[j], x[static_cast<int>(exchanged[j])]);
        for (int i = 0; i < n_inner; ++i)
          for (int j = 0; j < i; ++j)
            x[i] -= factors[i * n_inner + j] * x[j];
        for (int i = n_inner - 1; i >= 0; --i)
          {
            for (int j = i + 1; j < n_inner; ++j)
              x[i] -= factors[i * n_inner + j] * x[j];
            x[i] *= factors[i * n_inner + i];
          }
      }
    };

    template <int n_inner, int n_ends>
    const InnerElimination *if_of(const EliminationSizes sizes)
    {
      static const EliminationOfSize<n_inner, n_ends> elimination;
      return sizes.n_inner == n_inner && sizes.n_ends == n_ends ? &elimination
                                                                : nullptr;
    }
  } // namespace

  const InnerElimination *inner_elimination(const EliminationSizes sizes)
  {
    for (const auto candidate : {if_of<3, 6>,
                                 if_of<6, 6>,
                                 if_of<9, 6>,
                                 if_of<12, 6>,
                                 if_of<15, 6>,
                                 if_of<6, 12>,
                                 if_of<12, 12>,
                                 if_of<18, 12>})
      if (const InnerElimination *const elimination = candidate(sizes))
        return elimination;
    return nullptr;
  }
} // namespace auxfem
