#include <auxfem/algebra/linear_solver_method.h>

#include <deal.II/base/exceptions.h>

namespace auxfem
{
  namespace
  {
    const Choice solver_type = {
      "Type",
      "auto",
      {"auto", "cholmod", "klu", "mumps", "gmres"},
      "Direct solvers, or iterative gmres for lattices too large for these. "
      "cholmod uses the symmetric part of the tangent and excludes rigid parts "
      "and revolute hinges, for which mumps also replaces gmres. auto chooses "
      "by kind and size; the last lines of a run name the choice."};
    const Choice preconditioner = {
      "Preconditioner",
      "amg",
      {"amg", "ilu"},
      "For Type = gmres. amg: multigrid on the joints; ilu: incomplete "
      "factorization, faster for short steps dominated by inertia."};
    const Quantity solver_tolerance = {
      "Tolerance",
      "1e-8",
      "1",
      Range::open(0, 1),
      "Relative residual norm at which gmres stops."};
    const Integer solver_iterations = {
      "Maximum iterations",
      1000,
      1,
      100000,
      "Iterations of gmres before a step fails."};
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

  namespace
  {
    class DirectMethod : public LinearSolverMethod
    {
    public:
      explicit DirectMethod(std::unique_ptr<DirectSolver> solver)
        : solver(std::move(solver))
      {}

      FactorizationOutcome analyse(const SparseMatrix &matrix,
                                   const Unknowns & /*unknowns*/) override
      {
        return solver->analyse(matrix);
      }

      FactorizationOutcome factorize(const SparseMatrix &matrix) override
      {
        return solver->factorize(matrix);
      }

      std::string solve(double *x) override
      {
        solver->solve(x);
        return "";
      }

      std::optional<Inertia> inertia() const override
      {
        return solver->inertia();
      }

      std::optional<int> determinant_sign() const override
      {
        return solver->determinant_sign();
      }

      unsigned long n_iterations() const override
      {
        return 0;
      }

      std::size_t memory() const override
      {
        return solver->memory();
      }

      void forget_pivots() override
      {
        solver->forget_pivots();
      }

    private:
      const std::unique_ptr<DirectSolver> solver;
    };
  } // namespace

  std::unique_ptr<LinearSolverMethod>
  make_linear_solver_method(const LinearSolverType   type,
                            const EquationsAtJoints &equations,
                            const SolverParameters  &parameters)
  {
    const EliminationOrder order = choose_elimination_order(equations);
    switch (type)
      {
        case LinearSolverType::cholmod:
          return std::make_unique<DirectMethod>(make_cholmod(order));
        case LinearSolverType::klu:
          return std::make_unique<DirectMethod>(make_klu(order));
        case LinearSolverType::mumps:
          return std::make_unique<DirectMethod>(
            make_mumps(choose_mumps_ranks(equations)));
        case LinearSolverType::iterative:
          return make_iterative_solver(parameters);
      }
    Assert(false, dealii::ExcInternalError());
    return nullptr;
  }
} // namespace auxfem
