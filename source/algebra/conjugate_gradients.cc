#include <auxfem/algebra/conjugate_gradients.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/solver_cg.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    using OwnedVector = dealii::LinearAlgebra::distributed::Vector<double>;

    /** A TangentMatrix as deal.II multiplies by it, identity columns for
     * prescribed unknowns. */
    class FreeOperator
    {
    public:
      explicit FreeOperator(const TangentMatrix &matrix)
        : matrix(matrix)
        , unknowns(matrix.pattern().unknowns())
        , local(unknowns.layout.n_local())
        , owned(unknowns.layout.n_owned())
      {}

      void vmult(OwnedVector &image, const OwnedVector &x) const
      {
        for (unsigned int i = 0; i < owned.size(); ++i)
          local[i] = is_prescribed(i) ? 0. : x.local_element(i);
        unknowns.layout.update_ghosts(local.data());
        matrix.multiply(local.data(), owned.data());
        for (unsigned int i = 0; i < owned.size(); ++i)
          image.local_element(i) =
            is_prescribed(i) ? x.local_element(i) : owned[i];
      }

    private:
      bool is_prescribed(const unsigned int i) const
      {
        return unknowns.kinds[i] == UnknownKind::prescribed;
      }

      const TangentMatrix        &matrix;
      const Unknowns             &unknowns;
      mutable std::vector<double> local, owned;
    };

    OwnedVector make_vector(const UnknownLayout &layout)
    {
      const int        begin = layout.first_of(layout.rank());
      dealii::IndexSet range(layout.n_global());
      range.add_range(begin, begin + layout.n_owned());
      return OwnedVector(range, layout.communicator());
    }
  } // namespace

  bool solve_by_conjugate_gradients(const TangentMatrix &matrix,
                                    std::vector<double> &values)
  {
    // A mass matrix needs some ten iterations; of round-off nothing is left
    // that would show beside the error of the first step.
    constexpr double       tolerance          = 1e-13;
    constexpr unsigned int maximum_iterations = 1000;
    const Unknowns        &unknowns           = matrix.pattern().unknowns();
    const UnknownLayout   &layout             = unknowns.layout;

    // deal.II takes what is not finite for a mistake of the program.
    const std::vector<double> diagonal = matrix.diagonal();
    bool                      is_sound = true;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      is_sound = is_sound && std::isfinite(values[i]) &&
        std::isfinite(diagonal[i]) && diagonal[i] > 0;
    if (layout.largest(is_sound ? 0. : 1.) > 0)
      return false;
    OwnedVector b = make_vector(layout), x = b;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      b.local_element(i) = values[i];
    const double size = b.l2_norm();

    // Columns of prescribed unknowns stand in free rows: what they do goes to
    // the right-hand side, so the matrix of the search is symmetric.
    std::vector<double> prescribed(layout.n_local(), 0.),
      image(layout.n_owned());
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (unknowns.kinds[i] == UnknownKind::prescribed)
        prescribed[i] = values[i];
    layout.update_ghosts(prescribed.data());
    matrix.multiply(prescribed.data(), image.data());
    OwnedVector inverse(b);
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      {
        if (unknowns.kinds[i] == UnknownKind::prescribed)
          x.local_element(i) = values[i];
        else
          b.local_element(i) -= image[i];
        inverse.local_element(i) = 1 / diagonal[i];
      }

    const FreeOperator                  free(matrix);
    dealii::DiagonalMatrix<OwnedVector> preconditioner;
    preconditioner.reinit(inverse);
    dealii::SolverControl control(maximum_iterations,
                                  tolerance * size,
                                  /*log_history=*/false,
                                  /*log_result=*/false);
    try
      {
        dealii::SolverCG<OwnedVector>(control).solve(free,
                                                     x,
                                                     b,
                                                     preconditioner);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        // Where round-off rules the tolerance may be missed by little.
        OwnedVector rest(b);
        free.vmult(rest, x);
        rest -= b;
        if (!(rest.l2_norm() <= 10 * tolerance * size))
          return false;
      }
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      values[i] = x.local_element(i);
    layout.update_ghosts(values.data());
    return true;
  }
} // namespace auxfem
