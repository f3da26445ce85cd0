#include <auxfem/algebra/linear_solver_method.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/exceptions.h>

#include <limits>

namespace auxfem
{
  namespace
  {
    // Sizes of the equations at the joints at which `auto` changes.

    /**
     * @name Unknowns up to which CHOLMOD's LDL' and KLU, which go entry by entry,
     * are quicker than MUMPS, which goes by dense blocks; measured by
     * scripts/measure-sizes (doc/theory.md, What growing lattices cost). MUMPS
     * gains in space, where factors are dense, and loses in solutions, of which
     * a factorization serves some ten.
     */
    ///@{
    constexpr unsigned long cholmod_limit_in_space = 30000;
    constexpr unsigned long klu_limit_in_space     = 10000;
    constexpr unsigned long klu_limit_in_plane     = 100000;
    /**
     * Where there are multipliers: at 468 (prm/rigid-array.prm) 1007
     * factorizations take 0.16 s and 1.9 s, 3059 solutions 0.06 s and 2.3 s.
     * Where that ends is a guess.
     */
    constexpr unsigned long klu_limit_with_multipliers = 10000;
    /** On several ranks, in the plane: CHOLMOD has the first one only. */
    constexpr unsigned long cholmod_limit_on_ranks = 300000;
    ///@}

    /**
     * @name Unknowns up to which MUMPS is as quick on one rank as on two. A
     * factorization and a solution on one against two: 6.1 and 0.68 ms against
     * 7.0 and 1.1 ms at 3060 unknowns in the plane, 75 and 7.4 against 84 and
     * 10 at 27,180, 353 and 33 against 270 and 27 at 108,360; in space 9.7 and
     * 0.64 against 7.6 and 0.78 at 2916, 28 and 2.4 against 16 and 1.8 at 6816.
     */
    ///@{
    constexpr unsigned long one_rank_limit_in_space = 5000;
    constexpr unsigned long one_rank_limit_in_plane = 50000;
    ///@}

    /**
     * Below it the iterations are the same with the symmetric part: those of
     * prm/star-10x10.prm, dashpots on turning lines, with 2e-8. At 1e-2, large
     * rotations in space of prm/lattice-3d.prm, they are 1.2 times as many.
     */
    constexpr double slight_asymmetry = 1e-4;

    /**
     * Unknowns, those inside struts included, up to which Newton's method gains
     * nothing by the symmetric part of an unsymmetric matrix.
     */
    constexpr unsigned long exact_limit = 50000;

    /**
     * Unknowns of lattices in space from which nested dissection pays. Products
     * in a factorization by LDL', minimum degree against nested dissection:
     * 0.74 times as many at 2916 unknowns, 1.2 at 6816, 1.8 at 22,680, 2.6 at
     * 103,800, 3.5 at 178,848. In the plane minimum degree takes 0.9 to 1.02
     * times as many from 3060 to 361,200 unknowns, and is found far sooner.
     */
    constexpr unsigned long dissection_limit = 5000;

    /**
     * Unknowns of lattices in space, on each rank, above which the factors are
     * taken to be too large. Planar lattices have so few more entries in their
     * factors than in the matrix that they have no such limit.
     */
    constexpr unsigned long iteration_limit = 1000000;

    LinearSolverChoice asked_for(const SolverParameters  &parameters,
                                 const EquationsAtJoints &equations)
    {
      const std::string reason = "Solver/Type = " + parameters.type;
      if (parameters.type == "klu")
        return {LinearSolverType::klu, reason};
      if (parameters.type == "mumps")
        return {LinearSolverType::mumps, reason};
      if (parameters.type == "gmres" && equations.n_multipliers > 0)
        return {LinearSolverType::mumps,
                reason + " does not serve the " +
                  std::to_string(equations.n_multipliers) +
                  " multipliers of rigid parts and hinges"};
      if (parameters.type == "gmres")
        return {LinearSolverType::iterative, reason};
      AssertThrow(parameters.type == "cholmod",
                  dealii::ExcMessage("Unknown solver " + parameters.type));
      if (equations.n_multipliers > 0)
        throw InputError(
          "Solver/Type = cholmod does not serve scenes with rigid parts or "
          "revolute hinges: the " +
          std::to_string(equations.n_multipliers) +
          " constraints of these make the matrix indefinite. Use `auto`, "
          "`mumps` or `klu`.");
      return {LinearSolverType::cholmod, reason};
    }

    bool is_in_space(const EquationsAtJoints &equations)
    {
      return equations.n_components == 6;
    }

    /** Of those that use one rank. */
    LinearSolverType sparse_solver(const EquationsAtJoints &equations)
    {
      return equations.symmetry == Symmetry::none || equations.n_multipliers > 0
        ? LinearSolverType::klu
        : LinearSolverType::cholmod;
    }

    /** Unknowns up to which sparse_solver() is quicker than MUMPS. */
    unsigned long limit_of_sparse_solver(const EquationsAtJoints &equations)
    {
      if (equations.symmetry != Symmetry::none && equations.n_multipliers > 0)
        return klu_limit_with_multipliers;
      if (sparse_solver(equations) == LinearSolverType::klu)
        return is_in_space(equations) ? klu_limit_in_space : klu_limit_in_plane;
      if (is_in_space(equations))
        return cholmod_limit_in_space;
      return equations.n_ranks > 1 ? cholmod_limit_on_ranks
                                   : std::numeric_limits<unsigned long>::max();
    }

    /** `on 4 ranks, 300 unknowns at joints` */
    std::string size_text(const EquationsAtJoints &equations)
    {
      return (equations.n_ranks > 1
                ? "on " + std::to_string(equations.n_ranks) + " ranks, "
                : std::string()) +
        std::to_string(equations.n_unknowns) + " unknowns at joints";
    }
  } // namespace

  EliminationOrder choose_elimination_order(const EquationsAtJoints &equations)
  {
    return is_in_space(equations) && equations.n_unknowns > dissection_limit
      ? EliminationOrder::nested_dissection
      : EliminationOrder::minimum_degree;
  }

  MumpsRanks choose_mumps_ranks(const EquationsAtJoints &equations)
  {
    return equations.n_unknowns <= (is_in_space(equations)
                                      ? one_rank_limit_in_space
                                      : one_rank_limit_in_plane)
      ? MumpsRanks::first
      : MumpsRanks::all;
  }

  bool symmetric_part_pays(const SolverParameters &parameters,
                           const double            asymmetry,
                           const unsigned long     n_unknowns)
  {
    return parameters.type != "klu" &&
      (asymmetry < slight_asymmetry || n_unknowns > exact_limit);
  }

  std::string name_of(const LinearSolverType type)
  {
    switch (type)
      {
        case LinearSolverType::cholmod:
          return "CHOLMOD";
        case LinearSolverType::klu:
          return "KLU";
        case LinearSolverType::mumps:
          return "MUMPS";
        case LinearSolverType::iterative:
          return "iteration with multigrid or ILU";
      }
    Assert(false, dealii::ExcInternalError());
    return "";
  }

  LinearSolverChoice choose_linear_solver(const SolverParameters  &parameters,
                                          const EquationsAtJoints &equations)
  {
    if (parameters.type != "auto")
      return asked_for(parameters, equations);

    const std::string size = size_text(equations);
    if (is_in_space(equations) && !parameters.needs_inertia &&
        equations.n_multipliers == 0 &&
        equations.n_unknowns > iteration_limit * equations.n_ranks)
      return {LinearSolverType::iterative,
              "in space, " + size + ", the factors of which need more memory"};
    const std::string matrix =
      equations.symmetry == Symmetry::none ? "unsymmetric" : "symmetric";
    const std::string multipliers = equations.n_multipliers > 0
      ? " with " + std::to_string(equations.n_multipliers) + " multipliers"
      : "";
    return {equations.n_unknowns <= limit_of_sparse_solver(equations)
              ? sparse_solver(equations)
              : LinearSolverType::mumps,
            matrix + " matrix" + multipliers + ", " + size};
  }
} // namespace auxfem
