#include <auxfem/algebra/free_block.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** The free block of a deformed star cell. */
  struct Block
  {
    explicit Block(const std::vector<std::string> &overrides)
      : of_scene(star_with_everything(1, 1), overrides, MPI_COMM_SELF)
      , from(of_scene.equations.initial_state())
      , to(from)
      , matrix(of_scene.make_tangent())
    {
      fill_by_place(of_scene.model, 0.05, to.displacement);
      if (to.velocity)
        fill_by_place(of_scene.model, 0.4, *to.velocity);
      const Evaluation step = Evaluation::step(from, to, 0.1);
      of_scene.residual(step);
      of_scene.tangent(step, {1., 20., 400.}, *matrix);
      block = free_block(*matrix, of_scene.dofs());
    }

    /** Largest |A x . y - A y . x| over their size, for irregular x and y. */
    double asymmetry() const
    {
      Epetra_Vector x(block->RowMap()), y(x), image(x);
      for (int i = 0; i < x.MyLength(); ++i)
        {
          x[i] = std::sin(1 + 1.7 * i);
          y[i] = std::cos(2 + 2.3 * i);
        }
      double forward = 0, backward = 0;
      block->Multiply(false, x, image);
      image.Dot(y, &forward);
      block->Multiply(false, y, image);
      image.Dot(x, &backward);
      return std::abs(forward - backward) / std::abs(forward);
    }

    EquationsOnRanks                  of_scene;
    State                             from, to;
    std::unique_ptr<TangentMatrix>    matrix;
    std::unique_ptr<Epetra_CrsMatrix> block;
  };
} // namespace

TEST(FreeBlock, HasTheEntriesOfFreeRowsAndColumnsOnly)
{
  const Block         trial({});
  const DofNumbering &dofs = trial.of_scene.dofs();
  EXPECT_EQ(trial.block->NumGlobalRows(), int(dofs.n_free()));
  EXPECT_LT(dofs.n_free(), dofs.n_unknowns());
  // A motion of free unknowns causes the same forces in both.
  Epetra_Vector whole(dofs.owned_map()), image(whole);
  Epetra_Vector part(trial.block->RowMap()), part_image(part);
  for (int i = 0; i < part.MyLength(); ++i)
    {
      part[i]                                        = std::sin(0.3 + 1.1 * i);
      whole[dofs.owned_map().LID(part.Map().GID(i))] = part[i];
    }
  trial.matrix->matrix().Multiply(false, whole, image);
  trial.block->Multiply(false, part, part_image);
  for (int i = 0; i < part.MyLength(); ++i)
    EXPECT_NEAR(part_image[i],
                image[dofs.owned_map().LID(part.Map().GID(i))],
                1e-12 * std::abs(part_image[i]) + 1e-12);
}

TEST(FreeBlock, IsSymmetricWithoutDashpotsOnTurningLines)
{
  // Round-off of sums of some hundred entries.
  EXPECT_LT(Block(
              {"Effects/Connector viscosity=off", "Effects/Strut damping=off"})
              .asymmetry(),
            1e-12);
  EXPECT_LT(Block({"Effects/Large rotation=off"}).asymmetry(), 1e-12);
  EXPECT_GT(Block({}).asymmetry(), 1e-9);
}
