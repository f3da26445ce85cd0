#include <auxfem/system/linear_solver.h>
#include <auxfem/time/time_stepper.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <cstdlib>
#include <limits>

#include <sys/resource.h>

#include "system_on_ranks.h"

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A supported star array with the tangent at some displacement. */
  struct SolvableSystem
  {
    explicit SolvableSystem(const std::string              &type,
                            const std::vector<std::string> &overrides = {})
      : of_scene(star_with_everything(3, 2), with_type(type, overrides))
      , matrix(of_scene.system.make_tangent())
      , solver(of_scene.scene.solver, *matrix, of_scene.system)
    {}

    static std::vector<std::string>
    with_type(const std::string &type, std::vector<std::string> overrides)
    {
      overrides.push_back("Solver/Type=" + type);
      return overrides;
    }

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

  /** As long as it lives, malloc() and new give small pieces only. */
  class NoMoreMemory
  {
  public:
    NoMoreMemory()
    {
      blocks.reserve(1 << 20);
      getrlimit(RLIMIT_AS, &former);
      // What is in use stays; nothing new is given.
      const rlimit limit{0, former.rlim_max};
      setrlimit(RLIMIT_AS, &limit);
      for (std::size_t size = 1 << 26; size >= 1 << 13; size /= 2)
        while (blocks.size() < blocks.capacity())
          {
            void *const block = std::malloc(size);
            if (block == nullptr)
              break;
            blocks.push_back(block);
          }
    }

    ~NoMoreMemory()
    {
      setrlimit(RLIMIT_AS, &former);
      for (void *const block : blocks)
        std::free(block);
    }

  private:
    rlimit              former{};
    std::vector<void *> blocks;
  };

  /**
   * A star array, its top pushed, after three steps; overrides come on top.
   */
  std::map<UnknownName, double>
  after_steps(const std::vector<std::string> &overrides)
  {
    SystemOnRanks of_scene(star_with_everything(3, 2), overrides);
    TimeStepper   stepper(of_scene.system, of_scene.scene);
    State         state = of_scene.system.initial_state();
    stepper.start(state);
    for (unsigned int i = 0; i < 3; ++i)
      stepper.advance(state);
    return by_name(of_scene.system, state.displacement);
  }

  void expect_same_steps(std::vector<std::string> overrides)
  {
    const auto direct = after_steps(overrides);
    overrides.push_back("Solver/Type=gmres");
    const auto iterated = after_steps(overrides);
    // Newton's tolerance of 1e-12, times a condition of a few thousand.
    double largest = 0;
    for (const auto &[name, value] : direct)
      largest = std::max(largest, std::abs(value));
    EXPECT_GT(largest, 1e-4);
    for (const auto &[name, value] : direct)
      EXPECT_NEAR(iterated.at(name), value, 1e-8 * largest);
  }

  /** About a quarter of the first period of the struts below (s). */
  constexpr double short_step = 0.005;

  /**
   * Iterations with multigrid for one right-hand side on the joints of a
   * slender star array of n x n cells, with a step of length @p dt or, if that
   * is infinite, in statics.
   */
  unsigned long iterations_of(const unsigned int              n,
                              const double                    dt,
                              const std::vector<std::string> &overrides = {})
  {
    const std::string cells = std::to_string(n);
    const std::string scene = "subsection Lattice\n"
                              "  set Cell = star\n"
                              "  set Cells x = " +
      cells + "\n  set Cells y = " + cells + R"(
  set Strut length = 1
  set Opening angle = 60 deg
end
subsection Sections
  subsection band
    set Shape = rectangle
    set Width = 0.05
    set Height = 0.05
    set Young's modulus = 1e6
    set Poisson's ratio = 0.3
    set Density = 1
  end
end
subsection Supports
  subsection foundation
    set Joints = bottom
    set Type = clamp
  end
end
subsection Solver
  set Type = gmres
end
)";
    SystemOnRanks of_scene(scene, overrides);
    const auto    matrix = of_scene.system.make_tangent();
    LinearSolver  solver(of_scene.scene.solver, *matrix, of_scene.system);
    State         from = of_scene.system.initial_state(), to = from;
    const Step    step{from, to, dt};
    of_scene.system.begin_step(step);
    of_scene.system.residual(step);
    of_scene.system.tangent(step, {1., 2 / dt, 4 / dt / dt}, *matrix);
    EXPECT_TRUE(solver.factorize());
    for (unsigned int joint = 0; joint < of_scene.lattice.joints.size();
         ++joint)
      {
        const int unknown = of_scene.dofs().joint_unknown(joint, 0);
        if (of_scene.dofs().is_owned(unknown))
          solver.right_side()[unknown] = std::sin(7. * joint);
      }
    solver.solve();
    EXPECT_EQ(solver.failure(), "");
    return solver.n_iterations();
  }

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

TEST(LinearSolver, IterationsMeetTheirTolerance)
{
  for (const std::string preconditioner : {"amg", "ilu"})
    {
      SCOPED_TRACE(preconditioner);
      SolvableSystem system("gmres",
                            {"Solver/Preconditioner=" + preconditioner,
                             "Solver/Tolerance=1e-11"});
      for (const double size : {0.1, 0.3})
        {
          system.fill(size);
          ASSERT_TRUE(system.solver.factorize());
          system.set_right_side();
          const Epetra_Vector x = system.solver.solve();
          EXPECT_EQ(system.solver.failure(), "");
          // The tolerance is that of the norm of some 200 rows of about one.
          EXPECT_LT(system.residual(x), 1e-9);
        }
      EXPECT_GT(system.solver.n_iterations(), 0u);
    }
}

TEST(LinearSolver, TooFewIterationsAreAFailure)
{
  SolvableSystem system("gmres",
                        {"Solver/Preconditioner=ilu",
                         "Solver/Maximum iterations=1"});
  system.fill(0.1);
  ASSERT_TRUE(system.solver.factorize());
  system.set_right_side();
  Vector x(system.of_scene.dofs().local_map());
  system.solver.solve(x);
  expect_parts(system.solver.failure(),
               {"in 1 iterations", "Solver/Tolerance = 1e-08"});
  double size = 0;
  x.NormInf(&size);
  EXPECT_FALSE(std::isfinite(size));
}

TEST(LinearSolver, IterationsRefuseRigidParts)
{
  const std::string words = input_error_of([] {
    SystemOnRanks of_scene(frame_scene("0 0; 1 0; 2 0", "0 1; 1 2", R"(
subsection Rigid parts
  subsection bar
    set Struts = 1
    set Mass = 1
  end
end
)"),
                           {"Solver/Type=gmres"});
    const auto    matrix = of_scene.system.make_tangent();
    LinearSolver  solver(of_scene.scene.solver, *matrix, of_scene.system);
  });
  expect_parts(words, {"Solver/Type = gmres", "rigid parts", "`auto`"});
}

TEST(LinearSolver, DynamicStepsByIterationAreThoseOfTheDirectSolver)
{
  expect_same_steps({"Solver/Preconditioner=amg", "Newton/Tolerance=1e-12"});
  expect_same_steps({"Solver/Preconditioner=ilu", "Newton/Tolerance=1e-12"});
}

TEST(LinearSolver, StaticStepsByIterationAreThoseOfTheDirectSolver)
{
  expect_same_steps({"Time/Scheme=static", "Newton/Tolerance=1e-12"});
}

TEST(LinearSolver, IterationsDoNotDependOnWhatIsInsideStruts)
{
  const unsigned long plain = iterations_of(8, short_step);
  EXPECT_GT(plain, 3u);
  for (const std::string finer :
       {"Discretization/Order=4", "Discretization/Global refinements=2"})
    {
      SCOPED_TRACE(finer);
      // The joints' equations are the same but for the elements' error.
      EXPECT_NEAR(iterations_of(8, short_step, {finer}), plain, 2);
    }
}

TEST(LinearSolver, IterationsHardlyGrowWithTheLattice)
{
  // Inertia bounds the condition of any number of cells, in statics the coarse
  // levels do; what remains is how the aggregates happen to lie.
  for (const double dt : {short_step, std::numeric_limits<double>::infinity()})
    {
      SCOPED_TRACE(dt);
      EXPECT_LE(iterations_of(16, dt), 1.5 * iterations_of(8, dt));
    }
}

TEST(LinearSolver, LackOfMemoryIsNoSingularMatrix)
{
  // On several ranks a lack of memory may end all of them.
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    GTEST_SKIP();
  for (const std::string type : {"klu", "mumps", "gmres"})
    {
      SCOPED_TRACE(type);
      SolvableSystem system(type, {"Lattice/Cells x=8", "Lattice/Cells y=8"});
      system.fill(0.1);
      std::string message;
      {
        const NoMoreMemory no_more_memory;
        try
          {
            system.solver.factorize();
          }
        catch (const ComputationError &error)
          {
            message = error.what();
          }
      }
      EXPECT_NE(message.find("out of memory on rank 0 of 1"), std::string::npos)
        << message;
    }
}

TEST(LinearSolver, ASingularMatrixIsReported)
{
  for (const std::string type : {"klu", "mumps", "gmres"})
    {
      SCOPED_TRACE(type);
      SolvableSystem system(type);
      system.matrix->reset();
      EXPECT_FALSE(system.solver.factorize());
      // Regular entries are solved as if nothing had been.
      system.fill(0.1);
      ASSERT_TRUE(system.solver.factorize());
      system.set_right_side();
      // GMRES stops at 1e-8 of the norm of some 200 rows of about one.
      EXPECT_LT(system.residual(system.solver.solve()),
                type == "gmres" ? 1e-6 : round_off);
    }
}
