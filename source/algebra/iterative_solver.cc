#include <auxfem/algebra/joint_elimination.h>
#include <auxfem/algebra/krylov_solver.h>
#include <auxfem/algebra/linear_solver_method.h>
#include <auxfem/algebra/row_migration.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

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

    /** Rows that come from elsewhere, and what elimination makes of them. */
    struct Stage
    {
      std::unique_ptr<RowMigration>     migration; ///< none in the first
      std::unique_ptr<JointElimination> elimination;
      unsigned int                      version = 0;
      std::vector<double>               b, x;
      /** Rank that what is left had in the first stage, by row of rows(). */
      std::vector<double> first_rank;

      const JointRows &rows() const
      {
        return elimination->rows();
      }
    };

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

    /** What is left of all stages, where it was in the first of them: stages
     * leave more to ranks with a small number. */
    struct Left
    {
      Left(const SparseMatrix &matrix, const Stage &last)
        : migration(matrix,
                    last.rows().as_unknowns(),
                    {last.first_rank.begin(), last.first_rank.end()})
        , rows(migration.unknowns(), all_of(migration.unknowns()))
        , x(rows.layout().n_owned())
      {}

      static std::vector<int> all_of(const Unknowns &unknowns)
      {
        std::vector<int> all(unknowns.layout.n_owned());
        std::iota(all.begin(), all.end(), 0);
        return all;
      }

      RowMigration        migration;
      JointRows           rows;
      std::vector<double> x;
    };

    struct Parts
    {
      Parts(const SolverParameters &parameters, const Unknowns &unknowns)
        : layout(unknowns.layout)
        , stages(std::min(layout.n_ranks(), usual_stages))
        , krylov(load_krylov_solver(parameters))
      {
        stages[0].elimination =
          std::make_unique<JointElimination>(unknowns,
                                             most_neighbours(unknowns),
                                             most_at_once);
      }

      /** Returns false if a matrix is singular. */
      bool eliminate(const SparseMatrix &matrix)
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
            if (!stage.elimination->factorize(
                  s == 0 ? matrix : stage.migration->matrix()))
              return false;
            is_new = is_new || stage.version != stage.elimination->version();
            stage.version = stage.elimination->version();
            if (is_new && s + 1 == stages.size() && s + 1 < layout.n_ranks() &&
                stage.rows().as_unknowns().n_of(UnknownKind::multiplier) > 0)
              stages.emplace_back();
          }
        if (layout.n_ranks() > 1)
          bring_back(is_new);
        has_new_pattern = has_new_pattern || is_new;
        return true;
      }

      void bring_back(const bool is_new)
      {
        if (is_new)
          {
            left.reset();
            if (is_uneven())
              {
                find_first_ranks();
                left = std::make_unique<Left>(last().matrix(), stages.back());
              }
          }
        if (left)
          left->migration.fill(last().matrix());
      }

      bool is_uneven() const
      {
        const double n_entries = last().matrix().entries.size();
        return layout.largest(n_entries) * layout.n_ranks() >
          uneven * layout.sum(n_entries);
      }

      void find_first_ranks()
      {
        for (unsigned int s = 0; s < stages.size(); ++s)
          {
            const Unknowns &rows = stages[s].rows().as_unknowns();
            stages[s].first_rank.assign(rows.layout.n_owned(), layout.rank());
            if (s == 0)
              continue;
            const RowMigration &migration = *stages[s].migration;
            const unsigned int  n = migration.unknowns().layout.n_owned();
            std::vector<double> ranks(n);
            migration.go(stages[s - 1].first_rank.data(), ranks.data());
            std::unordered_map<unsigned int, unsigned int> of_joint;
            for (unsigned int row = 0; row < n; ++row)
              if (ranks[row] != layout.rank())
                of_joint[migration.unknowns().joint[row]] =
                  static_cast<unsigned int>(ranks[row]);
            for (unsigned int row = 0; row < stages[s].first_rank.size(); ++row)
              if (const auto other = of_joint.find(rows.joint[row]);
                  other != of_joint.end())
                stages[s].first_rank[row] = other->second;
          }
      }

      void reduce(const double *b)
      {
        for (unsigned int s = 0; s < stages.size(); ++s)
          {
            if (s > 0)
              {
                const std::vector<double> &before = stages[s - 1].b;
                stages[s].x.resize(
                  stages[s].migration->matrix().layout->n_owned());
                stages[s].migration->go(before.data(), stages[s].x.data());
              }
            stages[s].b.resize(stages[s].rows().layout().n_owned());
            stages[s].elimination->reduce(s == 0 ? b : stages[s].x.data(),
                                          stages[s].b.data());
          }
        if (left)
          left->migration.go(stages.back().b.data(), left->x.data());
      }

      void expand(double *x)
      {
        if (left)
          left->migration.come_back(left->x.data(), stages.back().b.data());
        for (unsigned int s = stages.size(); s-- > 0;)
          {
            double *of_stage = s == 0 ? x : stages[s].x.data();
            stages[s].elimination->expand(stages[s].b.data(), of_stage);
            if (s > 0)
              stages[s].migration->come_back(of_stage, stages[s - 1].b.data());
          }
      }

      const JointElimination &last() const
      {
        return *stages.back().elimination;
      }

      /** What is left, its rows, and right-hand side and solution of it. */
      const SparseMatrix &matrix_left() const
      {
        return left ? left->migration.matrix() : last().matrix();
      }

      const JointRows &rows_left() const
      {
        return left ? left->rows : last().rows();
      }

      std::vector<double> &x_left()
      {
        return left ? left->x : stages.back().b;
      }

      const UnknownLayout          &layout;
      std::vector<Stage>            stages;
      std::unique_ptr<Left>         left; ///< where that is uneven
      std::unique_ptr<KrylovSolver> krylov;
      /** Since the preconditioner was made. */
      bool has_new_pattern = true;
    };

    /** See make_iterative_solver(). */
    class IterativeSolver : public LinearSolverMethod
    {
    public:
      explicit IterativeSolver(const SolverParameters &parameters)
        : parameters(parameters)
      {}

      FactorizationOutcome analyse(const SparseMatrix & /*matrix*/,
                                   const Unknowns &unknowns) override
      {
        n_multipliers = unknowns.n_of(UnknownKind::multiplier);
        n_before      = n_iterations();
        parts         = std::make_unique<Parts>(parameters, unknowns);
        return FactorizationOutcome::done;
      }

      FactorizationOutcome factorize(const SparseMatrix &matrix) override
      {
        const bool has_wrong =
          std::any_of(matrix.entries.begin(),
                      matrix.entries.end(),
                      [](const double entry) { return !std::isfinite(entry); });
        if (parts->layout.largest(has_wrong ? 1. : 0.) > 0)
          return FactorizationOutcome::not_finite;
        if (!parts->eliminate(matrix))
          return FactorizationOutcome::singular;
        n_negative_eliminated = count_negative(matrix);
        if (parts->rows_left().layout().n_global() == 0)
          return FactorizationOutcome::done;
        const bool is_made     = parts->krylov->factorize(parts->matrix_left(),
                                                      parts->rows_left(),
                                                      parts->has_new_pattern,
                                                      may_be_definite());
        parts->has_new_pattern = !is_made;
        return is_made ? FactorizationOutcome::done
                       : FactorizationOutcome::singular;
      }

      std::string solve(double *x) override
      {
        parts->reduce(x);
        std::string          failure;
        std::vector<double> &g = parts->x_left();
        if (parts->rows_left().layout().n_global() > 0)
          failure = parts->krylov->solve(g.data(), g.data());
        parts->expand(x);
        return failure;
      }

      unsigned long n_iterations() const override
      {
        return parts ? n_before + parts->krylov->n_iterations() : 0;
      }

      std::size_t memory() const override
      {
        std::size_t sum = 0;
        if (parts)
          for (const Stage &stage : parts->stages)
            sum += stage.elimination ? stage.elimination->memory() : 0;
        return sum;
      }

      std::optional<Inertia> inertia() const override
      {
        return std::nullopt;
      }

      std::optional<unsigned long> n_negative_at_least() override
      {
        // Multipliers that are not eliminated have theirs in what is left.
        if (!n_negative_eliminated || *n_negative_eliminated < 0)
          return std::nullopt;
        if (*n_negative_eliminated > 0 ||
            parts->rows_left().layout().n_global() == 0)
          return *n_negative_eliminated;
        return parts->krylov->n_negative();
      }

      std::optional<int> determinant_sign() const override
      {
        return std::nullopt;
      }

    private:
      /** Negative pivots of all that is eliminated beyond one a multiplier;
       * nothing if @p matrix is not symmetric. */
      std::optional<long> count_negative(const SparseMatrix &matrix) const
      {
        double negative = 0, n_unsymmetric = matrix.is_symmetric ? 0 : 1;
        for (const Stage &stage : parts->stages)
          negative += stage.elimination->n_negative();
        const std::vector<double> sums =
          parts->layout.sum(std::vector<double>{negative, n_unsymmetric});
        return sums[1] == 0
          ? std::optional(std::lround(sums[0]) - n_multipliers)
          : std::nullopt;
      }

      /** Whether all that is eliminated allows conjugate gradients. */
      bool may_be_definite() const
      {
        return n_negative_eliminated && *n_negative_eliminated <= 0;
      }

      const SolverParameters parameters;
      std::unique_ptr<Parts> parts;
      long                   n_multipliers = 0;
      std::optional<long>    n_negative_eliminated; ///< see count_negative()
      unsigned long          n_before = 0;
    };
  } // namespace



  std::unique_ptr<LinearSolverMethod>
  make_iterative_solver(const SolverParameters &parameters)
  {
    return std::make_unique<IterativeSolver>(parameters);
  }
} // namespace auxfem
