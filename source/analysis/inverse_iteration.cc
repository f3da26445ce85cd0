#include <auxfem/analysis/inverse_iteration.h>

#include <cmath>
#include <random>

namespace auxfem
{
  namespace
  {
    /** Numbers between -1 and 1, the same on any number of ranks. */
    Vector random_mode(const UnknownLayout &layout)
    {
      Vector       mode(layout.n_local());
      std::mt19937 generator(1);
      for (unsigned int global = 0; global < layout.n_global(); ++global)
        {
          const double value = 2. * generator() / generator.max() - 1;
          if (const int local = layout.local(global); local >= 0)
            mode[local] = value;
        }
      return mode;
    }
  } // namespace

  std::optional<double>
  inverse_iteration(TangentSolver                           &solver,
                    const Vector                            &weight,
                    const std::function<bool(unsigned int)> &takes_part,
                    const unsigned int                       n_iterations,
                    Vector                                  &mode,
                    const std::function<bool(unsigned int)> &is_enough)
  {
    const UnknownLayout &layout        = solver.equations().unknowns().layout;
    const auto           restrict_mode = [&]() {
      for (unsigned int i = 0; i < mode.size(); ++i)
        if (!takes_part(i))
          mode[i] = 0;
    };
    mode = random_mode(layout);
    restrict_mode();
    double growth = 0;
    bool   solved = solver.factorize();
    for (unsigned int k = 0; solved && k < n_iterations; ++k)
      {
        const double size = layout.largest(largest_size(mode));
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          mode[i] *= weight[i] / size;
        solved = solver.solve(mode);
        restrict_mode();
        growth = layout.largest(largest_size(mode));
        solved = solved && std::isfinite(growth) && growth > 0;
        if (solved && is_enough && is_enough(k + 1))
          break;
      }
    if (!solved)
      return std::nullopt;
    return growth;
  }
} // namespace auxfem
