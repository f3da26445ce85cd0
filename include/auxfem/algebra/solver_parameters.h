#ifndef auxfem_algebra_solver_parameters_h
#define auxfem_algebra_solver_parameters_h

#include <auxfem/parameters/subsection_schema.h>

#include <string>

namespace auxfem
{
  /** `Solver`: linear solver. */
  struct SolverParameters
  {
    /** `auto`, `cholmod`, `klu`, `mumps`, `gmres`. */
    std::string type           = "auto";
    std::string preconditioner = "amg"; ///< `amg`, `ilu`
    /** Of an iterative solution, relative to the right-hand side. */
    double       tolerance          = 1e-8;
    unsigned int maximum_iterations = 1000;
    /** Of the analysis: `auto` takes no method that does not know
     * LinearSolver::inertia() of symmetric matrices. */
    bool needs_inertia = false;
  };

  /** `Solver`. */
  SubsectionSchema solver_schema();

  /** The values of that subsection. */
  SolverParameters read_solver(ParameterValues &values);
} // namespace auxfem

#endif
