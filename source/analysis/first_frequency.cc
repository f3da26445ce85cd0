#include <auxfem/analysis/first_frequency.h>
#include <auxfem/analysis/inverse_iteration.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    constexpr unsigned int n_frequency_iterations = 8;

    /** x . A x over all ranks. */
    double quadratic_form(const TangentMatrix &matrix,
                          const Vector        &x,
                          const UnknownLayout &layout)
    {
      Vector image(layout.n_owned());
      matrix.multiply(x.data(), image.data());
      double sum = 0;
      for (unsigned int i = 0; i < layout.n_owned(); ++i)
        sum += x[i] * image[i];
      return layout.sum(sum);
    }
  } // namespace

  std::optional<double> first_frequency(TangentSolver &solver,
                                        const State   &state)
  {
    const Equations  &equations = solver.equations();
    State             now       = state;
    EvaluationResults results   = equations.make_results();
    const Evaluation  instant   = Evaluation::rates(state, now);
    solver.residual(instant, results);
    TangentMatrix mass(equations.pattern());
    equations.tangent(instant, results, {0, 0, 1}, mass);

    const Evaluation at_rest = Evaluation::equilibrium(state, now);
    solver.residual(at_rest, results);
    solver.assemble(at_rest, results, {1, 0, 0});

    const Unknowns &unknowns = equations.unknowns();
    Vector          mode;
    const auto      growth = inverse_iteration(
      solver,
      mass.diagonal(),
      [&unknowns](const unsigned int i) {
        return unknowns.kinds[i] != UnknownKind::multiplier &&
          unknowns.kinds[i] != UnknownKind::prescribed;
      },
      n_frequency_iterations,
      mode);
    if (!growth)
      return std::nullopt;
    const double stiffness =
      quadratic_form(solver.matrix(), mode, unknowns.layout);
    const double inertia = quadratic_form(mass, mode, unknowns.layout);
    if (!(stiffness > 0 && inertia > 0))
      return std::nullopt;
    return std::sqrt(stiffness / inertia);
  }
} // namespace auxfem
