#include <auxfem/algebra/krylov_solver.h>
#include <auxfem/algebra/sparse_matrix.h>

#include <algebra/strut_network.h>
#include <gtest/gtest.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // Sums of some twenty products of numbers of about ten.
  constexpr double tangent_round_off = 1e-12;

  NetworkShape unsymmetric_shape()
  {
    NetworkShape shape;
    shape.asymmetry     = 0.4;
    shape.n_multipliers = 1;
    return shape;
  }

  void expect_product(const StrutNetwork &network, const Symmetry symmetry)
  {
    const dealii::Vector<double> x = network.right_side();
    dealii::Vector<double>       expected(x.size());
    network.dense(symmetry).vmult(expected, x);
    std::vector<double> local = network.owned(x),
                        image(network.layout->n_owned());
    network.layout->update_ghosts(local.data());
    network.matrix->multiply(local.data(), image.data(), symmetry);
    for (unsigned int i = 0; i < image.size(); ++i)
      EXPECT_NEAR(image[i],
                  expected(network.layout->global(i)),
                  tangent_round_off);
  }

  /**
   * @p expected returns the entry for a global number and whether it is free.
   */
  template <class Expected>
  void expect_diagonal(const StrutNetwork &network, const Expected &expected)
  {
    const std::vector<double> diagonal = network.matrix->diagonal();
    ASSERT_EQ(diagonal.size(), network.layout->n_owned());
    for (unsigned int i = 0; i < diagonal.size(); ++i)
      EXPECT_NEAR(diagonal[i],
                  expected(network.layout->global(i),
                           network.unknowns->kinds[i] !=
                             UnknownKind::prescribed),
                  tangent_round_off);
  }
} // namespace

TEST(TangentMatrix, MultipliesAsTheSumOfItsBlocks)
{
  StrutNetwork network(unsymmetric_shape());
  expect_product(network, Symmetry::none);
  expect_product(network, Symmetry::enforced);
  network.fill();
  expect_product(network, Symmetry::none);
}

TEST(TangentMatrix, TransposesFreeRowsAndColumns)
{
  StrutNetwork network(unsymmetric_shape());
  network.matrix->transpose();
  // Rows with prescribed columns are not used.
  dealii::Vector<double> x = network.right_side(), expected(x.size());
  const auto             is_prescribed = [&](const unsigned int global) {
    return network.unknown(global).kind == UnknownKind::prescribed;
  };
  for (unsigned int i = 0; i < x.size(); ++i)
    if (is_prescribed(i))
      x(i) = 0;
  network.dense().Tvmult(expected, x);
  std::vector<double> local = network.owned(x),
                      image(network.layout->n_owned());
  network.layout->update_ghosts(local.data());
  network.matrix->multiply(local.data(), image.data());
  for (unsigned int i = 0; i < image.size(); ++i)
    if (const unsigned int global = network.layout->global(i);
        !is_prescribed(global))
      {
        EXPECT_NEAR(image[i], expected(global), tangent_round_off);
      }
}

TEST(TangentMatrix, UpdatesItsPattern)
{
  StrutNetwork        network(unsymmetric_shape());
  const unsigned long before = network.matrix->version();
  network.pattern->reset(*network.unknowns);
  EXPECT_EQ(network.pattern->n_blocks(), 0u);
  network.matrix->reset();
  for (const double size : network.matrix->row_sizes())
    EXPECT_TRUE(size == 0 || size == 1);
  network.register_blocks();
  EXPECT_NE(network.pattern->version(), network.matrix->version());
  network.fill();
  EXPECT_GT(network.matrix->version(), before);
  expect_product(network, Symmetry::none);
}

TEST(TangentMatrix, DiagonalOfTheSum)
{
  StrutNetwork      network(unsymmetric_shape());
  const DenseMatrix dense = network.dense();
  expect_diagonal(network, [&](const int i, bool) { return dense(i, i); });
  const std::vector<double> three(network.layout->n_owned(), 3.);
  network.matrix->add_to_diagonal(three);
  network.matrix->add_to_diagonal(three);
  expect_diagonal(network, [&](const int i, const bool is_free) {
    return dense(i, i) + (is_free ? 6. : 0.);
  });
  network.matrix->set_diagonal(three);
  expect_diagonal(network,
                  [](int, const bool is_free) { return is_free ? 3. : 1.; });
  // Filling the matrix removes the addition.
  network.fill();
  expect_product(network, Symmetry::none);
}

TEST(TangentMatrix, AnUnknownMayOccurTwiceInABlock)
{
  StrutNetwork network;
  // The second free unknown of the first rank.
  const int  twice[2] = {4, 4};
  const bool is_here  = network.layout->rank() == 0;
  if (is_here)
    network.pattern->register_block(twice, 2);
  network.fill();
  const std::vector<double> before    = network.matrix->diagonal();
  const double              values[4] = {1, 2, 3, 4};
  if (is_here)
    {
      network.matrix->add(network.pattern->n_blocks() - 1, values);
      EXPECT_NEAR(network.matrix->diagonal()[4] - before[4],
                  10.,
                  tangent_round_off);
    }
}

TEST(TangentMatrix, EmptyRowsHaveNoSize)
{
  StrutNetwork network;
  for (const double size : network.matrix->row_sizes())
    EXPECT_GT(size, 0.);
  network.matrix->reset();
  const std::vector<double> sizes = network.matrix->row_sizes();
  for (unsigned int i = 0; i < sizes.size(); ++i)
    EXPECT_EQ(sizes[i],
              network.unknowns->kinds[i] == UnknownKind::prescribed ? 1. : 0.);
}

TEST(TangentMatrix, AsymmetryOfTheBlocks)
{
  EXPECT_EQ(StrutNetwork().matrix->asymmetry(), 0.);
  NetworkShape shape;
  shape.asymmetry   = 1e-6;
  const double weak = StrutNetwork(shape).matrix->asymmetry();
  EXPECT_GT(weak, 1e-8);
  EXPECT_LT(weak, 1e-5);
  shape.asymmetry     = 1e-3;
  const double strong = StrutNetwork(shape).matrix->asymmetry();
  EXPECT_NEAR(strong / weak, 1e3, 1.);
}

TEST(TangentMatrix, FreeBlockIsAssembledWithoutSupports)
{
  StrutNetwork network(unsymmetric_shape());
  network.matrix->add_to_diagonal(
    std::vector<double>(network.layout->n_owned(), 2.));
  const FreeBlock         block(*network.matrix);
  const UnknownSelection &free   = block.selection();
  const SparseMatrix     &matrix = block.matrix();
  const DenseMatrix       dense  = network.dense();
  for (unsigned int row = 0; row < free.layout.n_owned(); ++row)
    {
      const int           global = network.layout->global(free.unknowns[row]);
      std::vector<double> dense_row(network.n_unknowns(), 0.);
      for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
        dense_row[network.layout->global(free.unknowns[matrix.columns[i]])] +=
          matrix.entries[i];
      for (int column = 0; column < int(dense_row.size()); ++column)
        {
          const bool is_free =
            network.unknown(column).kind != UnknownKind::prescribed;
          const double expected =
            dense(global, column) + (column == global ? 2. : 0.);
          EXPECT_NEAR(dense_row[column],
                      is_free ? expected : 0.,
                      tangent_round_off);
        }
    }
  // Four motions are prescribed.
  EXPECT_EQ(free.layout.n_global(), network.n_unknowns() - 4);
}

TEST(ConjugateGradients, SolveWithADefiniteMatrix)
{
  NetworkShape shape;
  for (const unsigned int n_components : {3, 6})
    {
      shape.n_components = n_components;
      const StrutNetwork  network(shape);
      std::vector<double> x = network.owned(network.right_side());
      ASSERT_TRUE(solve_by_conjugate_gradients(*network.matrix, x));
      const dealii::Vector<double> expected = network.solution();
      for (unsigned int i = 0; i < x.size(); ++i)
        EXPECT_NEAR(x[i], expected(network.layout->global(i)), 1e-11);
    }
}

TEST(ConjugateGradients, RefuseAnEmptyMatrix)
{
  const StrutNetwork network;
  network.matrix->reset();
  std::vector<double> x = network.owned(network.right_side());
  EXPECT_FALSE(solve_by_conjugate_gradients(*network.matrix, x));
}
