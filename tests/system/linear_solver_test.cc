#include <auxfem/system/linear_solver.h>

#include <gtest/gtest.h>

#include "system_on_ranks.h"

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A supported star array with the tangent at some displacement. */
  struct SolvableSystem
  {
    explicit SolvableSystem(const std::string &type)
      : of_scene(star_with_everything(3, 2), {"Solver/Type=" + type})
      , matrix(of_scene.system.make_tangent())
      , solver(of_scene.scene.solver, *matrix, of_scene.system)
    {}

    void fill(const double size)
    {
      State from = of_scene.system.initial_state(), to = from;
      fill_by_place(of_scene.system, size, to.displacement);
      const Step step{from, to, 0.3};
      of_scene.system.begin_step(step);
      of_scene.system.residual(step);
      // With this much mass the matrix is definite at any displacement.
      of_scene.system.tangent(step, {1., 5., 100.}, *matrix);
    }

    void set_right_side()
    {
      Vector rhs(of_scene.dofs().local_map());
      fill_by_place(of_scene.system, 1., rhs);
      for (unsigned int i = 0; i < of_scene.dofs().n_owned(); ++i)
        solver.right_side()[i] = rhs[i];
    }

    /** Largest |A x - b|, b being about one. */
    double residual(const Epetra_Vector &x)
    {
      Epetra_Vector image(of_scene.dofs().owned_map());
      matrix->matrix().Multiply(false, x, image);
      image.Update(-1., solver.right_side(), 1.);
      double size = 0;
      image.NormInf(&size);
      return size;
    }

    SystemOnRanks                  of_scene;
    std::unique_ptr<TangentMatrix> matrix;
    LinearSolver                   solver;
  };

  // A direct solution leaves a backward error of a few roundings of |A| |x|.
  constexpr double round_off = 1e-12;
} // namespace

TEST(LinearSolver, SolutionFulfilsTheEquations)
{
  for (const std::string type : {"auto", "klu", "mumps"})
    {
      SCOPED_TRACE(type);
      SolvableSystem system(type);
      system.fill(0.1);
      ASSERT_TRUE(system.solver.factorize());
      system.set_right_side();
      EXPECT_LT(system.residual(system.solver.solve()), round_off);
    }
}

TEST(LinearSolver, AKeptFactorizationServesOldEquations)
{
  for (const std::string type : {"klu", "mumps"})
    {
      SCOPED_TRACE(type);
      SolvableSystem system(type);
      system.fill(0.1);
      ASSERT_TRUE(system.solver.factorize());
      system.set_right_side();
      const Epetra_Vector first = system.solver.solve();

      // New entries alone change nothing, the new factorization does.
      system.fill(0.3);
      system.set_right_side();
      Epetra_Vector difference = system.solver.solve();
      difference.Update(-1., first, 1.);
      double size = 0;
      difference.NormInf(&size);
      EXPECT_LT(size, round_off);

      ASSERT_TRUE(system.solver.factorize());
      system.set_right_side();
      EXPECT_LT(system.residual(system.solver.solve()), round_off);
    }
}

TEST(LinearSolver, ASingularMatrixIsReported)
{
  for (const std::string type : {"klu", "mumps"})
    {
      SCOPED_TRACE(type);
      SolvableSystem system(type);
      system.matrix->reset();
      EXPECT_FALSE(system.solver.factorize());
      // Regular entries are solved as if nothing had been.
      system.fill(0.1);
      ASSERT_TRUE(system.solver.factorize());
      system.set_right_side();
      EXPECT_LT(system.residual(system.solver.solve()), round_off);
    }
}
