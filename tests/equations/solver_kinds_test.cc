#include <auxfem/algebra/direct_solver.h>
#include <auxfem/algebra/linear_solver.h>
#include <auxfem/equations/node_rotations.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/run_program.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Tangents of shipped scenes, solved by every kind of solver on all ranks.

namespace
{
  /** The tangent of a scene after an irregular motion of @p size (m). */
  struct RealTangent
  {
    RealTangent(const std::string              &file,
                const std::vector<std::string> &overrides,
                const double                    size,
                const TangentFactors           &factors)
      : on_ranks(prm_text(file), overrides)
      , matrix(on_ranks.make_tangent())
    {
      const State from = on_ranks.equations.initial_state();
      State       to   = from;
      to.time          = 1e-3;
      fill_by_position(on_ranks.model, size, to.displacement);
      fill_by_position(on_ranks.model, size / to.time, *to.velocity);
      const Evaluation step = Evaluation::step(from, to, to.time);
      NodeRotations(on_ranks.model.numbering).follow(step);
      on_ranks.residual(step);
      on_ranks.tangent(step, factors, *matrix);

      right_side.resize(on_ranks.dofs().layout().n_local());
      fill_by_position(on_ranks.model, 1., right_side);
      const Unknowns &unknowns = on_ranks.equations.unknowns();
      for (unsigned int i = 0; i < right_side.size(); ++i)
        if (unknowns.kinds[i] == UnknownKind::prescribed)
          right_side[i] = 0;
    }

    /** Solution by a type of solver; checks its residual. */
    Vector solve(const std::string &type, const double largest_error) const
    {
      SCOPED_TRACE(type);
      SolverParameters parameters;
      parameters.type      = type;
      parameters.tolerance = 1e-11;
      LinearSolver solver(parameters, *matrix);
      EXPECT_EQ(solver.factorize(Exactness::exact), FactorizationOutcome::done);
      Vector x = right_side;
      EXPECT_TRUE(solver.solve(x)) << solver.last_failure();
      EXPECT_LT(backward_error(*matrix, x, right_side), largest_error);
      return x;
    }

    /** Norm of motions with rotations in metres, without multipliers. */
    double difference(const Vector &x, const Vector &y) const
    {
      const Unknowns &unknowns = on_ranks.equations.unknowns();
      double          largest = 0, size = 0;
      for (unsigned int i = 0; i < x.size(); ++i)
        if (unknowns.kinds[i] != UnknownKind::multiplier)
          {
            const double unit = unknowns.unit(i);
            largest           = std::max(largest, std::abs(x[i] - y[i]) / unit);
            size              = std::max(size, std::abs(x[i]) / unit);
          }
      return unknowns.layout.largest(largest) / unknowns.layout.largest(size);
    }

    EquationsOnRanks               on_ranks;
    std::unique_ptr<TangentMatrix> matrix;
    Vector                         right_side;
  };

  const TangentFactors statics = {1., 0., 0.}, short_step = {1., 2e5, 1e10};

  /**
   * Expects equal solutions of all types.
   * @param tolerance round-off times the condition of the tangent
   */
  void expect_same_solution(const RealTangent              &tangent,
                            const std::vector<std::string> &types,
                            const double                    tolerance)
  {
    const Vector reference = tangent.solve("mumps", 1e-12);
    for (const std::string &type : types)
      {
        SCOPED_TRACE(type);
        const double error = type == "gmres" ? 1e-9 : 1e-12;
        EXPECT_LT(tangent.difference(reference, tangent.solve(type, error)),
                  tolerance);
      }
  }

  const std::vector<std::string> plane = {"Lattice/Cells x=6",
                                          "Lattice/Cells y=6"},
                                 space = {"Lattice/Cells x=2",
                                          "Lattice/Cells y=2",
                                          "Lattice/Cells z=2"};
} // namespace

TEST(SolverKinds, SolveTangentsAtRestAlike)
{
  const std::vector<std::string> all = {"auto", "cholmod", "klu", "gmres"};
  for (const TangentFactors &factors : {statics, short_step})
    {
      expect_same_solution(RealTangent("star-10x10.prm", plane, 0., factors),
                           all,
                           1e-7);
      expect_same_solution(RealTangent("lattice-3d.prm", space, 0., factors),
                           all,
                           1e-7);
    }
}

TEST(SolverKinds, SolveUnsymmetricTangentsAlike)
{
  const std::vector<std::string> all = {"auto", "klu", "gmres"};
  for (const TangentFactors &factors : {statics, short_step})
    {
      const RealTangent plane_tangent("star-10x10.prm", plane, 1e-4, factors),
        space_tangent("lattice-3d.prm", space, 1e-4, factors);
      EXPECT_GT(space_tangent.matrix->asymmetry(), 1e-7);
      expect_same_solution(plane_tangent, all, 1e-6);
      expect_same_solution(space_tangent, all, 1e-6);
    }
}

TEST(SolverKinds, SolveConstraintsOfRigidPartsAlike)
{
  expect_same_solution(RealTangent("rigid-array.prm", {}, 1e-5, short_step),
                       {"auto", "klu", "gmres"},
                       1e-6);
}
