#include <auxfem/algebra/boundary_pivots.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace auxfem
{
  namespace
  {
    /** A number of some rows, by local row. */
    using Numbers = std::vector<std::optional<unsigned int>>;

    void keep_lowest(std::optional<unsigned int> &number,
                     const unsigned int           other)
    {
      number = number ? std::min(*number, other) : other;
    }

    class BoundaryPivots
    {
    public:
      BoundaryPivots(const SparseMatrix &matrix, const Unknowns &unknowns)
        : matrix(matrix)
        , unknowns(unknowns)
        , layout(*matrix.layout)
        , ranks(layout.n_local())
      {
        for (unsigned int row = 0; row < layout.n_owned(); ++row)
          for_each_column(row, [&](const int column) {
            if (!layout.is_owned(column))
              keep_lowest(ranks[row],
                          std::min(layout.rank(),
                                   layout.owner(layout.global(column))));
            if (is_multiplier(row) || is_multiplier(column))
              ties.emplace_back(row, column);
          });
        spread(ranks);
      }

      Numbers find() const
      {
        const Numbers waiting = waiting_rows();
        Numbers       pivots  = ranks;
        for (unsigned int row = 0; row < pivots.size(); ++row)
          if (waiting[row])
            pivots[row].reset();
        return pivots;
      }

    private:
      Numbers waiting_rows() const
      {
        Numbers tied(layout.n_local());
        for (const auto &[row, column] : ties)
          tied[row] = 0;
        spread(tied);
        const auto priority = [&](const int row) {
          return std::make_pair(tied[row] ? 0 : 1, *ranks[row]);
        };
        Numbers waiting(layout.n_local());
        for (unsigned int row = 0; row < layout.n_owned(); ++row)
          if (ranks[row])
            for_each_column(row, [&](const int column) {
              if (ranks[column] && *ranks[column] != *ranks[row] &&
                  priority(column) < priority(row))
                waiting[row] = 0;
            });
        spread(waiting);
        return waiting;
      }

      template <typename Visit>
      void for_each_column(const unsigned int row, const Visit &visit) const
      {
        for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
          visit(matrix.columns[i]);
      }

      bool is_multiplier(const int row) const
      {
        return unknowns.kinds[row] == UnknownKind::multiplier;
      }

      /** Gives rows the lowest number of their joint and of what multipliers
       * tie them to. */
      void spread(Numbers &numbers) const
      {
        for (bool has_changed = true; has_changed;)
          {
            spread_in_joints(numbers);
            layout.update_ghosts(numbers);
            has_changed = false;
            for (const auto &[row, column] : ties)
              if (numbers[column] &&
                  (!numbers[row] || *numbers[column] < *numbers[row]))
                {
                  numbers[row] = numbers[column];
                  has_changed  = true;
                }
            has_changed = layout.largest(has_changed ? 1. : 0.) > 0;
          }
      }

      void spread_in_joints(Numbers &numbers) const
      {
        std::unordered_map<unsigned int, std::optional<unsigned int>> lowest;
        for (unsigned int row = 0; row < layout.n_owned(); ++row)
          if (numbers[row] && !is_multiplier(row))
            keep_lowest(lowest[unknowns.joint[row]], *numbers[row]);
        if (lowest.empty())
          return;
        for (unsigned int row = 0; row < layout.n_owned(); ++row)
          if (const auto known = lowest.find(unknowns.joint[row]);
              known != lowest.end() && !is_multiplier(row))
            numbers[row] = known->second;
      }

      const SparseMatrix  &matrix;
      const Unknowns      &unknowns;
      const UnknownLayout &layout;
      /** Of rows at the boundary: the lowest that they act on. */
      Numbers ranks;
      /** Multipliers and what they act on, in both orders. */
      std::vector<std::pair<int, int>> ties;
    };
  } // namespace

  std::vector<std::optional<unsigned int>>
  boundary_pivots(const SparseMatrix &matrix, const Unknowns &unknowns)
  {
    return BoundaryPivots(matrix, unknowns).find();
  }
} // namespace auxfem
