#include <auxfem/algebra/solver_parameters.h>

namespace auxfem
{
  namespace
  {
    const Choice solver_type = {
      "Type",
      "auto",
      {"auto", "cholmod", "klu", "mumps", "gmres"},
      "Direct solvers, or gmres, iterative, for lattices that are too large for "
      "these. cholmod takes the symmetric part of the tangent and no rigid "
      "parts or revolute hinges; klu and mumps take all; with rigid parts or "
      "hinges mumps takes the place of gmres. auto chooses by kind "
      "and size, as the last lines of a run tell."};
    const Choice preconditioner = {
      "Preconditioner",
      "amg",
      {"amg", "ilu"},
      "For Type = gmres. amg: multigrid on the joints; ilu: incomplete "
      "factorization, quicker where steps are so short that inertia rules."};
    const Quantity solver_tolerance = {
      "Tolerance",
      "1e-8",
      "1",
      Range::open(0, 1),
      "Residual, relative to the right-hand side, at which gmres ends."};
    const Integer solver_iterations = {
      "Maximum iterations",
      1000,
      1,
      100000,
      "Iterations of gmres after which a step counts as failed."};
  } // namespace



  SubsectionSchema solver_schema()
  {
    return {"Solver",
            SubsectionSchema::Form::fixed,
            "Linear solver.",
            {solver_type, preconditioner, solver_tolerance, solver_iterations}};
  }



  SolverParameters read_solver(ParameterValues &values)
  {
    return {values[solver_type],
            values[preconditioner],
            values[solver_tolerance],
            values[solver_iterations]};
  }
} // namespace auxfem
