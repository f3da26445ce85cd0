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

    /**
     * Of the softness after @p n iterations over that of the softest mode, at
     * most: each takes the squares of what others have in a random start of
     * @p n_unknowns, a millionth of their sum left to that mode, down by their
     * softness squared.
     */
    double most_above_softest(const unsigned int n, const double n_unknowns)
    {
      return 2 * std::pow(1e6 * n_unknowns, 1. / (2 * n));
    }

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
      std::string       notes;
      for (const std::string &note : model.lattice.notes)
        notes += '\n' + note;
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
           : "") +
        notes);
    }

    /** Stiffness of each owned row's motion alone, for which that of a motion
     * is soft or not; multipliers have none. */
    Vector stiffness_by_rows(TangentSolver &solver)
    {
      const LatticeModel  &model     = solver.model();
      const DofNumbering  &numbering = model.numbering;
      const UnknownLayout &layout    = numbering.layout();
      const Vector         diagonal  = solver.matrix().diagonal();
      // A rank of a small lattice may have no unknown.
      const double stiffest = layout.largest(
        diagonal.empty() ? 0.
                         : *std::max_element(diagonal.begin(), diagonal.end()));
      const double length = model.mean_strut_length;
      Vector       weight(diagonal);
      for (unsigned int i = 0; i < layout.n_owned(); ++i)
        // Multipliers carry no energy; G^T and G hold the mode to what rigid
        // parts allow.
        if (numbering.unknowns().kinds[i] == UnknownKind::multiplier)
          weight[i] = 0;
        // A row without any stiffness counts as the stiffest: its motion is
        // then the softest of all.
        else if (weight[i] <= 0)
          weight[i] = (stiffest > 0 ? stiffest : 1.) *
            (numbering.unknowns().is_rotation[i] ? length * length : 1.);
      return weight;
    }

    /**
     * Looks for the softest motion with a factorization of the matrix as it is;
     * false if that is none, or one of a mechanism.
     * @param shift that the matrix has beside the stiffness, on owned rows
     */
    bool resists_all_motions(TangentSolver &solver,
                             const Vector  &weight,
                             const Vector  &shift,
                             Vector        &mode)
    {
      const DofNumbering  &numbering = solver.model().numbering;
      const UnknownLayout &layout    = numbering.layout();
      double               softness  = 0;
      const auto           measure   = [&]() {
        Vector image(layout.n_owned());
        solver.matrix().multiply(mode.data(), image.data());
        std::vector<double> sums(2, 0.);
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          {
            sums[0] += mode[i] * (image[i] - shift[i] * mode[i]);
            sums[1] += mode[i] * weight[i] * mode[i];
          }
        sums     = layout.sum(sums);
        softness = sums[0] / sums[1];
      };
      const auto growth = inverse_iteration(
        solver,
        weight,
        [&numbering](const unsigned int i) {
          return numbering.unknowns().kinds[i] != UnknownKind::multiplier &&
            numbering.unknowns().kinds[i] != UnknownKind::prescribed;
        },
        n_mechanism_iterations,
        mode,
        [&](const unsigned int n) {
          measure();
          return softness > softest * most_above_softest(n, layout.n_global());
        });
      return growth && softness > softest;
    }
  } // namespace

  bool refuse_mechanism(TangentSolver              &solver,
                        const State                &state,
                        const std::optional<double> first_step)
  {
    if (solver.model().numbering.unknowns().n_free() == 0)
      return false;
    State             now        = state;
    EvaluationResults results    = solver.equations().make_results();
    const Evaluation  evaluation = first_step
       ? Evaluation::static_step(state, now, *first_step)
       : Evaluation::equilibrium(state, now);
    solver.residual(evaluation, results);
    solver.assemble(evaluation,
                    results,
                    {1., first_step ? 1 / *first_step : 0., 0.});
    const Vector weight = stiffness_by_rows(solver);
    Vector       mode, shift(weight.size(), 0.);
    if (resists_all_motions(solver, weight, shift, mode))
      return true;
    // A singular matrix may have no factors, or any.
    for (unsigned int i = 0; i < shift.size(); ++i)
      shift[i] = softest * weight[i];
    solver.matrix().add_to_diagonal(shift);
    if (!resists_all_motions(solver, weight, shift, mode))
      tell_mechanism(solver.model(), mode);
    return false;
  }
} // namespace auxfem
