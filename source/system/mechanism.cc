#include <auxfem/parameters/errors.h>
#include <auxfem/system/mechanism.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /**
     * A mode whose stiffness is below this part of the diagonal's is a
     * mechanism: the round-off of its energy is 1e-16 of it, the softest sound
     * lattice lies far above (a cantilever of 1000 slender struts at 4e-13).
     */
    constexpr double softest = 2e-15;

    /** The softest mode is found far sooner when it is that of a mechanism. */
    constexpr unsigned int n_inverse_iterations = 6;

    void leave_out_multipliers(const DofNumbering &numbering,
                               Epetra_Vector      &mode)
    {
      for (unsigned int i = 0; i < numbering.n_owned(); ++i)
        if (numbering.kind(i) == UnknownKind::multiplier)
          mode[i] = 0;
    }

    [[noreturn]] void refuse(const System &system, const Epetra_Vector &mode)
    {
      const DofNumbering &numbering = system.numbering();
      std::vector<double> sizes(numbering.n_owned());
      // A strut that turns about its end moves the other by its length times
      // the angle; half of that leaves the first word to the joint.
      for (unsigned int i = 0; i < sizes.size(); ++i)
        sizes[i] = std::abs(mode[i]) *
          (numbering.is_rotation(i) ? system.length_scale() / 2 : 1.);
      const std::string words = numbering.describe_largest(sizes);
      throw InputError(
        "The structure is not supported: it can move without any resistance, most of "
        "all the " +
        words +
        ".\nStatic equilibrium (Scheme = static, or Start from = static "
        "equilibrium) needs supports, rigid joints or springs that hold every part. "
        "Check Supports, hinges (Joints) and struts that are connected to nothing.");
    }
  } // namespace

  void refuse_mechanism(System        &system,
                        State          state,
                        const double   dt,
                        TangentMatrix &matrix,
                        LinearSolver  &solver)
  {
    const DofNumbering &numbering = system.numbering();
    if (numbering.n_free() == 0)
      return;
    const State before = state;
    const Step  step{before, state, dt};
    // Effects keep what the tangent needs from the last residual.
    system.begin_step(step);
    system.residual(step);
    system.tangent(step, {1., 1 / dt, 0.}, matrix);

    Epetra_Vector stiffness_diagonal(numbering.owned_map());
    matrix.matrix().ExtractDiagonalCopy(stiffness_diagonal);
    double stiffest = 0;
    stiffness_diagonal.MaxValue(&stiffest);
    const double  length = system.length_scale();
    Epetra_Vector weight(stiffness_diagonal), shifted(stiffness_diagonal);
    for (unsigned int i = 0; i < numbering.n_owned(); ++i)
      {
        // Multipliers carry no energy; G^T and G hold the mode to what rigid
        // parts allow.
        if (numbering.kind(i) == UnknownKind::multiplier)
          {
            weight[i] = 0;
            continue;
          }
        // A row without any stiffness counts as the stiffest: its motion is
        // then the softest of all.
        if (weight[i] <= 0)
          weight[i] = (stiffest > 0 ? stiffest : 1.) *
            (numbering.is_rotation(i) ? length * length : 1.);
        shifted[i] += softest * weight[i];
      }
    const Epetra_CrsMatrix stiffness(matrix.matrix());
    matrix.matrix().ReplaceDiagonalValues(shifted);

    Epetra_Vector mode(numbering.owned_map()), image(numbering.owned_map());
    mode.SetSeed(1);
    mode.Random();
    bool is_solved = solver.factorize();
    for (unsigned int i = 0; is_solved && i < n_inverse_iterations; ++i)
      {
        for (unsigned int k = 0; k < numbering.n_owned(); ++k)
          solver.right_side()[k] = numbering.kind(k) == UnknownKind::prescribed
            ? 0.
            : weight[k] * mode[k];
        mode = solver.solve();
        leave_out_multipliers(numbering, mode);
        double size = 0;
        mode.NormInf(&size);
        is_solved = std::isfinite(size) && size > 0;
        mode.Scale(1 / size);
      }
    double energy = 0, scale = 0;
    stiffness.Multiply(false, mode, image);
    mode.Dot(image, &energy);
    image.Multiply(1., weight, mode, 0.);
    mode.Dot(image, &scale);
    if (!is_solved || !(energy > softest * scale))
      refuse(system, mode);
  }
} // namespace auxfem
