#include <auxfem/algebra/tangent_matrix.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

#include <algorithm>
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
