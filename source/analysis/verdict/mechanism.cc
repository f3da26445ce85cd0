#include <auxfem/equations/mode_space.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * A mode with a stiffness below this part of the diagonal's is a
     * mechanism. The softest valid lattice is far stiffer (a cantilever of
     * 1000 slender struts: 4e-13).
     */
    constexpr double softest = few_round_offs;

    /**
     * Inverse iteration finds the softest mode much faster if it is a
     * mechanism.
     */
    constexpr unsigned int n_mechanism_iterations = 6;

    /**
     * Upper bound of the softness after @p n iterations over that of the
     * softest mode. Iterations reduce the squares of all other modes by their
     * squared softness. The random start of @p n_unknowns has a millionth of
     * its square in that mode.
     */
    double largest_softness_ratio(const unsigned int n, const double n_unknowns)
    {
      return 2 * std::pow(1e6 * n_unknowns, 1. / (2 * n));
    }

    /** Stiffness (N/m) of a strut or other part. */
    struct PartStiffness
    {
      double value;
      int    strut; ///< -1: a connector or spring
    };

    /**
     * Largest stiffness of a part over directions, and whether it resists a
     * mode.
     */
    struct PartInMode
    {
      double stiffness = 0; ///< N/m
      bool   resists   = false;
    };

    /** @param translation, rotation size of the mode (m, rad). */
    PartInMode part_in_mode(const TangentMatrix &matrix,
                            const std::size_t    block,
                            const Vector        &mode,
                            const double         translation,
                            const double         rotation)
    {
      const TangentPattern &pattern = matrix.pattern();
      const int *const      rows    = pattern.begin(block);
      const unsigned int    n       = pattern.end(block) - rows;
      const double *const   values  = matrix.values(block);
      PartInMode            part;
      double                energy = 0, most = 0;
      for (unsigned int i = 0; i < n; ++i)
        {
          if (rows[i] < 0)
            continue;
          const UnknownKind kind = pattern.unknowns().kinds[rows[i]];
          if (kind == UnknownKind::multiplier)
            return {};
          const double motion =
            pattern.unknowns().is_rotation[rows[i]] ? rotation : translation;
          const double row_energy = values[n * i + i] * motion * motion;
          most += row_energy;
          part.stiffness =
            std::max(part.stiffness, row_energy / (translation * translation));
          for (unsigned int j = 0; j < n; ++j)
            if (rows[j] >= 0)
              energy += mode[rows[i]] * values[n * i + j] * mode[rows[j]];
        }
      part.resists = most > 0 && energy > sqrt_round_off * most;
      return part;
    }

    /** Strut of a block of the tangent; -1: none. */
    int strut_of_block(const DofNumbering &numbering, const std::size_t block)
    {
      return block < numbering.elements().size()
        ? static_cast<int>(numbering.elements()[block].interval.strut)
        : -1;
    }

    /** Largest @p factor times stiffness over all ranks. Collective. */
    PartStiffness extreme_of_all_ranks(const PartStiffness &mine,
                                       const double         factor,
                                       const UnknownLayout &layout)
    {
      const double largest = layout.largest(factor * mine.value);
      return {largest / factor,
              int(layout.largest(factor * mine.value == largest ? mine.strut
                                                                : -1.))};
    }

    std::string describe(const PartStiffness &part)
    {
      std::ostringstream text;
      text.precision(3);
      text << (part.strut < 0 ? "a connector or spring"
                              : "strut " + std::to_string(part.strut))
           << " (" << part.value << " N/m)";
      return text.str();
    }

    /**
     * Refuses parts so stiff that the parts resisting the softest mode are
     * lost in their round-off. Returns if no part resists, as in a mechanism.
     * Collective.
     */
    void refuse_stiffness_ratio(TangentSolver &solver, const Vector &mode)
    {
      const LatticeModel  &model  = solver.model();
      const UnknownLayout &layout = model.numbering.layout();
      const auto [moved, turned]  = largest_motion(model, mode);
      const double length         = model.mean_strut_length,
                   motion         = moved + length * turned;
      constexpr double  nothing   = std::numeric_limits<double>::max();
      PartStiffness     stiffest{0, -1}, softest_part{nothing, -1};
      const std::size_t n_blocks = solver.matrix().pattern().n_blocks();
      for (std::size_t block = 0; block < n_blocks && motion > 0; ++block)
        {
          const PartInMode part =
            part_in_mode(solver.matrix(), block, mode, motion, motion / length);
          const int strut = strut_of_block(model.numbering, block);
          if (part.stiffness > stiffest.value)
            stiffest = {part.stiffness, strut};
          if (part.resists && part.stiffness < softest_part.value)
            softest_part = {part.stiffness, strut};
        }
      stiffest     = extreme_of_all_ranks(stiffest, 1, layout);
      softest_part = extreme_of_all_ranks(softest_part, -1, layout);
      if (softest_part.value == nothing)
        return;
      std::ostringstream text;
      text.precision(2);
      text << "The stiffnesses of the structure are too far apart to compute "
              "with: that of "
           << describe(stiffest) << " is "
           << stiffest.value / softest_part.value << " times that of "
           << describe(softest_part)
           << ", which is lost in the round-off of the former. Make stiff "
              "parts rigid (Rigid parts), or check Young's moduli, sections, "
              "stiffnesses and their units.";
      throw InputError(text.str());
    }

    [[noreturn]] void tell_mechanism(const LatticeModel &model,
                                     const Vector       &mode)
    {
      const DofNumbering &numbering = model.numbering;
      std::vector<double> sizes(numbering.layout().n_owned());
      // The inside of a strut may move as far as a joint; the factors make the
      // message name the joint first.
      for (unsigned int i = 0; i < sizes.size(); ++i)
        sizes[i] = std::abs(mode[i]) *
          (numbering.unknowns().is_rotation[i] ? model.mean_strut_length / 2
                                               : 1.) *
          (numbering.unknowns().strut[i] ? 0.99 : 1.);
      const std::string location = describe_largest(numbering, sizes);
      std::string       notes;
      for (const std::string &note : model.lattice.notes)
        notes += '\n' + note;
      throw InputError(
        "The structure is not supported: it can move without any resistance, "
        "largest in the " +
        location +
        ".\nStatic equilibrium (Scheme = static, or Start from = static "
        "equilibrium) needs supports, rigid joints or springs that hold every part. "
        "Check Supports, hinges (Joints) and struts that are connected to nothing." +
        (model.lattice.n_plates > 0
           ? " Plates hold nothing until the structure is pressed on them: "
             "prescribe their motion, or use a scheme with inertia."
           : "") +
        notes);
    }

    /**
     * Stiffness of each owned row alone, the reference for soft motions; zero
     * for multipliers.
     */
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
        // A row without stiffness counts as the stiffest, which makes its
        // motion the softest.
        else if (weight[i] <= 0)
          weight[i] = (stiffest > 0 ? stiffest : 1.) *
            (numbering.unknowns().is_rotation[i] ? length * length : 1.);
      return weight;
    }

    /**
     * Searches the softest motion with a factorization of the current matrix.
     * False if the matrix is singular or the motion is a mechanism.
     * @param shift added to the stiffness, on owned rows
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
          return softness >
            softest * largest_softness_ratio(n, layout.n_global());
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
    // A singular matrix may have arbitrary factors, or none.
    for (unsigned int i = 0; i < shift.size(); ++i)
      shift[i] = softest * weight[i];
    solver.matrix().add_to_diagonal(shift);
    if (!resists_all_motions(solver, weight, shift, mode))
      {
        refuse_stiffness_ratio(solver, mode);
        tell_mechanism(solver.model(), mode);
      }
    return false;
  }

  namespace
  {
    /**
     * Smaller eigenvalues of G G^T are zero: its entries are of order 1, and a
     * chain of 1000 bars has 1e-6.
     */
    constexpr double smallest_eigenvalue = 1e-11;

    constexpr unsigned int n_overconstraint_iterations = 4;

    /**
     * Sets the diagonal to identity in rows of displacements and to a small
     * negative number in multipliers, beside the constraint gradients G. The
     * Schur complement is then -(G G^T + small) on free unknowns. Rotations are
     * scaled by the strut length.
     */
    void replace_diagonal(const LatticeModel &model, TangentMatrix &matrix)
    {
      const DofNumbering &numbering = model.numbering;
      Vector              diagonal(numbering.layout().n_owned());
      const double rotation = model.mean_strut_length * model.mean_strut_length;
      for (unsigned int i = 0; i < numbering.layout().n_owned(); ++i)
        diagonal[i] = numbering.unknowns().kinds[i] == UnknownKind::multiplier
          ? -smallest_eigenvalue / 10
          : numbering.unknowns().kinds[i] == UnknownKind::rotation ? rotation
                                                                   : 1.;
      matrix.set_diagonal(diagonal);
    }

    [[noreturn]] void throw_overconstraint(const LatticeModel &model,
                                           const Vector       &mode)
    {
      const DofNumbering &numbering = model.numbering;
      std::vector<double> sizes(numbering.layout().n_owned());
      for (unsigned int i = 0; i < sizes.size(); ++i)
        sizes[i] = std::abs(mode[i]);
      throw InputError(
        "A " + describe_largest(numbering, sizes) +
        " follows from other constraints and the supports, so the forces in "
        "them are not determined.\n" +
        (model.relations.empty()
           ? ""
           : "Remove a relation between joints that supports or other relations "
             "hold already. ") +
        (model.lattice.dimension == 3
           ? "Two hinges on one axis support a part twice: keep one of them, or "
             "let a support slide along the axis. "
           : "") +
        (model.lattice.rigid_parts.empty()
           ? ""
           : "Remove a rigid part between fixed joints or in a closed loop, "
             "make it elastic (Sections), or release a support. Rigid bars in "
             "exactly one line need a slight bend."));
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
    const Evaluation  evaluation = Evaluation::consistent_rates(state, now);
    solver.residual(evaluation, results);
    // Assembles only the gradients of constraints.
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
      throw_overconstraint(model, mode);
  }
} // namespace auxfem
