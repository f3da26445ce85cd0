#include <auxfem/algebra/linear_solver_method.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/exceptions.h>

#include <limits>

namespace auxfem
{
  namespace
  {
    // Sizes of the equations at the joints at which `auto` changes. CHOLMOD's
    // LDL' and KLU work entry by entry on one rank, MUMPS by dense blocks. All
    // count unknowns at joints.

    /**
     * Symmetric matrices in space up to which CHOLMOD is faster than MUMPS.
     * @tuned [unknowns] measured by scripts/measure-sizes
     */
    constexpr unsigned long cholmod_limit_in_space = 30000;

    /**
     * Unsymmetric matrices in space, and matrices with multipliers, up to which
     * KLU is faster than MUMPS.
     * @tuned [unknowns] measured by scripts/measure-sizes; with multipliers a
     *   guess
     */
    constexpr unsigned long klu_limit_in_space = 10000;

    /**
     * Matrices in the plane up to which one rank is faster: KLU for unsymmetric
     * ones, on several ranks CHOLMOD, and MUMPS on the first.
     * @tuned [unknowns] measured by scripts/measure-sizes
     */
    constexpr unsigned long one_rank_limit_in_plane = 100000;

    /**
     * Matrices in space up to which factors are so small that minimum degree
     * suffices and MUMPS gains nothing on several ranks.
     * @tuned [unknowns] measured by scripts/measure-sizes
     */
    constexpr unsigned long small_factor_limit = 5000;

    /**
     * Asymmetry below which Newton's method uses the symmetric part.
     * @tuned measured: 2e-8 in prm/star-10x10.prm; 1e-2 in prm/lattice-3d.prm
     *   raises the iterations by 20 %
     */
    constexpr double slight_asymmetry = 1e-4;

    /**
     * Unknowns, those inside struts included, up to which the symmetric part of
     * an unsymmetric matrix does not speed up Newton's method.
     * @tuned [unknowns] measured (doc/theory/newton.md)
     */
    constexpr unsigned long exact_limit = 50000;

    /**
     * Unknowns per rank in space up to which direct factors fit into memory.
     * Planar factors are hardly larger than the matrix.
     * @tuned [unknowns] judgement
     */
    constexpr unsigned long iteration_limit = 1000000;

    LinearSolverChoice requested_solver(const SolverParameters  &parameters,
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
                  " multipliers of constraints"};
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

    /** Sparse solver on one rank. */
    LinearSolverType sparse_solver(const EquationsAtJoints &equations)
    {
      return equations.symmetry == Symmetry::none || equations.n_multipliers > 0
        ? LinearSolverType::klu
        : LinearSolverType::cholmod;
    }

    /** Unknowns up to which sparse_solver() is faster than MUMPS. */
    unsigned long limit_of_sparse_solver(const EquationsAtJoints &equations)
    {
      if (equations.symmetry != Symmetry::none && equations.n_multipliers > 0)
        return klu_limit_in_space;
      if (sparse_solver(equations) == LinearSolverType::klu)
        return is_in_space(equations) ? klu_limit_in_space
                                      : one_rank_limit_in_plane;
      if (is_in_space(equations))
        return cholmod_limit_in_space;
      return equations.n_ranks > 1 ? one_rank_limit_in_plane
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
    return is_in_space(equations) && equations.n_unknowns > small_factor_limit
      ? EliminationOrder::nested_dissection
      : EliminationOrder::minimum_degree;
  }

  MumpsRanks choose_mumps_ranks(const EquationsAtJoints &equations)
  {
    return equations.n_unknowns <=
        (is_in_space(equations) ? small_factor_limit : one_rank_limit_in_plane)
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
      return requested_solver(parameters, equations);

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
