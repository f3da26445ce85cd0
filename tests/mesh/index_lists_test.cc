#include <auxfem/mesh/lattice.h>

#include <gtest/gtest.h>

#include <utility>

using namespace auxfem;

TEST(IndexLists, KeepTheOrderOfTheirEntries)
{
  const std::vector<std::pair<unsigned int, unsigned int>> entries = {{2, 7},
                                                                      {0, 3},
                                                                      {2, 5},
                                                                      {2, 5},
                                                                      {3, 1}};
  const IndexLists lists(4, [&entries](const auto &add) {
    for (const auto &[list, index] : entries)
      add(list, index);
  });
  const std::vector<std::vector<unsigned int>> expected = {{3},
                                                           {},
                                                           {7, 5, 5},
                                                           {1}};
  for (unsigned int list = 0; list < expected.size(); ++list)
    EXPECT_EQ(std::vector<unsigned int>(lists[list].begin(), lists[list].end()),
              expected[list]);
}
