#include <auxfem/analysis/inverse_iteration.h>
#include <auxfem/model/unknown_names.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

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
    constexpr unsigned int n_mechanism_iterations = 6;

    [[noreturn]] void tell_mechanism(const LatticeModel &model,
                                     const Vector       &mode)
    {
      const DofNumbering &numbering = model.numbering;
      std::vector<double> sizes(numbering.layout().n_owned());
      // A strut that turns about its end moves the other by its length times
      // the angle; half of that leaves the first word to the joint, also where
      // the inside of a strut moves as far as that.
      for (unsigned int i = 0; i < sizes.size(); ++i)
        sizes[i] = std::abs(mode[i]) *
          (numbering.unknowns().is_rotation[i] ? model.mean_strut_length / 2
                                               : 1.) *
          (numbering.unknowns().strut[i] ? 0.99 : 1.);
      const std::string words = describe_largest(numbering, sizes);
      throw InputError(
        "The structure is not supported: it can move without any resistance, most of "
        "all the " +
        words +
        ".\nStatic equilibrium (Scheme = static, or Start from = static "
        "equilibrium) needs supports, rigid joints or springs that hold every part. "
        "Check Supports, hinges (Joints) and struts that are connected to nothing." +
        (model.lattice.n_plates > 0
           ? " Plates hold nothing until it is pressed on them, nor are they "
             "held: move them, or use a scheme with inertia."
           : ""));
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

    const UnknownLayout &layout   = numbering.layout();
    TangentMatrix       &matrix   = solver.matrix();
    const Vector         diagonal = matrix.diagonal();
    // A rank of a small lattice may have no unknown.
    const double stiffest = layout.largest(
      diagonal.empty() ? 0.
                       : *std::max_element(diagonal.begin(), diagonal.end()));
    const double length = model.mean_strut_length;
    Vector       weight(diagonal), shift(diagonal.size(), 0.);
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
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
        shift[i] = softest * weight[i];
      }
    matrix.add_to_diagonal(shift);

    Vector     mode;
    const auto growth = inverse_iteration(
      solver,
      weight,
      [&](const unsigned int i) {
        return numbering.unknowns().kinds[i] != UnknownKind::multiplier &&
          numbering.unknowns().kinds[i] != UnknownKind::prescribed;
      },
      n_mechanism_iterations,
      mode);
    Vector image(layout.n_owned());
    matrix.multiply(mode.data(), image.data());
    double energy = 0, scale = 0;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      {
        energy += mode[i] * (image[i] - shift[i] * mode[i]);
        scale += mode[i] * weight[i] * mode[i];
      }
    if (!growth || !(layout.sum(energy) > softest * layout.sum(scale)))
      tell_mechanism(model, mode);
  }
} // namespace auxfem
