#include <auxfem/model/numbering.h>
#include <auxfem/model/unknown_records.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <algorithm>
#include <set>

using namespace auxfem;

namespace
{
  /** A lattice with mesh and numbering on the ranks of a communicator. */
  struct Numbered
  {
    Numbered(const Lattice     &lattice,
             const unsigned int order,
             const unsigned int n_elements   = 1,
             const Ties        &ties         = {},
             const MPI_Comm     communicator = MPI_COMM_WORLD)
      : Numbered(lattice,
                 std::vector<StrutDivision>(lattice.struts.size(),
                                            {order, n_elements}),
                 ties,
                 communicator)
    {}

    /** With elements by strut. */
    Numbered(const Lattice                    &lattice,
             const std::vector<StrutDivision> &divisions,
             const Ties                       &ties,
             const MPI_Comm                    communicator)
      : lattice(lattice)
      , partition(this->lattice, divisions, communicator)
      , dofs(this->lattice, partition, complete(ties), communicator)
    {}

    Ties complete(Ties ties) const
    {
      ties.released.resize(lattice.struts.size(), {{false, false}});
      return ties;
    }

    const Lattice        lattice;
    const StrutPartition partition;
    const DofNumbering   dofs;
  };

  /** Joint 0 in the middle, joints 1, 2, 3 around it, strut i from 0 to i + 1.
   */
  Lattice tripod()
  {
    return make_array(cell_from_text("frame",
                                     "set Joints = 0 0; 1 0; 0 1; -1 0\n"
                                     "set Struts = 0 1; 0 2; 0 3")
                        ->build(),
                      {{1, 1, 1}});
  }

  unsigned int sum_over_ranks(const unsigned int value)
  {
    return dealii::Utilities::MPI::sum(value, MPI_COMM_WORLD);
  }
} // namespace

TEST(Numbering, ElementsOfUnequalStrutsHaveNumbersOfTheirOwn)
{
  const Numbered         numbered(tripod(),
                          {{2, 2}, {2, 1}, {2, 3}},
                          {},
                          MPI_COMM_SELF);
  std::set<unsigned int> numbers;
  for (unsigned int e = 0; e < numbered.dofs.elements().size(); ++e)
    numbers.insert(numbered.dofs.number_in_lattice(e));
  EXPECT_EQ(numbers, (std::set<unsigned int>{0, 1, 2, 3, 4, 5}));
}

TEST(DofNumbering, FourByFourStarsHave1080UnknownsAtOrderTwo)
{
  // 16 x 12 struts with one inner node, 168 joints, 3 unknowns each.
  const Numbered stars_4x4(array_of_stars(4, 4), 2);
  EXPECT_EQ(stars_4x4.lattice.struts.size(), 192u);
  EXPECT_EQ(stars_4x4.lattice.joints.size(), 168u);
  EXPECT_EQ(stars_4x4.dofs.layout().n_global(), 3u * (192 + 168));
  EXPECT_EQ(stars_4x4.dofs.layout().n_global(), 1080u);
  EXPECT_EQ(stars_4x4.dofs.unknowns().n_free(), 1080u);

  // Four stub ends at the bottom are clamped.
  Ties clamped;
  for (const unsigned int joint : stars_4x4.lattice.joint_sets.at("bottom"))
    for (const unsigned int c : stars_4x4.dofs.components())
      clamped.prescribed.push_back({joint, c});
  const Numbered held(array_of_stars(4, 4), 2, 1, clamped);
  EXPECT_EQ(held.dofs.unknowns().n_free(), 1080u - 12u);
  EXPECT_EQ(held.dofs.layout().n_global(), 1080u);
}

TEST(DofNumbering, CountsFollowFromOrderAndNumberOfElements)
{
  for (unsigned int order = 1; order <= 6; ++order)
    for (unsigned int n_elements = 1; n_elements <= 4; ++n_elements)
      {
        const Numbered     tripods(tripod(), order, n_elements);
        const unsigned int inner_nodes = order * n_elements - 1;
        EXPECT_EQ(tripods.dofs.layout().n_global(), 3 * (4 + 3 * inner_nodes));
        EXPECT_EQ(tripods.dofs.groups().at(0).order, order);
      }
}

TEST(DofNumbering, StrutsOfDifferentElementsShareJointsOnly)
{
  for (const unsigned int n : {1u, 2u, 3u})
    {
      const Numbered      tripods(tripod(),
                             {{4, n}, {1, n}, {4, 5}},
                             {},
                             MPI_COMM_WORLD);
      const DofNumbering &dofs = tripods.dofs;
      EXPECT_EQ(dofs.layout().n_global(),
                3 * (4 + (4 * n - 1) + (n - 1) + (4 * 5 - 1)));
      ASSERT_EQ(dofs.groups().size(), 2u);
      EXPECT_EQ(dofs.groups()[0].order, 1u);
      EXPECT_EQ(dofs.groups()[1].order, 4u);
      EXPECT_EQ(dofs.groups()[0].end, dofs.groups()[1].begin);
      EXPECT_EQ(dofs.groups()[1].end, dofs.elements().size());

      for (const DofNumbering::Group &group : dofs.groups())
        for (unsigned int e = group.begin; e < group.end; ++e)
          {
            const StrutInterval &interval = dofs.elements()[e].interval;
            const Strut         &strut = tripods.lattice.struts[interval.strut];
            EXPECT_EQ(dofs.elements()[e].order, group.order);
            EXPECT_EQ(dofs.divisions()[interval.strut].order, group.order);
            EXPECT_EQ(dofs.n_element_unknowns(e), 3 * (group.order + 1));
            for (unsigned int node = 0; node <= group.order; ++node)
              {
                const int unknown = dofs.element_unknowns(e)[3 * node];
                if (interval.is_joint(node))
                  EXPECT_EQ(unknown, dofs.joint_unknown(strut.joints[node], 0));
                else
                  EXPECT_EQ(dofs.unknowns().strut[unknown], interval.strut);
              }
          }
    }
}

TEST(DofNumbering, StrutsShareTheUnknownsOfTheirJoint)
{
  const Numbered tripods(tripod(), 3, 1, {}, MPI_COMM_SELF);
  ASSERT_EQ(tripods.dofs.elements().size(), 3u);
  for (unsigned int e = 0; e < 3; ++e)
    {
      const Strut &strut =
        tripods.lattice.struts[tripods.dofs.elements()[e].interval.strut];
      const int *unknowns = tripods.dofs.element_unknowns(e);
      for (unsigned int end = 0; end < 2; ++end)
        for (unsigned int c = 0; c < 3; ++c)
          EXPECT_EQ(unknowns[3 * end + c],
                    tripods.dofs.joint_unknown(strut.joints[end],
                                               tripods.dofs.components()[c]));
    }
  for (unsigned int s = 0; s < 3; ++s)
    EXPECT_EQ(tripods.dofs.end_rotation(s, 0),
              tripods.dofs.joint_unknown(0, rotation_z));
}

TEST(DofNumbering, ElementsOfAStrutShareTheNodeBetweenThem)
{
  const Numbered        tripods(tripod(), 2, 2, {}, MPI_COMM_SELF);
  std::set<int>         unknowns;
  const DofNumbering   &dofs = tripods.dofs;
  std::vector<unsigned> first_strut_elements;
  for (unsigned int e = 0; e < dofs.elements().size(); ++e)
    if (dofs.elements()[e].interval.strut == 0)
      first_strut_elements.push_back(e);
  ASSERT_EQ(first_strut_elements.size(), 2u);
  const int *first  = dofs.element_unknowns(first_strut_elements[0]),
            *second = dofs.element_unknowns(first_strut_elements[1]);
  if (dofs.elements()[first_strut_elements[0]].interval.begin > 0)
    std::swap(first, second);
  for (unsigned int c = 0; c < 3; ++c)
    EXPECT_EQ(first[3 + c], second[c]);
  unknowns.insert(first, first + 9);
  unknowns.insert(second, second + 9);
  EXPECT_EQ(unknowns.size(), 15u);
}

TEST(DofNumbering, AReleasedEndHasARotationOfItsOwn)
{
  Ties ties;
  ties.released = {{{true, false}}, {{false, false}}, {{false, false}}};
  const Numbered tripods(tripod(), 2, 1, ties, MPI_COMM_SELF);
  EXPECT_EQ(tripods.dofs.layout().n_global(), 3u * (4 + 3) + 1);
  EXPECT_TRUE(tripods.dofs.joint_has(0, rotation_z));
  EXPECT_NE(tripods.dofs.end_rotation(0, 0),
            tripods.dofs.joint_unknown(0, rotation_z));
  EXPECT_EQ(tripods.dofs.end_rotation(1, 0),
            tripods.dofs.joint_unknown(0, rotation_z));
  EXPECT_TRUE(
    tripods.dofs.unknowns().is_rotation[tripods.dofs.end_rotation(0, 0)]);
}

TEST(DofNumbering, AJointWithAllStrutsReleasedHasNoRotation)
{
  Ties ties;
  ties.released = {{{true, false}}, {{true, false}}, {{true, false}}};
  const Numbered tripods(tripod(), 2, 1, ties, MPI_COMM_SELF);
  EXPECT_EQ(tripods.dofs.layout().n_global(), 3u * (4 + 3) + 2);
  EXPECT_FALSE(tripods.dofs.joint_has(0, rotation_z));
  EXPECT_EQ(tripods.dofs.joint_unknown(0, rotation_z), -1);
  EXPECT_TRUE(tripods.dofs.joint_has(0, 0));
  std::set<int> rotations;
  for (unsigned int s = 0; s < 3; ++s)
    rotations.insert(tripods.dofs.end_rotation(s, 0));
  EXPECT_EQ(rotations.size(), 3u);
}

TEST(DofNumbering, AJointWithoutStrutsHasDisplacementsOnly)
{
  Lattice lattice = tripod();
  lattice.joints.push_back({5, 5, 0});
  Ties ties;
  ties.connected = {{0, 4, 0}};
  const Numbered numbered(lattice, 1, 1, ties);
  EXPECT_EQ(numbered.dofs.layout().n_global(), 3u * 4 + 2);
  EXPECT_TRUE(numbered.dofs.joint_has(4, 1));
  EXPECT_FALSE(numbered.dofs.joint_has(4, rotation_z));
}

TEST(DofNumbering, WordsNameJointOrStrutAndComponent)
{
  const Numbered tripods(tripod(), 2, 1, {}, MPI_COMM_SELF);
  const auto    &dofs = tripods.dofs;
  EXPECT_EQ(describe(dofs, dofs.joint_unknown(3, 0)),
            "horizontal displacement of joint 3 at (-1, 0)");
  EXPECT_EQ(describe(dofs, dofs.joint_unknown(2, 1)),
            "vertical displacement of joint 2 at (0, 1)");
  EXPECT_EQ(describe(dofs, dofs.joint_unknown(0, rotation_z)),
            "rotation of joint 0 at (0, 0)");
  for (unsigned int e = 0; e < 3; ++e)
    if (dofs.elements()[e].interval.strut == 1)
      {
        EXPECT_EQ(describe(dofs, dofs.element_unknowns(e)[3 * 2 + 2]),
                  "rotation of strut 1 (joints 0 - 2)");
      }
}

TEST(DofNumbering, WordsForAReleasedEndNameItsStrut)
{
  Ties ties;
  ties.released = {{{true, false}}, {{true, false}}, {{true, false}}};
  const Numbered tripods(tripod(), 2, 1, ties, MPI_COMM_SELF);
  EXPECT_EQ(describe(tripods.dofs, tripods.dofs.end_rotation(2, 0)),
            "rotation of strut 2 (joints 0 - 3)");
}

TEST(DofNumbering, KindsDistinguishRotationsAndPrescribedUnknowns)
{
  const Numbered free(tripod(), 2, 1, {}, MPI_COMM_SELF);
  const int      x = free.dofs.joint_unknown(1, 0),
            r      = free.dofs.joint_unknown(1, rotation_z);
  EXPECT_EQ(free.dofs.unknowns().kinds[x], UnknownKind::translation);
  EXPECT_EQ(free.dofs.unknowns().kinds[r], UnknownKind::rotation);
  EXPECT_FALSE(free.dofs.unknowns().is_rotation[x]);
  Ties ties;
  ties.prescribed = {{1, rotation_z}};
  const Numbered held(tripod(), 2, 1, ties, MPI_COMM_SELF);
  EXPECT_EQ(held.dofs.unknowns().kinds[held.dofs.joint_unknown(1, rotation_z)],
            UnknownKind::prescribed);
  EXPECT_TRUE(
    held.dofs.unknowns().is_rotation[held.dofs.joint_unknown(1, rotation_z)]);
}

TEST(DofNumbering, NeighbouringUnknownsOfOneRankHaveEveryNumberOnce)
{
  const Numbered self(array_of_stars(2, 2), 3, 1, {}, MPI_COMM_SELF);
  EXPECT_EQ(self.dofs.layout().n_owned(), self.dofs.layout().n_global());
  EXPECT_EQ(self.dofs.layout().n_local(), self.dofs.layout().n_global());
  std::set<int> unknowns;
  for (unsigned int e = 0; e < self.dofs.elements().size(); ++e)
    unknowns.insert(self.dofs.element_unknowns(e),
                    self.dofs.element_unknowns(e) + 12);
  EXPECT_EQ(unknowns.size(), self.dofs.layout().n_global());
  EXPECT_EQ(*unknowns.begin(), 0);
  EXPECT_EQ(*unknowns.rbegin(), int(self.dofs.layout().n_global()) - 1);
}

TEST(DofNumbering, OwnedUnknownsOfAllRanksAreDisjointAndComplete)
{
  const Numbered numbered(array_of_stars(3, 3), 2);
  const auto    &dofs = numbered.dofs;
  EXPECT_EQ(sum_over_ranks(dofs.layout().n_owned()), dofs.layout().n_global());
  EXPECT_GT(dofs.layout().n_owned(), 0u);
  const UnknownLayout &layout = dofs.layout();
  for (unsigned int g = 0; g < layout.n_global(); ++g)
    EXPECT_EQ(sum_over_ranks(layout.is_owned(layout.local(g))), 1u);
  EXPECT_EQ(dofs.layout().n_ranks(),
            dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
}

TEST(DofNumbering, LocalUnknownsBeginWithTheOwnedOnes)
{
  const Numbered numbered(array_of_stars(3, 3), 2);
  const auto    &dofs = numbered.dofs;
  ASSERT_GE(dofs.layout().n_local(), dofs.layout().n_owned());
  std::set<int> seen;
  for (unsigned int i = 0; i < dofs.layout().n_local(); ++i)
    {
      EXPECT_EQ(dofs.layout().is_owned(int(i)), i < dofs.layout().n_owned());
      const int global = dofs.layout().global(i);
      EXPECT_EQ(dofs.layout().owner(global) == dofs.layout().rank(),
                i < dofs.layout().n_owned());
      EXPECT_EQ(dofs.layout().local(global), int(i));
      seen.insert(global);
    }
  EXPECT_EQ(seen.size(), dofs.layout().n_local());
  EXPECT_FALSE(dofs.layout().is_owned(-1));
}

TEST(DofNumbering, GhostsReceiveTheValuesOfTheirOwners)
{
  const Numbered numbered(array_of_stars(3, 3), 2);
  const auto    &dofs   = numbered.dofs;
  const auto    &layout = dofs.layout();
  Vector         local(layout.n_local());
  for (unsigned int i = 0; i < layout.n_owned(); ++i)
    local[i] = std::sqrt(1. + layout.global(i));
  layout.update_ghosts(local.data());
  for (unsigned int i = 0; i < layout.n_local(); ++i)
    EXPECT_EQ(local[i], std::sqrt(1. + layout.global(i)));
}

TEST(DofNumbering, EveryElementIsOwnedOnceAndKeptWhereItHasARow)
{
  const Numbered     numbered(array_of_stars(3, 3), 2, 2);
  const auto        &dofs = numbered.dofs;
  const unsigned int n    = 9;

  std::vector<unsigned int> owned(2 * numbered.lattice.struts.size(), 0);
  for (unsigned int e = 0; e < dofs.elements().size(); ++e)
    {
      const DofNumbering::Element &element  = dofs.elements()[e];
      const int                   *unknowns = dofs.element_unknowns(e);
      EXPECT_TRUE(std::any_of(unknowns, unknowns + n, [&](const int u) {
        return dofs.layout().is_owned(u);
      }));
      EXPECT_TRUE(std::all_of(unknowns, unknowns + n, [&](const int u) {
        return u >= 0 && u < int(dofs.layout().n_local());
      }));
      owned[2 * element.interval.strut + (element.interval.begin > 0)] +=
        element.is_owned;
    }
  dealii::Utilities::MPI::sum(owned, MPI_COMM_WORLD, owned);
  EXPECT_EQ(owned, std::vector<unsigned int>(owned.size(), 1));
}

TEST(DofNumbering, AllElementsAtAnOwnedUnknownAreKept)
{
  // The number of elements that touch a joint's owned unknown is the number of
  // struts that end there: rows are complete without communication.
  const Numbered            numbered(array_of_stars(3, 3), 1);
  const auto               &dofs = numbered.dofs;
  std::vector<unsigned int> n_struts(numbered.lattice.joints.size(), 0);
  for (const Strut &strut : numbered.lattice.struts)
    for (const unsigned int joint : strut.joints)
      ++n_struts[joint];
  std::vector<unsigned int> n_elements(dofs.layout().n_local(), 0);
  for (unsigned int e = 0; e < dofs.elements().size(); ++e)
    for (unsigned int i = 0; i < 6; ++i)
      ++n_elements[dofs.element_unknowns(e)[i]];
  for (unsigned int joint = 0; joint < n_struts.size(); ++joint)
    for (const unsigned int c : dofs.components())
      if (dofs.layout().is_owned(dofs.joint_unknown(joint, c)))
        {
          EXPECT_EQ(n_elements[dofs.joint_unknown(joint, c)], n_struts[joint]);
        }
}

TEST(DofNumbering, BothEndsOfAConnectorAreKeptWhereOneIsOwned)
{
  const Lattice lattice = array_of_stars(3, 3);
  // Far apart, so that on several ranks some pairs have two owners.
  const unsigned int last = lattice.joints.size() - 1;
  Ties               ties;
  for (unsigned int i = 0; i < 10; ++i)
    ties.connected.push_back({i, last - i, 0});
  ties.connected.push_back({20, invalid_index, 0});
  const Numbered numbered(lattice, 2, 1, ties);
  for (const JointPair &pair : ties.connected)
    if (pair.second != invalid_index)
      for (const auto &[mine, other] : {std::pair(pair.first, pair.second),
                                        std::pair(pair.second, pair.first)})
        if (numbered.dofs.layout().is_owned(
              numbered.dofs.joint_unknown(mine, 0)))
          {
            EXPECT_GE(numbered.dofs.joint_unknown(other, 0), 0);
            EXPECT_GE(numbered.dofs.joint_unknown(other, 1), 0);
          }
}

TEST(DofNumbering, BothRotationsOfASpringAreKeptWhereOneIsOwned)
{
  const Lattice lattice = array_of_stars(3, 3);
  Ties          ties;
  ties.released.assign(lattice.struts.size(), {{true, true}});
  // At every joint between the first strut and all others.
  std::vector<std::vector<RotationOwner>> ends(lattice.joints.size());
  for (unsigned int s = 0; s < lattice.struts.size(); ++s)
    for (unsigned int end = 0; end < 2; ++end)
      ends[lattice.struts[s].joints[end]].push_back(
        {RotationOwner::Kind::strut_end, s, end});
  for (unsigned int joint = 0; joint < ends.size(); ++joint)
    for (const RotationOwner &end : ends[joint])
      if (!(end == ends[joint].front()))
        ties.sprung.push_back({joint, ends[joint].front(), end});
  const Numbered numbered(lattice, 1, 1, ties);
  const auto    &dofs = numbered.dofs;

  EXPECT_GT(ties.sprung.size(), 0u);
  for (const RotationPair &pair : ties.sprung)
    {
      const int base = dofs.rotation_unknown(pair.base, rotation_z),
                end  = dofs.rotation_unknown(pair.end, rotation_z);
      if (!dofs.layout().is_owned(base) && !dofs.layout().is_owned(end))
        continue;
      for (const int rotation : {base, end})
        {
          ASSERT_GE(rotation, 0);
          EXPECT_TRUE(dofs.unknowns().is_rotation[rotation]);
        }
    }
}

TEST(DofNumbering, WordsForAGhostAreThoseOfItsOwner)
{
  const Numbered numbered(array_of_stars(3, 3), 1);
  const Numbered self(array_of_stars(3, 3), 1, 1, {}, MPI_COMM_SELF);
  for (unsigned int joint = 0; joint < numbered.lattice.joints.size(); ++joint)
    for (const unsigned int c : numbered.dofs.components())
      if (const int unknown = numbered.dofs.joint_unknown(joint, c);
          unknown >= 0)
        {
          EXPECT_EQ(describe(numbered.dofs, unknown),
                    describe(self.dofs, self.dofs.joint_unknown(joint, c)));
          EXPECT_EQ(numbered.dofs.unknowns().is_rotation[unknown],
                    c >= first_rotation);
        }
}

namespace
{
  /**
   * The tripod with struts 0 and 1 as one rigid part of joints 1, 2, 0; strut
   * 2, from joint 0 to joint 3, stays elastic.
   */
  Lattice tripod_with_rigid_part(const bool clamps_struts)
  {
    Lattice   lattice = tripod();
    RigidPart part;
    part.joints        = {1, 2, 0};
    part.struts        = {0, 1};
    part.clamps_struts = clamps_struts;
    lattice.rigid_parts.push_back(part);
    lattice.struts[0].rigid_part = lattice.struts[1].rigid_part = 0;
    return lattice;
  }
} // namespace

TEST(DofNumbering, JointsOfRigidPartsAloneHaveNoRotation)
{
  const Numbered hinged(tripod_with_rigid_part(false), 2, 1, {}, MPI_COMM_SELF);
  const auto    &dofs = hinged.dofs;
  // One strut with three nodes, two more joints, 2 * 3 - 3 constraints.
  EXPECT_EQ(dofs.layout().n_global(), 3u * 3 + 2 * 2 + 3);
  EXPECT_EQ(dofs.constraints().n_multipliers(), 3u);
  EXPECT_EQ(dofs.constraints().n_multipliers(0), 3u);
  EXPECT_TRUE(dofs.constraints().clamped_joints(0).empty());
  for (const unsigned int joint : {1u, 2u})
    {
      EXPECT_TRUE(dofs.joint_has(joint, 1));
      EXPECT_FALSE(dofs.joint_has(joint, rotation_z));
    }
  EXPECT_TRUE(dofs.joint_has(0, rotation_z));
  EXPECT_EQ(dofs.end_rotation(0, 0), -1);
  EXPECT_EQ(dofs.end_rotation(2, 0), dofs.joint_unknown(0, rotation_z));
  ASSERT_EQ(dofs.elements().size(), 1u);
  EXPECT_EQ(dofs.elements()[0].interval.strut, 2u);
  // Multipliers are matrix unknowns but no degrees of freedom.
  EXPECT_EQ(dofs.unknowns().n_free(), dofs.layout().n_global() - 3);
  EXPECT_EQ(dofs.unknowns().kinds[dofs.constraints().multiplier(0, 2)],
            UnknownKind::multiplier);
  EXPECT_EQ(describe(dofs, dofs.constraints().multiplier(0, 0)),
            "constraint of the rigid part of joints 1 2 0");
}

TEST(DofNumbering, AClampedRotationHasAConstraintOfItsOwn)
{
  const Numbered clamped(tripod_with_rigid_part(true), 2, 1, {}, MPI_COMM_SELF);
  EXPECT_EQ(clamped.dofs.layout().n_global(), 3u * 3 + 2 * 2 + 4);
  EXPECT_EQ(clamped.dofs.constraints().clamped_joints(0),
            std::vector<unsigned int>{0});
  // A released end does not belong to the joint.
  Ties ties;
  ties.released = {{{false, false}}, {{false, false}}, {{true, false}}};
  const Numbered released(tripod_with_rigid_part(true),
                          2,
                          1,
                          ties,
                          MPI_COMM_SELF);
  EXPECT_TRUE(released.dofs.constraints().clamped_joints(0).empty());
  EXPECT_EQ(released.dofs.constraints().n_multipliers(), 3u);
}

TEST(DofNumbering, ARigidPartIsKeptWholeWhereItHasARow)
{
  // Every second strut of a row of stars as a part of its own.
  Lattice lattice = array_of_stars(3, 3);
  for (unsigned int s = 0; s < lattice.struts.size(); s += 2)
    {
      RigidPart part;
      part.joints.assign(lattice.struts[s].joints.begin(),
                         lattice.struts[s].joints.end());
      part.struts                  = {s};
      part.clamps_struts           = true;
      lattice.struts[s].rigid_part = lattice.rigid_parts.size();
      lattice.rigid_parts.push_back(part);
    }
  const Numbered numbered(lattice, 1);
  const auto    &dofs = numbered.dofs;
  EXPECT_EQ(sum_over_ranks(dofs.layout().n_owned()), dofs.layout().n_global());

  const std::vector<unsigned int> &kept = dofs.constraints().rigid_parts();
  unsigned int                     n_owned_first = 0;
  for (unsigned int p = 0; p < lattice.rigid_parts.size(); ++p)
    {
      std::vector<int> unknowns;
      for (unsigned int i = 0; i < dofs.constraints().n_multipliers(p); ++i)
        unknowns.push_back(dofs.constraints().multiplier(p, i));
      for (const unsigned int joint : lattice.rigid_parts[p].joints)
        for (unsigned int c = 0; c < 2; ++c)
          unknowns.push_back(dofs.joint_unknown(joint, c));
      for (const unsigned int joint : dofs.constraints().clamped_joints(p))
        unknowns.push_back(dofs.joint_unknown(joint, rotation_z));
      n_owned_first += dofs.layout().is_owned(unknowns[0]);
      const bool has_row =
        std::any_of(unknowns.begin(), unknowns.end(), [&](const int unknown) {
          return dofs.layout().is_owned(unknown);
        });
      EXPECT_EQ(std::binary_search(kept.begin(), kept.end(), p), has_row);
      if (has_row)
        {
          EXPECT_EQ(std::count(unknowns.begin(), unknowns.end(), -1), 0);
          EXPECT_EQ(dofs.unknowns().kinds[dofs.constraints().multiplier(p, 0)],
                    UnknownKind::multiplier);
        }
    }
  EXPECT_EQ(sum_over_ranks(n_owned_first), lattice.rigid_parts.size());
}
