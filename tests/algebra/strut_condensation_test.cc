#include <auxfem/algebra/strut_condensation.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <Amesos.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A star array that nothing holds, with hinges and springs. */
  const std::string floating = R"(
subsection Lattice
  set Cell = star
  set Cells x = 3
  set Cells y = 2
  set Strut length = 0.4
  set Opening angle = 60 deg
end
subsection Sections
  subsection band
    set Shape = given
    set Area = 3
    set Shear area = 5
    set Second moment of area = 0.7
    set Young's modulus = 1
    set Poisson's ratio = 0.3
    set Density = 0.5
  end
end
subsection Joints
  subsection springs
    set Joints = tips
    set Type = rotational spring
    set Stiffness = 0.8
  end
  subsection hinges
    set Joints = notches
    set Type = hinge
  end
end
subsection Connectors
  subsection damper
    set Law = spring
    set Spring stiffness = 0.6
  end
end
)";

  const std::string floating_in_space = R"(
set Dimension = 3
subsection Lattice
  set Cell = space star
  set Cells x = 2
  set Cells z = 2
  set Strut length = 0.4
end
subsection Sections
  subsection bar
    set Shape = rectangle
    set Width = 0.2
    set Height = 0.1
    set Young's modulus = 100
    set Poisson's ratio = 0.3
    set Density = 1
  end
end
)";

  struct CondensedSystem
  {
    explicit CondensedSystem(const std::string              &text,
                             const std::vector<std::string> &overrides = {})
      : of_scene(text, overrides)
      , matrix(of_scene.make_tangent())
      , blocks(of_scene.model)
      , condensation(of_scene.dofs(), blocks, *matrix, length())
    {}

    double length() const
    {
      return of_scene.model.mean_strut_length;
    }

    /** The tangent with the factors of stiffness and mass. */
    void fill(const double mass)
    {
      State            from = of_scene.equations.initial_state(), to = from;
      const Evaluation step = Evaluation::step(from, to, 1.);
      of_scene.residual(step);
      of_scene.tangent(step, {1., 0., mass}, *matrix);
    }

    EquationsOnRanks               of_scene;
    std::unique_ptr<TangentMatrix> matrix;
    JointBlocks                    blocks;
    StrutCondensation              condensation;
  };

  /** Expects @p n rigid-body motions that the stiffness does not resist. */
  void expect_free_rigid_motion(CondensedSystem &system, const unsigned int n)
  {
    system.fill(0.);
    ASSERT_TRUE(system.condensation.condense());
    const Epetra_CrsMatrix &matrix = system.condensation.matrix();
    const auto modes = system.blocks.rigid_body_modes(system.length());
    ASSERT_EQ(modes.size(), n);
    for (const std::vector<double> &mode : modes)
      {
        Epetra_Vector motion(system.blocks.map()), force(motion);
        std::copy(mode.begin(), mode.end(), motion.Values());
        // Rows that stand for nothing are zero in the motion.
        matrix.Multiply(false, motion, force);
        double moved = 0, size = 0;
        motion.NormInf(&moved);
        force.NormInf(&size);
        EXPECT_GE(moved, 1.);
        // Rounding of condensed entries of up to 1e3.
        EXPECT_LT(size, 1e-10 * moved);
      }
  }
} // namespace

TEST(StrutCondensation, RigidMotionOfTheLatticeCostsNoForce)
{
  for (const std::string order : {"1", "3"})
    for (const std::string refinements : {"0", "2"})
      {
        SCOPED_TRACE(order + ", " + refinements);
        CondensedSystem system(floating,
                               {"Discretization/Order=" + order,
                                "Discretization/Global refinements=" +
                                  refinements});
        expect_free_rigid_motion(system, 3);
      }
}

TEST(StrutCondensation, RigidMotionInSpaceCostsNoForce)
{
  CondensedSystem system(floating_in_space);
  expect_free_rigid_motion(system, 6);
}

TEST(StrutCondensation, CondensedSolutionFulfilsAllEquations)
{
  // Supports that move, releases, connectors to the ground, joint masses.
  CondensedSystem system(star_with_everything(3, 2),
                         {"Discretization/Order=3",
                          "Discretization/Global refinements=1"});
  system.fill(100.);
  ASSERT_TRUE(system.condensation.condense());

  Vector by_place(system.of_scene.dofs().local_map());
  fill_by_place(system.of_scene.model, 1., by_place);
  Epetra_Vector b(system.of_scene.dofs().owned_map()), x(b), image(b);
  for (int i = 0; i < b.MyLength(); ++i)
    b[i] = by_place[i];

  Epetra_Vector        g(system.condensation.reduce(b)), z(g);
  Epetra_LinearProblem problem(&system.condensation.matrix(), &z, &g);
  const std::unique_ptr<Amesos_BaseSolver> klu(
    Amesos().Create("Amesos_Klu", problem));
  ASSERT_EQ(klu->SymbolicFactorization(), 0);
  ASSERT_EQ(klu->NumericFactorization(), 0);
  ASSERT_EQ(klu->Solve(), 0);
  system.condensation.expand(z, x);

  system.matrix->matrix().Multiply(false, x, image);
  add_multiple(-1., b, image);
  double error = 0;
  image.NormInf(&error);
  // Rounding of a right-hand side of one, in several stages.
  EXPECT_LT(error, 1e-11);
}

TEST(JointBlocks, EveryUnknownAtAJointHasItsOwnRow)
{
  const EquationsOnRanks of_scene(star_with_everything(3, 2));
  const DofNumbering    &dofs = of_scene.dofs();
  const JointBlocks      blocks(of_scene.model);
  const auto             names = name_unknowns(of_scene.model);
  std::vector<int>       used(blocks.map().NumMyElements(), 0);
  for (unsigned int i = 0; i < dofs.n_owned(); ++i)
    {
      const auto &[at_joint, index, fraction, component] = names[i].name;
      const bool is_inside = !at_joint && fraction > 0 && fraction < 1;
      EXPECT_EQ(blocks.strut(i), is_inside ? index : invalid_index);
      ASSERT_EQ(blocks.row(i) < 0, is_inside);
      if (is_inside)
        continue;
      const int row = blocks.map().LID(blocks.row(i));
      ASSERT_GE(row, 0);
      EXPECT_EQ(dofs.components()[row % blocks.size()], component);
      EXPECT_EQ(blocks.unknown(row), int(i));
      ++used[row];
    }
  for (unsigned int row = 0; row < used.size(); ++row)
    EXPECT_EQ(used[row], blocks.unknown(row) < 0 ? 0 : 1);
}
