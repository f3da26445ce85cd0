#include <auxfem/algebra/elimination_stages.h>

#include <gtest/gtest.h>
#include <support/beam_lattice.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Every @p each-th strut rigid. */
  BeamSystem some_rigid(const unsigned int dimension,
                        const BeamLattice &lattice,
                        const unsigned int each)
  {
    BeamOptions options;
    for (unsigned int strut = 0; strut < lattice.struts.size(); strut += each)
      options.rigid_struts.push_back(strut);
    return BeamSystem(dimension, lattice, options);
  }

  std::vector<double> product(const SparseMatrix        &matrix,
                              const std::vector<double> &x)
  {
    std::vector<double> local(x), y(matrix.layout->n_owned());
    local.resize(matrix.layout->n_local());
    matrix.layout->update_ghosts(local.data());
    matrix.multiply(local.data(), y.data());
    return y;
  }

  double norm(const UnknownLayout &layout, const std::vector<double> &x)
  {
    double square = 0;
    for (const double value : x)
      square += value * value;
    return std::sqrt(layout.sum(square));
  }

  double distance(const UnknownLayout       &layout,
                  std::vector<double>        x,
                  const std::vector<double> &y)
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] -= y[i];
    return norm(layout, x);
  }

  /** What is left of @p x, rotations measured in length times radian. */
  std::vector<double> part_left(const BeamSystem          &system,
                                const JointRows           &rows,
                                const std::vector<double> &x)
  {
    const Unknowns &all = *system.unknowns;
    std::map<std::pair<unsigned int, unsigned int>, double> of_place;
    for (unsigned int i = 0; i < x.size(); ++i)
      if (all.kinds[i] != UnknownKind::multiplier)
        of_place[{all.joint[i], all.component[i]}] = x[i] / all.unit(i);
    std::vector<double> left(rows.layout().n_owned());
    for (unsigned int row = 0; row < left.size(); ++row)
      if (rows.unknown(row))
        left[row] = of_place.at(
          {rows.as_unknowns().joint[row], rows.as_unknowns().component[row]});
    return left;
  }

  /** What is left has the solution of all, and all follows from it. */
  void expect_exact(const BeamSystem &system, EliminationStages &stages)
  {
    ASSERT_TRUE(stages.factorize(*system.matrix));
    const JointRows &rows = stages.rows();
    ASSERT_EQ(rows.as_unknowns().n_of(UnknownKind::multiplier), 0u);
    std::vector<double> x(system.layout->n_owned());
    for (unsigned int i = 0; i < x.size(); ++i)
      if (system.unknowns->kinds[i] != UnknownKind::prescribed)
        x[i] =
          std::sin(1. + system.layout->global(i)) * system.unknowns->unit(i);
    const std::vector<double> left = part_left(system, rows, x);

    stages.reduce(product(*system.matrix, x).data());
    const double size = norm(rows.layout(), stages.x());
    EXPECT_LE(distance(rows.layout(),
                       product(stages.matrix(), left),
                       stages.x()),
              1e-10 * size);

    stages.x() = left;
    std::vector<double> all(x.size());
    stages.expand(all.data());
    EXPECT_LT(distance(*system.layout, all, x), 1e-9 * norm(*system.layout, x));
  }
} // namespace

TEST(EliminationStages, WhatIsLeftHasTheSolutionOfAll)
{
  for (const unsigned int dimension : {2, 3})
    for (const bool has_rigid_struts : {false, true})
      {
        SCOPED_TRACE(dimension);
        const unsigned int n       = dimension == 2 ? 20 : 5;
        const BeamLattice  lattice = star_lattice(dimension, {{n, n, n}});
        BeamSystem         system =
          some_rigid(dimension,
                     lattice,
                     has_rigid_struts ? 7 : lattice.struts.size());
        EliminationStages stages(*system.unknowns);
        expect_exact(system, stages);
        EXPECT_EQ(system.layout->sum(stages.n_negative()),
                  system.unknowns->n_of(UnknownKind::multiplier));

        // Other entries of the same pattern.
        const unsigned int version = stages.version();
        for (unsigned int row = 0; row < system.layout->n_owned(); ++row)
          if (system.unknowns->kinds[row] != UnknownKind::multiplier)
            for (std::size_t i = system.matrix->first[row];
                 i < system.matrix->first[row + 1];
                 ++i)
              if (system.matrix->columns[i] == static_cast<int>(row))
                system.matrix->entries[i] *= 1.1;
        expect_exact(system, stages);
        EXPECT_EQ(stages.version(), version);
      }
}

TEST(EliminationStages, AreMadeAnewAfterASingularMatrix)
{
  const BeamLattice    lattice = star_lattice(2, {{20, 20, 1}});
  BeamSystem           system(2, lattice);
  const UnknownLayout &layout = *system.layout;
  EliminationStages    stages(*system.unknowns);
  expect_exact(system, stages);

  // A joint at the boundary without anything; one inside that does not resist
  // itself needs another order there.
  double boundary_joint = 0;
  for (unsigned int i = layout.n_owned(); i < layout.n_local(); ++i)
    boundary_joint =
      std::max<double>(boundary_joint, system.unknowns->joint[i]);
  boundary_joint                         = layout.largest(boundary_joint);
  const unsigned int        inside_joint = lattice.struts[1][1];
  const std::vector<double> entries      = system.matrix->entries;
  for (unsigned int row = 0; row < layout.n_owned(); ++row)
    for (std::size_t i = system.matrix->first[row];
         i < system.matrix->first[row + 1];
         ++i)
      {
        const unsigned int joint = system.unknowns->joint[row],
                           other =
                             system.unknowns->joint[system.matrix->columns[i]];
        if (joint == boundary_joint || other == boundary_joint ||
            (joint == inside_joint && other == inside_joint))
          system.matrix->entries[i] = 0;
      }
  EXPECT_FALSE(stages.factorize(*system.matrix));

  system.matrix->entries = entries;
  expect_exact(system, stages);
}

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
