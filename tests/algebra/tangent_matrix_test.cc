#include <auxfem/algebra/tangent_matrix.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const std::string small_scene = frame_scene("0 0; 1 0; 0 1",
                                              "0 1; 1 2",
                                              "subsection Discretization\n"
                                              "  set Order = 1\n"
                                              "end\n"
                                              "subsection Supports\n"
                                              "  subsection wall\n"
                                              "    set Joints = 0\n"
                                              "    set Type = pin\n"
                                              "  end\n"
                                              "end\n");

  /** Random blocks on the elements and on random unknowns, and their sum. */
  struct RandomBlocks
  {
    explicit RandomBlocks(const DofNumbering &dofs)
      : n(dofs.n_unknowns())
      , n_elements(dofs.elements().size())
      , dense(n * n, 0.)
    {
      std::mt19937 generator(3);
      for (unsigned int e = 0; e < n_elements; ++e)
        unknowns.emplace_back(dofs.element_unknowns(e),
                              dofs.element_unknowns(e) + 6);
      while (unknowns.size() < n_elements + 12)
        unknowns.push_back(random_unknowns(generator));

      for (const std::vector<int> &of_block : unknowns)
        {
          const unsigned int size = of_block.size();
          values.emplace_back(size * size);
          for (unsigned int i = 0; i < size; ++i)
            for (unsigned int j = 0; j < size; ++j)
              {
                const double value          = 1. + generator() % 100;
                values.back()[i * size + j] = value;
                if (of_block[i] >= 0 && of_block[j] >= 0 &&
                    dofs.kind(of_block[i]) != UnknownKind::prescribed)
                  dense[of_block[i] * n + of_block[j]] += value;
              }
        }
      for (unsigned int i = 0; i < n; ++i)
        if (dofs.kind(i) == UnknownKind::prescribed)
          dense[i * n + i] = 1;
    }

    /** One to four of them; -1, not there, may come twice. */
    std::vector<int> random_unknowns(std::mt19937 &generator) const
    {
      const unsigned int size = 1 + generator() % 4;
      std::vector<int>   chosen;
      while (chosen.size() < size)
        {
          const int u = int(generator() % (n + 1)) - 1;
          if (u < 0 ||
              std::find(chosen.begin(), chosen.end(), u) == chosen.end())
            chosen.push_back(u);
        }
      return chosen;
    }

    void add_to(TangentMatrix &matrix) const
    {
      matrix.reset();
      for (unsigned int b = 0; b < values.size(); ++b)
        matrix.add(b, values[b].data());
    }

    unsigned int                     n, n_elements;
    std::vector<double>              dense;
    std::vector<std::vector<int>>    unknowns;
    std::vector<std::vector<double>> values;
  };

  /** The matrix as a dense one; entries are whole numbers, so sums are exact.
   */
  std::vector<double> as_dense(const TangentMatrix &matrix)
  {
    const Epetra_CrsMatrix &crs = matrix.matrix();
    const unsigned int      n   = crs.NumMyRows();
    std::vector<double>     dense(n * n, 0.);
    for (unsigned int row = 0; row < n; ++row)
      {
        int     n_entries = 0, *indices = nullptr;
        double *entries = nullptr;
        crs.ExtractMyRowView(row, n_entries, entries, indices);
        for (int k = 0; k < n_entries; ++k)
          dense[row * n + indices[k]] += entries[k];
      }
    return dense;
  }

  class TangentMatrixTest : public testing::Test
  {
  protected:
    TangentMatrixTest()
      : of_scene(small_scene, {}, MPI_COMM_SELF)
      , blocks(of_scene.dofs())
      , pattern(of_scene.dofs())
      , matrix((register_blocks(), pattern))
    {}

    /** All blocks but those of the elements. */
    void register_blocks()
    {
      for (unsigned int b = blocks.n_elements; b < blocks.unknowns.size(); ++b)
        EXPECT_EQ(pattern.register_block(blocks.unknowns[b].data(),
                                         blocks.unknowns[b].size()),
                  b);
    }

    EquationsOnRanks of_scene;
    RandomBlocks     blocks;
    TangentPattern   pattern;
    TangentMatrix    matrix;
  };
} // namespace

TEST_F(TangentMatrixTest, BlocksSumAsInADenseMatrix)
{
  blocks.add_to(matrix);
  EXPECT_EQ(as_dense(matrix), blocks.dense);
}

TEST_F(TangentMatrixTest, ResetForgetsWhatWasAdded)
{
  blocks.add_to(matrix);
  blocks.add_to(matrix);
  EXPECT_EQ(as_dense(matrix), blocks.dense);
}

TEST_F(TangentMatrixTest, PrescribedRowsAreThoseOfTheIdentity)
{
  blocks.add_to(matrix);
  const std::vector<double> dense = as_dense(matrix);
  for (unsigned int c = 0; c < 2; ++c)
    {
      const int row = of_scene.dofs().joint_unknown(0, c);
      ASSERT_EQ(of_scene.dofs().kind(row), UnknownKind::prescribed);
      for (unsigned int j = 0; j < blocks.n; ++j)
        EXPECT_EQ(dense[row * blocks.n + j], j == unsigned(row) ? 1. : 0.);
    }
}

TEST_F(TangentMatrixTest, RowSizesAreTheLargestEntries)
{
  blocks.add_to(matrix);
  const std::vector<double> sizes = matrix.row_sizes();
  ASSERT_EQ(sizes.size(), blocks.n);
  for (unsigned int i = 0; i < blocks.n; ++i)
    {
      double largest = 0;
      for (unsigned int j = 0; j < blocks.n; ++j)
        largest = std::max(largest, std::abs(blocks.dense[i * blocks.n + j]));
      EXPECT_EQ(sizes[i], largest);
    }
}

TEST_F(TangentMatrixTest, StoresNoMoreThanTheBlocksNeed)
{
  std::set<std::pair<int, int>> places;
  for (unsigned int i = 0; i < blocks.n; ++i)
    places.emplace(i, i);
  for (const auto &of_block : blocks.unknowns)
    for (const int row : of_block)
      for (const int column : of_block)
        if (row >= 0 && column >= 0)
          places.emplace(row, column);
  EXPECT_EQ(unsigned(matrix.matrix().NumMyNonzeros()), places.size());
}

TEST_F(TangentMatrixTest, AnEmptyMatrixIsZeroButInPrescribedRows)
{
  const TangentPattern elements_alone(of_scene.dofs());
  TangentMatrix        empty(elements_alone);
  empty.reset();
  for (unsigned int i = 0; i < blocks.n; ++i)
    EXPECT_EQ(empty.row_sizes()[i],
              of_scene.dofs().kind(i) == UnknownKind::prescribed ? 1. : 0.);
}

TEST_F(TangentMatrixTest, FurtherBlocksMakeANewMatrixWithTheNextReset)
{
  blocks.add_to(matrix);
  const unsigned long before    = pattern.version();
  const int           n_entries = matrix.matrix().NumMyNonzeros();
  EXPECT_EQ(matrix.version(), before);

  // Unknowns that nothing has coupled so far.
  const std::vector<double> dense     = as_dense(matrix);
  const auto                is_stored = [&](const int row, const int column) {
    int     n = 0, *indices = nullptr;
    double *entries = nullptr;
    matrix.matrix().ExtractMyRowView(row, n, entries, indices);
    return std::find(indices, indices + n, column) != indices + n;
  };
  std::array<int, 2> apart = {{-1, -1}};
  for (int i = 0; i < int(blocks.n); ++i)
    for (int j = 0; j < i; ++j)
      if (of_scene.dofs().kind(i) != UnknownKind::prescribed &&
          of_scene.dofs().kind(j) != UnknownKind::prescribed &&
          !is_stored(i, j))
        apart = {{i, j}};
  ASSERT_GE(apart[0], 0);
  const std::size_t further = pattern.register_block(apart.data(), 2);
  EXPECT_EQ(further, blocks.unknowns.size());
  EXPECT_GT(pattern.version(), before);
  // Until it is reset the matrix is the one it was.
  EXPECT_EQ(matrix.version(), before);
  EXPECT_EQ(as_dense(matrix), dense);

  blocks.add_to(matrix);
  EXPECT_EQ(matrix.version(), pattern.version());
  EXPECT_EQ(matrix.matrix().NumMyNonzeros(), n_entries + 2);
  EXPECT_EQ(as_dense(matrix), dense);
  const double values[4] = {1000, 2000, 3000, 4000};
  matrix.add(further, values);
  std::vector<double> expected = dense;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      expected[apart[i] * blocks.n + apart[j]] += values[2 * i + j];
  EXPECT_EQ(as_dense(matrix), expected);
}

TEST_F(TangentMatrixTest, AClearedPatternHasTheBlocksOfElementsAlone)
{
  blocks.add_to(matrix);
  const unsigned long before = pattern.version();
  pattern.clear();
  EXPECT_EQ(pattern.n_blocks(), blocks.n_elements);
  EXPECT_GT(pattern.version(), before);
  matrix.reset();
  TangentPattern elements_alone(of_scene.dofs());
  TangentMatrix  empty(elements_alone);
  EXPECT_EQ(matrix.matrix().NumMyNonzeros(), empty.matrix().NumMyNonzeros());

  // Registered again, the blocks lie where they lay.
  register_blocks();
  blocks.add_to(matrix);
  EXPECT_EQ(as_dense(matrix), blocks.dense);
}
