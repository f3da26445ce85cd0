#include <auxfem/algebra/joint_order.h>

#include <gtest/gtest.h>
#include <support/beam_lattice.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace auxfem;
using namespace auxfem::testing_support;

TEST(JointRows, RigidBodyModesLeaveOutWhatIsPrescribed)
{
  const BeamSystem system(2, star_lattice(2, {{2, 2, 1}}));
  Unknowns         unknowns = *system.unknowns;
  unknowns.kinds[1]         = UnknownKind::prescribed;
  std::vector<int> all(unknowns.layout.n_owned());
  std::iota(all.begin(), all.end(), 0);
  const JointRows                        rows(unknowns, all);
  const std::vector<std::vector<double>> modes = rows.rigid_body_modes();
  ASSERT_EQ(modes.size(), 3u);
  for (unsigned int row = 0; row < rows.layout().n_owned(); ++row)
    {
      double largest = 0;
      for (const std::vector<double> &mode : modes)
        largest = std::max(largest, std::abs(mode[row]));
      const bool moves = rows.unknown(row) &&
        unknowns.kinds[*rows.unknown(row)] != UnknownKind::prescribed;
      EXPECT_EQ(largest > 0, moves) << row;
    }
}
