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
     * mechanism: far above round-off (1e-16), far below the softest sound
     * lattice (a cantilever of 1000 slender struts has 4e-13).
     */
    constexpr double softest = 1e-14;

    [[noreturn]] void refuse(const System &system, const Epetra_Vector &mode)
    {
      const DofNumbering &numbering = system.numbering();
      double              largest   = -1;
      unsigned int        worst     = 0;
      for (unsigned int i = 0; i < numbering.n_owned(); ++i)
        {
          // A strut that turns about its middle moves its ends by half its
          // length times the angle.
          const double size = std::abs(mode[i]) *
            (numbering.is_rotation(i) ? system.length_scale() / 2 : 1.);
          if (size > largest)
            {
              largest = size;
              worst   = i;
            }
        }
      double of_all = 0;
      numbering.communicator().MaxAll(&largest, &of_all, 1);
      int mine =
        largest == of_all ? int(numbering.rank()) : int(numbering.n_ranks());
      int who = 0;
      numbering.communicator().MinAll(&mine, &who, 1);
      std::string words =
        who == int(numbering.rank()) ? numbering.describe(worst) : "";
      words = dealii::Utilities::MPI::broadcast(numbering.communicator().Comm(),
                                                words,
                                                who);
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
                        TangentMatrix &matrix,
                        LinearSolver  &solver)
  {
    const DofNumbering &numbering = system.numbering();
    const State         before    = state;
    const Step step{before, state, std::numeric_limits<double>::infinity()};
    // Effects keep what the tangent needs from the last residual.
    system.begin_step(step);
    system.residual(step);
    system.tangent(step, {1., 0., 0.}, matrix);

    Epetra_Vector diagonal(numbering.owned_map()),
      shifted(numbering.owned_map());
    matrix.matrix().ExtractDiagonalCopy(diagonal);
    double largest = 0;
    diagonal.MaxValue(&largest);
    for (unsigned int i = 0; i < numbering.n_owned(); ++i)
      if (diagonal[i] <= 0)
        diagonal[i] = softest * largest;
    shifted = diagonal;
    shifted.Scale(1 + softest);
    const Epetra_CrsMatrix stiffness(matrix.matrix());
    matrix.matrix().ReplaceDiagonalValues(shifted);

    Epetra_Vector mode(numbering.owned_map()), image(numbering.owned_map());
    mode.SetSeed(1);
    mode.Random();
    double softness  = 0;
    bool   is_solved = solver.factorize();
    for (unsigned int i = 0; is_solved && i < 6; ++i)
      {
        for (unsigned int k = 0; k < numbering.n_owned(); ++k)
          solver.right_side()[k] = numbering.kind(k) == UnknownKind::prescribed
            ? 0.
            : diagonal[k] * mode[k];
        mode        = solver.solve();
        double size = 0;
        mode.NormInf(&size);
        is_solved = std::isfinite(size) && size > 0;
        mode.Scale(1 / size);
      }
    double energy = 0, scale = 0;
    stiffness.Multiply(false, mode, image);
    mode.Dot(image, &energy);
    image.Multiply(1., diagonal, mode, 0.);
    mode.Dot(image, &scale);
    softness = energy / scale;
    if (!(softness > softest))
      refuse(system, mode);
  }
} // namespace auxfem
