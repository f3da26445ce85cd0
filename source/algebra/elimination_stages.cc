#include <auxfem/algebra/elimination_stages.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /**
     * Joints with more neighbours stay. In the plane 10 cost no more than 4, as
     * they leave half of the rows with as many entries (100 x 100 cells of
     * prm/star-10x10.prm in statics), and what is left depends less on where
     * elimination begins: 19 and 21 iterations on one and two ranks, 21 and 25
     * with 4; begun in a random order, 60 x 60 cells take 30, with 4 they take
     * 83. In space more than 4 cost iterations (16 cells a side on four ranks:
     * 55 with 6, 42 with 4).
     */
    unsigned int most_neighbours(const Unknowns &unknowns)
    {
      return unknowns.components.size() == 3 ? 10 : 4;
    }

    /** Rows that are eliminated faster than solved by iteration. */
    constexpr std::size_t most_at_once = 1000;

    /**
     * Eliminations one after the other on several ranks: the second has the
     * joints at the boundaries, the third those where more than two ranks meet.
     * Further ones follow only while multipliers are left, with which no matrix
     * is definite.
     */
    constexpr unsigned int usual_stages = 3;
  } // namespace

  EliminationStages::EliminationStages(const Unknowns &unknowns)
    : layout(unknowns.layout)
    , inside(unknowns, most_neighbours(unknowns), most_at_once)
    , boundary(std::min(layout.n_ranks(), usual_stages) - 1)
    , values(boundary.size() + 1)
  {}

  bool EliminationStages::factorize(const SparseMatrix &matrix)
  {
    const unsigned int n_before = inside.version();
    if (!inside.factorize(matrix))
      return false;
    if (inside.version() != n_before)
      forget_from(0);
    for (std::size_t s = 0; s < boundary.size(); ++s)
      {
        const SparseMatrix &rest = matrix_of(s);
        const Unknowns     &rows = rows_of(s).as_unknowns();
        if (!boundary[s])
          boundary[s] =
            std::make_unique<BoundaryElimination>(rest,
                                                  rows,
                                                  most_neighbours(rows));
        BoundaryElimination &stage      = *boundary[s];
        const unsigned int   n_of_stage = stage.version();
        if (!stage.factorize(rest, inside.largest_stiffness()))
          return false;
        if (stage.version() == n_of_stage)
          continue;
        forget_from(s + 1);
        if (s + 1 == boundary.size() && s + 2 < layout.n_ranks() &&
            stage.rows().as_unknowns().n_of(UnknownKind::multiplier) > 0)
          {
            boundary.emplace_back();
            values.emplace_back();
          }
      }
    return true;
  }

  void EliminationStages::forget_from(const std::size_t first)
  {
    for (std::size_t s = first; s < boundary.size(); ++s)
      boundary[s].reset();
    ++n_patterns;
  }

  const SparseMatrix &EliminationStages::matrix_of(const std::size_t s) const
  {
    return s == 0 ? inside.matrix() : boundary[s - 1]->matrix();
  }

  const JointRows &EliminationStages::rows_of(const std::size_t s) const
  {
    return s == 0 ? inside.rows() : boundary[s - 1]->rows();
  }

  void EliminationStages::reduce(const double *b)
  {
    for (std::size_t s = 0; s < values.size(); ++s)
      {
        values[s].resize(rows_of(s).layout().n_owned());
        if (s == 0)
          inside.reduce(b, values[0].data());
        else
          boundary[s - 1]->reduce(values[s - 1].data(), values[s].data());
      }
  }

  void EliminationStages::expand(double *all)
  {
    for (std::size_t s = boundary.size(); s-- > 0;)
      boundary[s]->expand(values[s + 1].data(), values[s].data());
    inside.expand(values[0].data(), all);
  }

  unsigned long EliminationStages::n_negative() const
  {
    unsigned long sum = inside.n_negative();
    for (const auto &stage : boundary)
      sum += stage->n_negative();
    return sum;
  }

  std::size_t EliminationStages::memory() const
  {
    std::size_t sum = inside.memory();
    for (const auto &stage : boundary)
      sum += stage ? stage->memory() : 0;
    return sum;
  }
} // namespace auxfem
