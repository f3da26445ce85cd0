#include <auxfem/algebra/sparse_matrix.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace auxfem;

TEST(RowSums, UseTheGivenRowsOnly)
{
  const std::vector<double> values = {100, -1, 2, 100, 3, -4, 5, -6};
  std::vector<int>          rows;
  double                    squares = 0, largest = 0;
  for (const int row : {1, 2, 4, 5, 6, 7})
    {
      EXPECT_EQ(sum_of_squares(values.data(), rows), squares);
      EXPECT_EQ(largest_size(values.data(), rows), largest);
      rows.push_back(row);
      squares += values[row] * values[row];
      largest = std::abs(values[row]);
    }
  EXPECT_EQ(sum_of_squares(values.data(), rows), squares);
  EXPECT_EQ(largest_size(values.data(), rows), 6);
}
