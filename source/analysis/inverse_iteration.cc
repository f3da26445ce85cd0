#include <auxfem/analysis/inverse_iteration.h>

#include <cmath>

namespace auxfem
{
  std::optional<double>
  inverse_iteration(TangentSolver                           &solver,
                    const Epetra_Vector                     &weight,
                    const std::function<bool(unsigned int)> &takes_part,
                    const unsigned int                       n_iterations,
                    Epetra_Vector                           &mode)
  {
    const auto restrict_mode = [&]() {
      for (int i = 0; i < mode.size(); ++i)
        if (!takes_part(i))
          mode[i] = 0;
    };
    mode.SetSeed(1);
    mode.Random();
    restrict_mode();
    double growth = 0;
    bool   solved = solver.factorize();
    for (unsigned int k = 0; solved && k < n_iterations; ++k)
      {
        double size = 0;
        mode.NormInf(&size);
        mode.Scale(1 / size);
        solver.right_side().Multiply(1., weight, mode, 0.);
        mode = solver.solve();
        restrict_mode();
        mode.NormInf(&growth);
        solved = std::isfinite(growth) && growth > 0;
      }
    if (!solved)
      return std::nullopt;
    return growth;
  }
} // namespace auxfem
