#ifndef auxfem_tests_verification_singular_tangent_h
#define auxfem_tests_verification_singular_tangent_h

#include <support/scene_run.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /**
     * The eigenvalue of least size of the static tangent in the state of
     * @p run, by inverse iteration with free unknowns only.
     */
    inline double smallest_eigenvalue(SceneRun &run)
    {
      const State      state = run.state;
      const Evaluation step  = Evaluation::consistent_rates(state, run.state);
      run.residual(step);
      const auto matrix = run.make_tangent();
      run.tangent(step, {1, 0, 0}, *matrix);
      LinearSolver solver(run.scene.solver, *matrix);
      solver.factorize(Exactness::exact);

      const DofNumbering &numbering = run.model.numbering;
      Vector              vector(numbering.layout().n_local());
      std::mt19937        generator(1);
      for (unsigned int i = 0; i < numbering.layout().n_owned(); ++i)
        vector[i] = numbering.unknowns().kinds[i] == UnknownKind::prescribed
          ? 0
          : generator() / double(generator.max()) - 0.5;

      const auto product = [](const Vector &a, const Vector &b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
      };
      double eigenvalue = 0;
      for (unsigned int iteration = 0; iteration < 200; ++iteration)
        {
          Vector next = vector;
          EXPECT_TRUE(solver.solve(next)) << solver.last_failure();
          const double size = std::sqrt(product(next, next));
          const double before =
            std::exchange(eigenvalue, product(next, vector) / (size * size));
          for (unsigned int i = 0; i < vector.size(); ++i)
            vector[i] = next[i] / size;
          if (std::abs(eigenvalue - before) <= 1e-12 * std::abs(eigenvalue))
            break;
        }
      return eigenvalue;
    }

    /**
     * The load at which the tangent of @p scene_at becomes singular, by
     * secants from two loads near to it. The scene reaches the load at its end.
     */
    inline double
    singular_load(const std::function<std::string(double)> &scene_at,
                  double                                    first,
                  double                                    second)
    {
      const auto eigenvalue = [&](const double load) {
        SceneRun run(scene_at(load));
        run.run();
        return smallest_eigenvalue(run);
      };
      double at_first = eigenvalue(first);
      // Below it eigenvalues are round-off, whose secants lead nowhere.
      const double smallest = 5e-6 * std::abs(at_first);
      for (unsigned int i = 0; i < 20; ++i)
        {
          const double at_second = eigenvalue(second);
          const double change =
            -at_second * (second - first) / (at_second - at_first);
          first    = second;
          at_first = at_second;
          second += change;
          if (std::abs(at_second) < smallest ||
              std::abs(change) < 1e-9 * std::abs(second))
            return second;
        }
      ADD_FAILURE() << "no load found at which the tangent is singular";
      return second;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
