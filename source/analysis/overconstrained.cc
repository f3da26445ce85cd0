#include <auxfem/analysis/inverse_iteration.h>
#include <auxfem/model/unknown_names.h>
#include <auxfem/parameters/errors.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Eigenvalues of G G^T below this are zero: its entries are of order 1, a
     * chain of 1000 bars comes down to 1e-6.
     */
    constexpr double smallest_eigenvalue = 1e-11;

    constexpr unsigned int n_overconstraint_iterations = 4;

    /**
     * Identity in the rows of displacements, the constraints' gradients G
     * beside it, a small negative number in the multipliers' diagonal: its
     * Schur complement is -(G G^T + small) on unknowns that are free. Rotations
     * in space count as displacements at the length of a strut.
     */
    void replace_diagonal(const LatticeModel &model, TangentMatrix &matrix)
    {
      const DofNumbering &numbering = model.numbering;
      Vector              diagonal(numbering.layout().n_owned());
      const double        rotation = model.lattice.dimension == 3
               ? model.mean_strut_length * model.mean_strut_length
               : 1.;
      for (unsigned int i = 0; i < numbering.layout().n_owned(); ++i)
        diagonal[i] = numbering.unknowns().kinds[i] == UnknownKind::multiplier
          ? -smallest_eigenvalue / 10
          : numbering.unknowns().kinds[i] == UnknownKind::rotation ? rotation
                                                                   : 1.;
      matrix.set_diagonal(diagonal);
    }

    [[noreturn]] void tell_overconstraint(const LatticeModel &model,
                                          const Vector       &mode)
    {
      const DofNumbering &numbering = model.numbering;
      std::vector<double> sizes(numbering.layout().n_owned());
      for (unsigned int i = 0; i < sizes.size(); ++i)
        sizes[i] = std::abs(mode[i]);
      throw InputError(
        std::string(model.lattice.dimension == 3
                      ? "Rigid parts and revolute hinges: a "
                      : "Rigid parts: a ") +
        describe_largest(numbering, sizes) +
        " follows from the constraints of other parts and the supports, so the "
        "forces in them are not determined.\n" +
        (model.lattice.dimension == 3
           ? "Two hinges on one axis hold a part twice: let one be a hinge, or "
             "a support slide along the axis. "
           : "") +
        "A rigid part between fixed joints, "
        "or one too many in a closed loop, must go or become elastic (Sections), "
        "or a support must let go; bars that lie exactly in one line must be "
        "bent a little.");
    }
  } // namespace

  void refuse_overconstrained(TangentSolver &solver, const State &state)
  {
    const LatticeModel &model     = solver.model();
    const DofNumbering &numbering = model.numbering;
    if (numbering.constraints().n_multipliers() == 0)
      return;
    State             now        = state;
    EvaluationResults results    = solver.equations().make_results();
    const Evaluation  evaluation = Evaluation::rates(state, now);
    solver.residual(evaluation, results);
    // Only the gradients of the constraints stand in it.
    solver.assemble(evaluation, results, {0., 0., 0.});
    replace_diagonal(model, solver.matrix());

    const Vector ones(numbering.layout().n_owned(), 1.);
    Vector       mode;
    const auto   growth = inverse_iteration(
      solver,
      ones,
      [&](const unsigned int i) {
        return numbering.unknowns().kinds[i] == UnknownKind::multiplier;
      },
      n_overconstraint_iterations,
      mode);
    if (!growth || *growth > 1 / smallest_eigenvalue)
      tell_overconstraint(model, mode);
  }
} // namespace auxfem
