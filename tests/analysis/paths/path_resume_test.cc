#include <deal.II/base/mpi.h>

#include <analysis/simulation/expect_same.h>
#include <gtest/gtest.h>
#include <support/followed_path.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Paths of equilibria that continue from a checkpoint at each of their points,
// which holds all data of the earlier path.

namespace
{
  using Point = FollowedPath::Point;

  void expect_same(const Point &one, const Point &other)
  {
    EXPECT_EQ(one.load_factor, other.load_factor);
    EXPECT_EQ(one.arc_length, other.arc_length);
    EXPECT_EQ(one.n_negative, other.n_negative);
    EXPECT_EQ(one.determinant_sign, other.determinant_sign);
    EXPECT_EQ(one.energies.balance(0), other.energies.balance(0));
    for (unsigned int joint = 0; joint < one.motions.size(); ++joint)
      for (unsigned int c = 0; c < n_motion_components; ++c)
        EXPECT_EQ(one.motions[joint][c], other.motions[joint][c])
          << "joint " << joint << ", component " << c;
  }

  /**
   * Compares the path @p whole with @p later, which continues from a
   * checkpoint.
   */
  void expect_end_of(const FollowedPath             &whole,
                     const FollowedPath::Checkpoint &checkpoint,
                     const FollowedPath             &later)
  {
    const auto expect_same_part = [&](const auto &all, const auto &later_part) {
      ASSERT_LE(later_part.size(), all.size());
      const std::size_t first = all.size() - later_part.size();
      for (std::size_t i = 0; i < later_part.size(); ++i)
        expect_same(all[first + i], later_part[i]);
    };
    EXPECT_EQ(whole.points.size(), checkpoint.n_points + later.points.size());
    EXPECT_EQ(whole.singular_points.size(),
              checkpoint.n_singular_points + later.singular_points.size());
    expect_same_part(whole.points, later.points);
    expect_same_part(whole.singular_points, later.singular_points);
    expect_same_work(whole.result.work, later.result.work);
    EXPECT_EQ(whole.result.findings.size(), later.result.findings.size());
  }

  /** Continues from every point of a path; returns that path. */
  FollowedPath resume_everywhere(const SceneText                &scene,
                                 const std::vector<std::string> &settings = {})
  {
    FollowedPath whole(scene.str(), settings, MPI_COMM_WORLD);
    EXPECT_EQ(whole.result.exit_state, "completed");
    EXPECT_GE(whole.checkpoints.size() + 1, whole.points.size());
    for (const FollowedPath::Checkpoint &checkpoint : whole.checkpoints)
      expect_end_of(whole,
                    checkpoint,
                    FollowedPath(scene.str(),
                                 settings,
                                 MPI_COMM_WORLD,
                                 &checkpoint.records));
    return whole;
  }

  /** Expects this number of singular points after a checkpoint. */
  void expect_singular_points(const FollowedPath &path,
                              const std::size_t   n_limits,
                              const std::size_t   n_bifurcations)
  {
    EXPECT_GE(path.limits().size(), n_limits);
    EXPECT_GE(path.bifurcations().size(), n_bifurcations);
  }

  SceneText shallow_frame()
  {
    return static_frame("-12.943 0; 0 0.386; 12.943 0", "0 1; 1 2")
      .section({1.88e6, 1.88e6, 9300})
      .support("feet", "0, 2", "clamp")
      .load("weight", "1", {"0", "-80 * t", "0"})
      .mesh(3)
      .time(1, 1);
  }

  /** A buckling structure; round-off must not determine the side. */
  SceneText star()
  {
    return static_scene()
      .cells("star", 2, 2)
      .set("Lattice/Strut length", 0.01)
      .set("Lattice/Opening angle", "60 deg")
      .rectangle("all", 4e-4, 4e-4, {70e9})
      .connector("damper",
                 "standard-linear-solid",
                 "Between = in-cell | Long-time stiffness = 200 | "
                 "Spring stiffness = 100 | Damping coefficient = 1")
      .support("foot", "bottom", "clamp")
      .load("weight", "top", {"0", "-3 * t", "0"})
      .time(1, 1);
  }

  /**
   * A column in space with a rigid top under a follower load and a dead load.
   */
  SceneText rigid_top_in_space()
  {
    return static_space_frame("0 0; 0 1; 0 1.4; 0 1.5", "0 1; 1 2; 2 3")
      .space_section({1e4, 1e4, 1e4, 1, 1.7, 1})
      .support("clamp", "0", "clamp")
      .rigid_part("bar", "1", 1)
      .set("Rigid parts/bar/Elastic struts", "clamped")
      .load("weight", "3", {"0.01 * t", "-3 * t", "0"})
      .load("push", "3", {"0", "-3 * t", "0"})
      .set("Loads/push/Direction", "follows the joint")
      .mesh(2)
      .time(1, 1);
  }
} // namespace

TEST(PathResume, ThroughLimitPoints)
{
  expect_singular_points(resume_everywhere(shallow_frame()), 2, 0);
}

TEST(PathResume, OntoAnotherBranch)
{
  for (const char *branch : {"stable", "1", "0"})
    expect_singular_points(resume_everywhere(star(),
                                             {std::string("Path/Branch=") +
                                                branch,
                                              "Path/First load increment=0.1",
                                              "Path/Points=8"}),
                           0,
                           1);
}

TEST(PathResume, WithRigidPartsAndFollowerLoadsInSpace)
{
  resume_everywhere(rigid_top_in_space(),
                    {"Path/Largest displacement=0.8", "Path/Points=60"});
}

TEST(PathResume, EqualsUninterruptedPathAfterAnyEnd)
{
  const std::vector<std::string> far = {"Path/Largest load factor=0.9",
                                        "Path/Points=40"};
  const FollowedPath whole(shallow_frame().str(), far, MPI_COMM_WORLD);
  for (const char *end : {"Path/Largest load factor=0.2",
                          "Path/Points=5",
                          "Path/Largest displacement=0.1"})
    {
      std::vector<std::string> near = far;
      near.emplace_back(end);
      const FollowedPath first(shallow_frame().str(), near, MPI_COMM_WORLD);
      ASSERT_LT(first.points.size(), whole.points.size());
      // The last checkpoint is the one kept at the end.
      const FollowedPath::Checkpoint &last_checkpoint =
        first.checkpoints.back();
      expect_end_of(whole,
                    last_checkpoint,
                    FollowedPath(shallow_frame().str(),
                                 far,
                                 MPI_COMM_WORLD,
                                 &last_checkpoint.records));
    }
}

TEST(PathResume, WorksWithAnotherNumberOfRanks)
{
  const std::vector<std::string> settings = {"Path/Branch=1", "Path/Points=10"};
  const FollowedPath             whole(star().str(), settings, MPI_COMM_WORLD);
  const FollowedPath::Checkpoint &middle =
    whole.checkpoints[whole.checkpoints.size() / 2];
  // RunCheckpoints merges the data of several ranks in the same way.
  CheckpointData all;
  for (const CheckpointData &rank_data :
       dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, middle.records))
    all.add(rank_data);
  const FollowedPath later(star().str(), settings, MPI_COMM_SELF, &all);
  ASSERT_EQ(whole.points.size(), middle.n_points + later.points.size());
  for (std::size_t i = 0; i < later.points.size(); ++i)
    {
      const Point &reference_point = whole.points[middle.n_points + i];
      EXPECT_NEAR(reference_point.load_factor,
                  later.points[i].load_factor,
                  1e-8);
      EXPECT_EQ(reference_point.n_negative, later.points[i].n_negative);
    }
}
