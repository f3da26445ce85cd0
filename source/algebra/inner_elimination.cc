#include <auxfem/algebra/inner_elimination.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    template <int n_inner, int n_ends>
    class EliminationOfSize : public InnerElimination
    {
    public:
      std::size_t factor_size(const Symmetry symmetry) const override
      {
        return n_inner * n_inner +
          (symmetry == Symmetry::none ? 2 : 1) * n_inner * n_ends;
      }

      EliminationResult eliminate(const double  *block,
                                  const double  *added,
                                  const Symmetry symmetry,
                                  double        *factors,
                                  double        *condensed) const override
      {
        double whole[n][n];
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j)
            whole[i][j] = symmetry == Symmetry::enforced
              ? (block[i * n + j] + block[j * n + i]) / 2
              : block[i * n + j];
        if (added != nullptr)
          for (int i = 0; i < n_inner; ++i)
            whole[n_ends + i][n_ends + i] += added[i];

        Inner inner;
        Right right = {};
        for (int i = 0; i < n_inner; ++i)
          {
            const double *const row = whole[n_ends + i];
            std::copy(row, row + n_ends, right[i]);
            std::copy(row + n_ends, row + n, inner[i]);
            right[i][n_ends + i] = 1;
          }
        const EliminationResult result = symmetry == Symmetry::none
          ? eliminate_unsymmetric(inner, right)
          : eliminate_symmetric(inner, right);
        if (result.is_regular)
          {
            substitute(inner, right);
            condense(whole, right, condensed);
            store(whole, right, symmetry, factors);
          }
        return result;
      }

      void reduce(const double  *factors,
                  const Symmetry symmetry,
                  const int     *inner,
                  const double  *inner_values,
                  const int     *ends,
                  double        *end_values) const override
      {
        // Rows of (A_EI A_II^-1)^T, equal to those of A_II^-1 A_IE if A is
        // symmetric.
        const double *row = factors + n_inner * n_inner +
          (symmetry == Symmetry::none ? n_inner * n_ends : 0);
        double sums[n_ends] = {};
        for (int i = 0; i < n_inner; ++i, row += n_ends)
          {
            const double x = inner_values[inner[i]];
            for (int e = 0; e < n_ends; ++e)
              sums[e] += row[e] * x;
          }
        for (int e = 0; e < n_ends; ++e)
          end_values[ends[e]] -= sums[e];
      }

      void expand(const double *factors,
                  const int    *inner,
                  double       *inner_values,
                  const int    *ends,
                  const double *end_values) const override
      {
        double sums[n_inner] = {}, local_ends[n_ends];
        // By columns, so that the sums are independent.
        const double *column = factors;
        for (int j = 0; j < n_inner; ++j, column += n_inner)
          {
            const double x = inner_values[inner[j]];
            for (int i = 0; i < n_inner; ++i)
              sums[i] += column[i] * x;
          }
        for (int e = 0; e < n_ends; ++e)
          local_ends[e] = end_values[ends[e]];
        const double *row = factors + n_inner * n_inner;
        for (int i = 0; i < n_inner; ++i, row += n_ends)
          inner_values[inner[i]] = sums[i] - product(row, local_ends);
      }

    private:
      static constexpr int n = n_inner + n_ends;

      /** Three independent sums, which pipeline. */
      static double product(const double *row, const double (&x)[n_ends])
      {
        static_assert(n_ends % 3 == 0);
        double sums[3] = {};
        for (int e = 0; e < n_ends; e += 3)
          for (int k = 0; k < 3; ++k)
            sums[k] += row[e + k] * x[e + k];
        return sums[0] + sums[1] + sums[2];
      }

      using Inner = double[n_inner][n_inner];
      /** A_IE and the identity, replaced by A_II^-1 A_IE and A_II^-1. */
      using Right = double[n_inner][n];

      static void subtract_row(const double factor,
                               const int    from,
                               const int    row,
                               Inner        inner,
                               Right        right)
      {
        for (int p = from; p < n_inner; ++p)
          inner[row][p] -= factor * inner[from][p];
        for (int p = 0; p < n; ++p)
          right[row][p] -= factor * right[from][p];
      }

      /** Reduces to an upper triangle with pivots in the given order. */
      static EliminationResult eliminate_symmetric(Inner inner, Right right)
      {
        EliminationResult result;
        double            terms[n_inner];
        for (int i = 0; i < n_inner; ++i)
          terms[i] = std::abs(inner[i][i]);
        for (int j = 0; j < n_inner; ++j)
          {
            const double pivot = inner[j][j];
            // The negated comparison also rejects NaN.
            if (!(std::abs(pivot) > few_round_offs * terms[j]))
              {
                result.is_regular = false;
                return result;
              }
            if (pivot < 0)
              ++result.n_negative;
            for (int i = j + 1; i < n_inner; ++i)
              {
                const double factor = inner[j][i] / pivot;
                terms[i] += std::abs(factor * inner[j][i]);
                subtract_row(factor, j, i, inner, right);
              }
          }
        return result;
      }

      /**
       * Reduces to an upper triangle. The pivot row is that with the largest
       * pivot in units of the original diagonal.
       */
      static EliminationResult eliminate_unsymmetric(Inner inner, Right right)
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
        EliminationResult result;
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
            // The negated comparison also rejects NaN.
            if (!(largest > few_round_offs * units[j]))
              {
                result.is_regular = false;
                return result;
              }
            // The determinant's sign changes with the pivot's sign and with the
            // exchange.
            if (inner[pivot_row][j] < 0)
              ++result.n_negative;
            if (pivot_row != j)
              ++result.n_negative;
            std::swap_ranges(inner[j], inner[j] + n_inner, inner[pivot_row]);
            std::swap_ranges(right[j], right[j] + n, right[pivot_row]);
            std::swap(row_units[j], row_units[pivot_row]);
            for (int i = j + 1; i < n_inner; ++i)
              subtract_row(inner[i][j] / inner[j][j], j, i, inner, right);
          }
        return result;
      }

      /** Back substitution. */
      static void substitute(const Inner inner, Right right)
      {
        for (int j = n_inner - 1; j >= 0; --j)
          {
            const double inverse = 1 / inner[j][j];
            for (int p = 0; p < n; ++p)
              right[j][p] *= inverse;
            for (int i = 0; i < j; ++i)
              for (int p = 0; p < n; ++p)
                right[i][p] -= inner[i][j] * right[j][p];
          }
      }

      static void condense(const double (&whole)[n][n],
                           const Right right,
                           double     *condensed)
      {
        for (int e = 0; e < n_ends; ++e, condensed += n_ends)
          {
            std::copy(whole[e], whole[e] + n_ends, condensed);
            for (int i = 0; i < n_inner; ++i)
              for (int p = 0; p < n_ends; ++p)
                condensed[p] -= whole[e][n_ends + i] * right[i][p];
          }
      }

      static void store(const double (&whole)[n][n],
                        const Right    right,
                        const Symmetry symmetry,
                        double        *factors)
      {
        for (int j = 0; j < n_inner; ++j)
          for (int i = 0; i < n_inner; ++i)
            *factors++ = right[i][n_ends + j];
        for (int i = 0; i < n_inner; ++i)
          factors = std::copy(right[i], right[i] + n_ends, factors);
        if (symmetry != Symmetry::none)
          return;
        for (int i = 0; i < n_inner; ++i)
          for (int e = 0; e < n_ends; ++e)
            {
              double sum = 0;
              for (int j = 0; j < n_inner; ++j)
                sum += whole[e][n_ends + j] * right[j][n_ends + i];
              *factors++ = sum;
            }
      }
    };

    template <int n_inner, int n_ends>
    const InnerElimination *match_size(const EliminationSizes sizes)
    {
      static const EliminationOfSize<n_inner, n_ends> elimination;
      return sizes.n_inner == n_inner && sizes.n_ends == n_ends ? &elimination
                                                                : nullptr;
    }
  } // namespace

  const InnerElimination *inner_elimination(const EliminationSizes sizes)
  {
    for (const auto candidate : {match_size<3, 6>,
                                 match_size<6, 6>,
                                 match_size<9, 6>,
                                 match_size<12, 6>,
                                 match_size<15, 6>,
                                 match_size<6, 12>,
                                 match_size<12, 12>,
                                 match_size<18, 12>})
      if (const InnerElimination *const elimination = candidate(sizes))
        return elimination;
    return nullptr;
  }

  namespace
  {
    /**
     * Strut whose inside has an unknown of the block; none for other blocks.
     */
    std::optional<unsigned int> strut_of(const TangentPattern &pattern,
                                         const std::size_t     block)
    {
      for (const int *i = pattern.begin(block); i != pattern.end(block); ++i)
        if (*i >= 0 && pattern.unknowns().strut[*i])
          return pattern.unknowns().strut[*i];
      return std::nullopt;
    }

    bool can_be_eliminated(const TangentPattern &pattern,
                           const unsigned int    strut,
                           const int             unknown)
    {
      const Unknowns &unknowns = pattern.unknowns();
      return unknowns.layout.is_owned(unknown) &&
        unknowns.strut[unknown] == strut &&
        unknowns.kinds[unknown] != UnknownKind::prescribed;
    }

    bool is_at_joint(const TangentPattern &pattern, const int unknown)
    {
      return unknown >= 0 && !pattern.unknowns().strut[unknown];
    }

    /** Whether the elements can be eliminated; sets their eliminations. */
    bool prepare(const TangentPattern &pattern, StrutElements &elements)
    {
      const unsigned int c = elements.n_node_unknowns,
                         n = elements.n_element_unknowns;
      if (n < 2 * c)
        return false;
      elements.between_nodes = inner_elimination({n - 2 * c, 2 * c});
      elements.node          = inner_elimination({c, 2 * c});
      if ((n > 2 * c && elements.between_nodes == nullptr) ||
          (elements.n_elements > 1 && elements.node == nullptr))
        return false;

      for (unsigned int e = 0; e < elements.n_elements; ++e)
        {
          const std::size_t block = elements.first_block + e;
          if (pattern.size(block) != n)
            return false;
          const int *const element_unknowns = pattern.begin(block);
          const auto       is_inside        = [&](const int unknown) {
            return can_be_eliminated(pattern, elements.strut, unknown);
          };
          if (!std::all_of(element_unknowns + 2 * c,
                           element_unknowns + n,
                           is_inside))
            return false;
          const auto at_joint = [&](const int unknown) {
            return is_at_joint(pattern, unknown);
          };
          if (e == 0 &&
              !std::all_of(element_unknowns, element_unknowns + c, at_joint))
            return false;
          const int *const last_node = element_unknowns + c;
          if (e + 1 == elements.n_elements)
            {
              if (!std::all_of(last_node, last_node + c, at_joint))
                return false;
            }
          else if (!std::all_of(last_node, last_node + c, is_inside) ||
                   !std::equal(last_node,
                               last_node + c,
                               pattern.begin(block + 1)))
            return false;
        }
      return true;
    }

    /** Removes struts whose inside other blocks act on. */
    void remove_coupled(const TangentPattern       &pattern,
                        std::vector<StrutElements> &found)
    {
      constexpr unsigned int    no_strut = -1;
      std::vector<unsigned int> eliminating_strut(
        pattern.unknowns().layout.n_local(),
        no_strut);
      for (unsigned int s = 0; s < found.size(); ++s)
        for (std::size_t b = found[s].first_block;
             b < found[s].first_block + found[s].n_elements;
             ++b)
          for (const int *i = pattern.begin(b); i != pattern.end(b); ++i)
            if (pattern.unknowns().strut[*i])
              eliminating_strut[*i] = s;

      std::vector<bool> is_coupled(found.size(), false);
      std::size_t       next = 0;
      for (std::size_t b = 0; b < pattern.n_blocks(); ++b)
        {
          while (next < found.size() &&
                 b >= found[next].first_block + found[next].n_elements)
            ++next;
          const unsigned int own =
            next < found.size() && b >= found[next].first_block ? next
                                                                : no_strut;
          for (const int *i = pattern.begin(b); i != pattern.end(b); ++i)
            if (*i >= 0 && eliminating_strut[*i] != no_strut &&
                eliminating_strut[*i] != own)
              is_coupled[eliminating_strut[*i]] = true;
        }
      std::size_t n_remaining = 0;
      for (std::size_t s = 0; s < found.size(); ++s)
        if (!is_coupled[s])
          found[n_remaining++] = found[s];
      found.resize(n_remaining);
    }
  } // namespace

  std::vector<StrutElements> find_strut_elements(const TangentPattern &pattern)
  {
    std::vector<StrutElements> found;
    const unsigned int n_node_unknowns = pattern.unknowns().components.size();
    std::size_t        block           = 0;
    while (block < pattern.n_blocks())
      {
        const std::optional<unsigned int> strut = strut_of(pattern, block);
        std::size_t                       end   = block + 1;
        if (strut)
          {
            while (end < pattern.n_blocks() && strut_of(pattern, end) == strut)
              ++end;
            StrutElements elements{*strut,
                                   block,
                                   static_cast<unsigned int>(end - block),
                                   n_node_unknowns,
                                   pattern.size(block),
                                   nullptr,
                                   nullptr};
            if (prepare(pattern, elements))
              found.push_back(elements);
          }
        block = end;
      }
    remove_coupled(pattern, found);
    found.shrink_to_fit();
    return found;
  }
} // namespace auxfem
