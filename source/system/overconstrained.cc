#include <auxfem/parameters/errors.h>
#include <auxfem/system/overconstrained.h>

#include <algorithm>
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

    constexpr unsigned int n_inverse_iterations = 4;

    /**
     * Identity in the rows of displacements, the conditions' gradients G beside
     * it, a small negative number in the multipliers' diagonal: its Schur
     * complement is -(G G^T + small) on unknowns that are free. Rotations in
     * space count as displacements at the length of a strut.
     */
    void
    make_matrix(const System &system, const Step &step, TangentMatrix &matrix)
    {
      system.tangent(step, {0., 0., 0.}, matrix);
      const DofNumbering &numbering = system.numbering();
      Epetra_Vector       diagonal(numbering.owned_map());
      const double        rotation = system.lattice().dimension == 3
               ? system.length_scale() * system.length_scale()
               : 1.;
      for (unsigned int i = 0; i < numbering.n_owned(); ++i)
        diagonal[i] = numbering.kind(i) == UnknownKind::multiplier
          ? -smallest_eigenvalue / 10
          : numbering.kind(i) == UnknownKind::rotation ? rotation
                                                       : 1.;
      matrix.matrix().ReplaceDiagonalValues(diagonal);
    }

    void keep_multipliers(const DofNumbering &numbering, Epetra_Vector &mode)
    {
      for (unsigned int i = 0; i < numbering.n_owned(); ++i)
        if (numbering.kind(i) != UnknownKind::multiplier)
          mode[i] = 0;
    }

    [[noreturn]] void refuse(const System &system, const Epetra_Vector &mode)
    {
      const DofNumbering &numbering = system.numbering();
      std::vector<double> sizes(numbering.n_owned());
      for (unsigned int i = 0; i < sizes.size(); ++i)
        sizes[i] = std::abs(mode[i]);
      throw InputError(
        std::string(system.lattice().dimension == 3
                      ? "Rigid parts and revolute hinges: a "
                      : "Rigid parts: a ") +
        numbering.describe_largest(sizes) +
        " follows from the conditions of other parts and the supports, so the "
        "forces in them are not determined.\n" +
        (system.lattice().dimension == 3
           ? "Two hinges on one axis hold a part twice: let one be a hinge, or "
             "a support slide along the axis. "
           : "") +
        "A rigid part between fixed joints, "
        "or one too many in a closed loop, must go or become elastic (Sections), "
        "or a support must let go; bars that lie exactly in one line must be "
        "bent a little.");
    }
  } // namespace

  void refuse_overconstrained(System        &system,
                              State          state,
                              TangentMatrix &matrix,
                              LinearSolver  &solver)
  {
    const DofNumbering &numbering = system.numbering();
    if (numbering.n_multipliers() == 0)
      return;
    const State before = state;
    const Step  step{before, state, /*dt=*/0.};
    system.begin_step(step);
    system.residual(step);
    make_matrix(system, step, matrix);

    Epetra_Vector mode(numbering.owned_map());
    mode.SetSeed(1);
    mode.Random();
    keep_multipliers(numbering, mode);
    double growth    = 0;
    bool   is_solved = solver.factorize();
    for (unsigned int i = 0; is_solved && i < n_inverse_iterations; ++i)
      {
        double size = 0;
        mode.NormInf(&size);
        mode.Scale(1 / size);
        solver.right_side() = mode;
        mode                = solver.solve();
        keep_multipliers(numbering, mode);
        mode.NormInf(&growth);
        is_solved = std::isfinite(growth);
      }
    if (!is_solved || growth > 1 / smallest_eigenvalue)
      refuse(system, mode);
  }
} // namespace auxfem
