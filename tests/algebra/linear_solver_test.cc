#include <auxfem/algebra/linear_solver.h>
#include <auxfem/analysis/time_stepper.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <array>
#include <cstdlib>
#include <optional>

#include <sys/resource.h>

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
      , pattern(of_scene.equations.pattern())
      , matrix(std::make_unique<TangentMatrix>(pattern))
      , solver(of_scene.scene.solver, *matrix, of_scene.model)
    {}

    static std::vector<std::string>
    with_type(const std::string &type, std::vector<std::string> overrides)
    {
      overrides.push_back("Solver/Type=" + type);
      return overrides;
    }

    void fill(const double size)
    {
      State from = of_scene.equations.initial_state(), to = from;
      fill_by_place(of_scene.model, size, to.displacement);
      const Evaluation step = Evaluation::step(from, to, 0.3);
      of_scene.residual(step);
      // With this much mass the matrix is definite at any displacement.
      of_scene.tangent(step, {1., 5., 100.}, *matrix);
    }

    void set_right_side()
    {
      Vector rhs(of_scene.dofs().local_map());
      fill_by_place(of_scene.model, 1., rhs);
      for (unsigned int i = 0; i < of_scene.dofs().n_owned(); ++i)
        solver.right_side()[i] = rhs[i];
    }

    /** Largest |A x - b|, b being about one. */
    double residual(const Vector &x)
    {
      Epetra_Vector image(of_scene.dofs().owned_map());
      matrix->matrix().Multiply(false, x, image);
      image.Update(-1., solver.right_side(), 1.);
      double size = 0;
      image.NormInf(&size);
      return size;
    }

    EquationsOnRanks of_scene;
    /** That of the equations, to which a test may add. */
    TangentPattern                 pattern;
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
    EquationsOnRanks of_scene(star_with_everything(3, 2), overrides);
    Work             work;
    TimeStepper      stepper(of_scene.equations, of_scene.scene, work);
    Solution         solution = of_scene.equations.initial_solution();
    stepper.start(solution);
    for (unsigned int i = 0; i < 3; ++i)
      stepper.advance(solution);
    return by_name(of_scene.model, solution.state.displacement);
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
   * slender star array of n x n cells, with a step of length @p dt or, without
   * one, in statics.
   */
  unsigned long iterations_of(const unsigned int              n,
                              const std::optional<double>     dt,
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
    EquationsOnRanks of_scene(scene, overrides);
    const auto       matrix = of_scene.make_tangent();
    LinearSolver     solver(of_scene.scene.solver, *matrix, of_scene.model);
    State            from = of_scene.equations.initial_state(), to = from;
    const Evaluation evaluation =
      dt ? Evaluation::step(from, to, *dt) : Evaluation::equilibrium(from, to);
    of_scene.residual(evaluation);
    const TangentFactors factors =
      dt ? TangentFactors{1., 2 / *dt, 4 / (*dt * *dt)} : TangentFactors();
    of_scene.tangent(evaluation, factors, *matrix);
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
      add_multiple(-1., first, difference);
      double size = 0;
      difference.NormInf(&size);
      EXPECT_LT(size, round_off);

      ASSERT_TRUE(system.solver.factorize());
      system.set_right_side();
      EXPECT_LT(system.residual(system.solver.solve()), round_off);
    }
}

TEST(LinearSolver, ServesThePatternAsItIsNow)
{
  for (const std::string type : {"klu", "mumps", "gmres"})
    {
      SCOPED_TRACE(type);
      SolvableSystem      system(type, {"Solver/Tolerance=1e-13"});
      const DofNumbering &dofs = system.of_scene.dofs();
      system.fill(0.1);
      ASSERT_TRUE(system.solver.factorize());
      system.set_right_side();
      const Epetra_Vector first = system.solver.solve();

      // Springs from each joint to the next but four, which no strut connects.
      std::size_t  first_block = 0;
      unsigned int n_blocks    = 0;
      const auto   for_all     = [&](const auto &action) {
        const unsigned int n = system.of_scene.lattice.joints.size();
        for (unsigned int joint = 0; joint + 5 < n; ++joint)
          {
            const std::array<int, 2> ends = {
              {dofs.joint_unknown(joint, 0), dofs.joint_unknown(joint + 5, 0)}};
            if (ends[0] >= 0 && ends[1] >= 0)
              action(ends);
          }
      };
      for_all([&](const std::array<int, 2> &ends) {
        const std::size_t block =
          system.pattern.register_block(ends.data(), ends.size());
        if (n_blocks++ == 0)
          first_block = block;
      });
      system.fill(0.1);
      const double spring[4] = {50, -50, -50, 50};
      for (unsigned int b = 0; b < n_blocks; ++b)
        system.matrix->add(first_block + b, spring);
      ASSERT_TRUE(system.solver.factorize());
      system.set_right_side();
      const Epetra_Vector second = system.solver.solve();
      EXPECT_EQ(system.solver.failure(), "");
      // GMRES stops at 1e-13 of the norm of some 200 rows of about one.
      EXPECT_LT(system.residual(second), type == "gmres" ? 1e-11 : round_off);
      Epetra_Vector difference = second;
      add_multiple(-1., first, difference);
      double size = 0;
      difference.NormInf(&size);
      EXPECT_GT(size, 1e-3);
    }
}

TEST(LinearSolver, DirectTypesServeCouplingsOfTheInsideOfStruts)
{
  for (const std::string type : {"klu", "mumps"})
    {
      SCOPED_TRACE(type);
      SolvableSystem      system(type);
      const DofNumbering &dofs = system.of_scene.dofs();
      system.fill(0.1);
      ASSERT_TRUE(system.solver.factorize());

      // The middles of two struts, and one of them with a joint.
      const unsigned int last  = dofs.elements().size() - 1;
      const auto         inner = [&](const unsigned int e) {
        return dofs.element_unknowns(e)[2 * dofs.n_components()];
      };
      const std::array<int, 3> ends = {
        {inner(0), inner(last), dofs.element_unknowns(last / 2)[0]}};
      const std::size_t block =
        system.pattern.register_block(ends.data(), ends.size());
      system.fill(0.1);
      const double springs[9] = {50, -20, -30, -20, 40, -20, -30, -20, 50};
      system.matrix->add(block, springs);
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
    EquationsOnRanks of_scene(frame_scene("0 0; 1 0; 2 0", "0 1; 1 2", R"(
subsection Rigid parts
  subsection bar
    set Struts = 1
    set Mass = 1
  end
end
)"),
                              {"Solver/Type=gmres"});
    const auto       matrix = of_scene.make_tangent();
    LinearSolver     solver(of_scene.scene.solver, *matrix, of_scene.model);
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
  for (const std::optional<double> dt :
       {std::optional<double>(short_step), std::optional<double>()})
    {
      SCOPED_TRACE(dt ? "in a step" : "in statics");
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
