#include <auxfem/analysis/inverse_iteration.h>
#include <auxfem/model/unknown_words.h>
#include <auxfem/parameters/errors.h>

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

    [[noreturn]] void refuse(const LatticeModel  &model,
                             const Epetra_Vector &mode)
    {
      const DofNumbering &numbering = model.numbering;
      std::vector<double> sizes(numbering.layout().n_owned());
      // A strut that turns about its end moves the other by its length times
      // the angle; half of that leaves the first word to the joint.
      for (unsigned int i = 0; i < sizes.size(); ++i)
        sizes[i] = std::abs(mode[i]) *
          (numbering.unknowns().is_rotation[i] ? model.mean_strut_length / 2
                                               : 1.);
      const std::string words = describe_largest(numbering, sizes);
      throw InputError(
        "The structure is not supported: it can move without any resistance, most of "
        "all the " +
        words +
        ".\nStatic equilibrium (Scheme = static, or Start from = static "
        "equilibrium) needs supports, rigid joints or springs that hold every part. "
        "Check Supports, hinges (Joints) and struts that are connected to nothing.");
    }
  } // namespace

  void refuse_mechanism(TangentSolver              &solver,
                        const State                &state,
                        const std::optional<double> first_step)
  {
    const LatticeModel &model     = solver.model();
    const DofNumbering &numbering = model.numbering;
    if (numbering.unknowns().n_free() == 0)
      return;
    State             now        = state;
    EvaluationResults results    = solver.equations().make_results();
    const Evaluation  evaluation = first_step
       ? Evaluation::static_step(state, now, *first_step)
       : Evaluation::equilibrium(state, now);
    solver.residual(evaluation, results);
    solver.assemble(evaluation,
                    results,
                    {1., first_step ? 1 / *first_step : 0., 0.});

    Epetra_CrsMatrix &matrix = solver.matrix().matrix();
    Epetra_Vector     diagonal(numbering.owned_map());
    matrix.ExtractDiagonalCopy(diagonal);
    double stiffest = 0;
    diagonal.MaxValue(&stiffest);
    const double  length = model.mean_strut_length;
    Epetra_Vector weight(diagonal), shifted(diagonal);
    for (unsigned int i = 0; i < numbering.layout().n_owned(); ++i)
      {
        // Multipliers carry no energy; G^T and G hold the mode to what rigid
        // parts allow.
        if (numbering.unknowns().kinds[i] == UnknownKind::multiplier)
          {
            weight[i] = 0;
            continue;
          }
        // A row without any stiffness counts as the stiffest: its motion is
        // then the softest of all.
        if (weight[i] <= 0)
          weight[i] = (stiffest > 0 ? stiffest : 1.) *
            (numbering.unknowns().is_rotation[i] ? length * length : 1.);
        shifted[i] += softest * weight[i];
      }
    const Epetra_CrsMatrix stiffness(matrix);
    matrix.ReplaceDiagonalValues(shifted);

    Epetra_Vector mode(numbering.owned_map()), image(numbering.owned_map());
    const auto    growth = inverse_iteration(
      solver,
      weight,
      [&](const unsigned int i) {
        return numbering.unknowns().kinds[i] != UnknownKind::multiplier &&
          numbering.unknowns().kinds[i] != UnknownKind::prescribed;
      },
      n_inverse_iterations,
      mode);
    double energy = 0, scale = 0;
    stiffness.Multiply(false, mode, image);
    mode.Dot(image, &energy);
    image.Multiply(1., weight, mode, 0.);
    mode.Dot(image, &scale);
    if (!growth || !(energy > softest * scale))
      refuse(model, mode);
  }
} // namespace auxfem
