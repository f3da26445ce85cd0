#include <auxfem/algebra/elimination_stages.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace auxfem
{
  namespace
  {
    /**
     * Joints with more neighbours stay. In the plane 10 cost no more than 4, as
     * they leave half of the rows with as many entries (100 x 100 cells of
     * prm/star-10x10.prm in statics), and what is left depends less on where
     * elimination begins: 26 and 27 iterations on one and two ranks, 24 and 30
     * with 4 (1000 rows at most on the coarsest level); begun in a random
     * order, 60 x 60 cells take 30, with 4 they take 83. In space more than 4
     * cost iterations (16 cells a side on four ranks: 64 with 6, 49 with 4).
     */
    unsigned int most_neighbours(const Unknowns &unknowns)
    {
      return unknowns.components.size() == 3 ? 10 : 4;
    }

    /** Rows that are eliminated faster than solved by iteration. */
    constexpr std::size_t most_at_once = 1000;

    /**
     * Eliminations one after the other on several ranks, rows moving between
     * ranks before each: the second has the joints that were at the boundary,
     * the third those where more than two ranks meet. Further ones follow only
     * while multipliers are left, with which no matrix is definite.
     */
    constexpr unsigned int usual_stages = 3;

    /**
     * Entries of the fullest rank beside the mean from which on what is left
     * goes back where it came from. Of 10 cells a side in space the first of
     * two ranks has 6 % more than the mean, of 16 12 %, of 100 and 200 in the
     * plane 9 and 2 %, the first of four ranks 59 % of 10 cells a side, 36 % of
     * 100; back again it is 3 % at most. Doing so costs a factorization of 10
     * or 100 cells a side in dynamics some 15 ms of 0.35 s, and saves on two
     * ranks 34 ms of 0.23 s a solution of the former in statics.
     */
    constexpr double uneven = 1.05;

    std::vector<int> all_owned(const Unknowns &unknowns)
    {
      std::vector<int> all(unknowns.layout.n_owned());
      std::iota(all.begin(), all.end(), 0);
      return all;
    }
  } // namespace

  EliminationStages::Left::Left(const JointElimination   &last,
                                std::vector<unsigned int> first_ranks)
    : migration(last.matrix(),
                last.rows().as_unknowns(),
                std::move(first_ranks))
    , rows(migration.unknowns(), all_owned(migration.unknowns()))
    , x(rows.layout().n_owned())
  {}

  EliminationStages::EliminationStages(const Unknowns &unknowns)
    : layout(unknowns.layout)
    , stages(std::min(layout.n_ranks(), usual_stages))
  {
    stages[0].elimination =
      std::make_unique<JointElimination>(unknowns,
                                         most_neighbours(unknowns),
                                         most_at_once);
  }

  bool EliminationStages::factorize(const SparseMatrix &matrix)
  {
    bool is_new = false;
    for (unsigned int s = 0; s < stages.size(); ++s)
      {
        Stage &stage = stages[s];
        if (s > 0)
          {
            const JointElimination &before = *stages[s - 1].elimination;
            if (is_new || !stage.migration)
              {
                const Unknowns &rows = before.rows().as_unknowns();
                stage.migration =
                  std::make_unique<RowMigration>(before.matrix(), rows);
                stage.elimination = std::make_unique<JointElimination>(
                  stage.migration->unknowns(),
                  most_neighbours(rows),
                  0);
                stage.version = 0;
              }
            stage.migration->fill(before.matrix());
          }
        if (!stage.elimination->factorize(s == 0 ? matrix
                                                 : stage.migration->matrix()))
          return false;
        is_new        = is_new || stage.version != stage.elimination->version();
        stage.version = stage.elimination->version();
        if (is_new && s + 1 == stages.size() && s + 1 < layout.n_ranks() &&
            stage.rows().as_unknowns().n_of(UnknownKind::multiplier) > 0)
          stages.emplace_back();
      }
    bring_back(is_new);
    if (is_new)
      ++n_patterns;
    return true;
  }

  void EliminationStages::bring_back(const bool is_new)
  {
    if (is_new)
      {
        left.reset();
        if (is_uneven())
          left = std::make_unique<Left>(last(), first_ranks());
      }
    if (left)
      left->migration.fill(last().matrix());
  }

  bool EliminationStages::is_uneven() const
  {
    const double n_entries = last().matrix().entries.size();
    return layout.largest(n_entries) * layout.n_ranks() >
      uneven * layout.sum(n_entries);
  }

  std::vector<unsigned int> EliminationStages::first_ranks() const
  {
    std::vector<double> ranks;
    for (const Stage &stage : stages)
      {
        const Unknowns &rows = stage.rows().as_unknowns();
        std::unordered_map<unsigned int, double> of_others;
        if (stage.migration)
          {
            const Unknowns     &moved = stage.migration->unknowns();
            std::vector<double> there(moved.layout.n_owned());
            stage.migration->go(ranks.data(), there.data());
            for (unsigned int row = 0; row < there.size(); ++row)
              if (there[row] != layout.rank())
                of_others[moved.joint[row]] = there[row];
          }
        ranks.assign(rows.layout.n_owned(), layout.rank());
        for (unsigned int row = 0; row < ranks.size(); ++row)
          if (const auto other = of_others.find(rows.joint[row]);
              other != of_others.end())
            ranks[row] = other->second;
      }
    return {ranks.begin(), ranks.end()};
  }

  void EliminationStages::reduce(const double *b)
  {
    for (unsigned int s = 0; s < stages.size(); ++s)
      {
        if (s > 0)
          {
            const std::vector<double> &before = stages[s - 1].b;
            stages[s].x.resize(stages[s].migration->matrix().layout->n_owned());
            stages[s].migration->go(before.data(), stages[s].x.data());
          }
        stages[s].b.resize(stages[s].rows().layout().n_owned());
        stages[s].elimination->reduce(s == 0 ? b : stages[s].x.data(),
                                      stages[s].b.data());
      }
    if (left)
      left->migration.go(stages.back().b.data(), left->x.data());
  }

  void EliminationStages::expand(double *all)
  {
    if (left)
      left->migration.come_back(left->x.data(), stages.back().b.data());
    for (unsigned int s = stages.size(); s-- > 0;)
      {
        double *of_stage = s == 0 ? all : stages[s].x.data();
        stages[s].elimination->expand(stages[s].b.data(), of_stage);
        if (s > 0)
          stages[s].migration->come_back(of_stage, stages[s - 1].b.data());
      }
  }

  const SparseMatrix &EliminationStages::matrix() const
  {
    return left ? left->migration.matrix() : last().matrix();
  }

  const JointRows &EliminationStages::rows() const
  {
    return left ? left->rows : last().rows();
  }

  std::vector<double> &EliminationStages::x()
  {
    return left ? left->x : stages.back().b;
  }

  unsigned long EliminationStages::n_negative() const
  {
    unsigned long sum = 0;
    for (const Stage &stage : stages)
      sum += stage.elimination->n_negative();
    return sum;
  }

  std::size_t EliminationStages::memory() const
  {
    std::size_t sum = 0;
    for (const Stage &stage : stages)
      sum += stage.elimination ? stage.elimination->memory() : 0;
    return sum;
  }
} // namespace auxfem
