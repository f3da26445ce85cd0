#include <auxfem/algebra/elimination_stages.h>

#include <gtest/gtest.h>
#include <support/beam_lattice.h>

#include <set>

using namespace auxfem;
using namespace auxfem::testing_support;

TEST(EliminationStages, LeaveJointsToTheirRanks)
{
  for (const unsigned int dimension : {2, 3})
    {
      const unsigned int n = dimension == 2 ? 20 : 5;
      const BeamSystem  system(dimension, star_lattice(dimension, {{n, n, n}}));
      EliminationStages stages(*system.unknowns);
      ASSERT_TRUE(stages.factorize(*system.matrix));
      const std::vector<unsigned int> &joints = system.unknowns->joint;
      const std::set<unsigned int>     of_rank(joints.begin(),
                                           joints.begin() +
                                             system.layout->n_owned());
      const UnknownLayout             &left = stages.rows().layout();
      EXPECT_EQ(left.n_global() > 0, left.n_ranks() > 1 || dimension == 3);
      unsigned int n_of_others = 0;
      for (unsigned int row = 0; row < left.n_owned(); ++row)
        n_of_others +=
          1 - of_rank.count(stages.rows().as_unknowns().joint[row]);
      // What went to a lower rank and was not eliminated there is back.
      EXPECT_EQ(n_of_others, 0u) << dimension;
    }
}
