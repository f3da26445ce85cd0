#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/round_beam.h>

#include <array>
#include <vector>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Stiff lattices that turn freely, without any force, against rigid bodies:
// Euler's equations J W' = J W x W and P' = P [W]x, and for a body with an axis
// of symmetry their closed solution.

namespace
{
  /** Stiffnesses (N, N m2) at which strains are of about 1e-8. */
  constexpr double stiff = 1e9;

  struct Body
  {
    std::vector<SpaceVector>                 joints;
    std::vector<std::array<unsigned int, 2>> struts;

    SpaceVector mean_of_joints() const
    {
      SpaceVector sum;
      for (const SpaceVector &joint : joints)
        sum += joint;
      return sum / double(joints.size());
    }
  };

  /** A rigid body: centre of mass (m) and tensor of inertia there (kg m2). */
  struct RigidBody
  {
    SpaceVector centre;
    SpaceTensor inertia;
  };

  SpaceTensor identity()
  {
    return SpaceTensor(dealii::unit_symmetric_tensor<3>());
  }

  /** Inertia of straight struts with the section of round_beam(). */
  RigidBody rigid_body(const Body &body)
  {
    RigidBody rigid;
    double    mass = 0;
    for (const auto &strut : body.struts)
      {
        const SpaceVector &a = body.joints[strut[0]],
                          &b = body.joints[strut[1]];
        rigid.centre += (b - a).norm() * 0.5 * (a + b);
        mass += (b - a).norm();
      }
    rigid.centre /= mass;
    for (const auto &strut : body.struts)
      {
        const SpaceVector &a     = body.joints[strut[0]],
                          &b     = body.joints[strut[1]];
        const double      length = (b - a).norm();
        const SpaceVector t      = (b - a) / length,
                          r      = 0.5 * (a + b) - rigid.centre;
        const SpaceTensor along  = dealii::outer_product(t, t),
                          across = identity() - along;
        rigid.inertia += length *
          (20. * along + (10. + length * length / 12) * across +
           r.norm_square() * identity() - dealii::outer_product(r, r));
      }
    return rigid;
  }

  struct Attitude
  {
    Quaternion  rotation;
    SpaceVector angular_velocity; ///< material (rad/s)
  };

  /** Euler's equations by the classical Runge-Kutta method. */
  Attitude euler(const RigidBody &body, Attitude now, const double end)
  {
    const SpaceTensor  inverse = dealii::invert(body.inertia);
    const unsigned int n       = 20000;
    const double       dt      = end / n;
    const auto         rate    = [&](const Attitude &at) {
      return Attitude{0.5 * (at.rotation * Quaternion{0, at.angular_velocity}),
                      inverse *
                        dealii::cross_product_3d(body.inertia *
                                                   at.angular_velocity,
                                                 at.angular_velocity)};
    };
    const auto moved =
      [](const Attitude &from, const Attitude &rate, const double dt) {
        return Attitude{from.rotation + dt * rate.rotation,
                        from.angular_velocity + dt * rate.angular_velocity};
      };
    for (unsigned int i = 0; i < n; ++i)
      {
        const Attitude k1 = rate(now), k2 = rate(moved(now, k1, dt / 2)),
                       k3 = rate(moved(now, k2, dt / 2)),
                       k4 = rate(moved(now, k3, dt));
        now =
          moved(moved(moved(moved(now, k1, dt / 6), k2, dt / 3), k3, dt / 3),
                k4,
                dt / 6);
      }
    return {normalized(now.rotation), now.angular_velocity};
  }

  std::string free_body(const Body        &body,
                        const SpaceVector &angular_velocity,
                        const double       end,
                        const double       dt)
  {
    SceneText   scene = round_beam(stiff, stiff);
    std::string joints, struts;
    for (const SpaceVector &joint : body.joints)
      joints += (joints.empty() ? "" : "; ") + text(joint);
    for (const auto &strut : body.struts)
      struts += (struts.empty() ? "" : "; ") + std::to_string(strut[0]) + " " +
        std::to_string(strut[1]);
    scene.set("Lattice/Joints", joints);
    scene.set("Lattice/Struts", struts);
    scene.set("Initial velocities/spin/Joints", "all");
    set_vector(scene,
               "Initial velocities/spin/Angular velocity",
               angular_velocity);
    return scene.mesh(2, 0).time(end, dt).str();
  }

  /** Error of fourth order in dt, and strains (m). */
  constexpr double allowed_error = 1e-5;

  /** Positions of all joints at the end, extrapolated from two steps. */
  std::vector<SpaceVector> places_at_end(const Body        &body,
                                         const SpaceVector &angular_velocity,
                                         const double       end)
  {
    std::vector<SpaceVector> positions[2];
    for (unsigned int k = 0; k < 2; ++k)
      {
        SceneRun run(free_body(body, angular_velocity, end, 0.01 / (k + 1)),
                     // Round-off of the stiff struts is above 1e-11.
                     {"Time/Scheme=newmark", "Newton/Tolerance=1e-8"});
        run.run();
        for (unsigned int joint = 0; joint < body.joints.size(); ++joint)
          positions[k].push_back(body.joints[joint] +
                                 at_joint(run, run.state.displacement, joint));
      }
    for (unsigned int joint = 0; joint < body.joints.size(); ++joint)
      positions[1][joint] += (positions[1][joint] - positions[0][joint]) / 3;
    return positions[1];
  }

  void compare(ComparisonTable   &table,
               const Body        &body,
               const SpaceVector &angular_velocity,
               const double       end,
               const Quaternion  &rotation)
  {
    const RigidBody   rigid     = rigid_body(body);
    const auto        positions = places_at_end(body, angular_velocity, end);
    const SpaceVector velocity =
      dealii::cross_product_3d(angular_velocity,
                               rigid.centre - body.mean_of_joints());
    const char *axes[] = {", x", ", y", ", z"};
    for (unsigned int joint = 0; joint < positions.size(); ++joint)
      {
        const SpaceVector exact = rigid.centre + end * velocity +
          rotated(rotation, body.joints[joint] - rigid.centre);
        for (unsigned int c = 0; c < 3; ++c)
          table.row(label("joint", joint) + axes[c],
                    positions[joint][c],
                    exact[c],
                    allowed_error);
      }
  }
} // namespace

TEST(FreeRotation, AStrutPrecessesAsInTheClosedForm)
{
  const Body        strut   = {{SpaceVector({1., -2., -2.}) * (5. / 3),
                                SpaceVector({-1., 2., 2.}) * (5. / 3)},
                               {{0, 1}}};
  const SpaceVector axis    = SpaceVector({-1., 2., 2.}) / 3;
  const SpaceVector omega   = 1.5 * axis + SpaceVector({0.8, 0.2, 0.2});
  const double      end     = 30;
  const RigidBody   rigid   = rigid_body(strut);
  const SpaceVector angular = rigid.inertia * omega;
  const double      across  = 10 * (10 + 100. / 12);
  // The body turns about its axis, which turns about the moment of momentum.
  const SpaceVector precession = angular / across, spin = omega - precession;
  ComparisonTable table(label("Free spin of a straight strut, precession (rad)",
                              precession.norm() * end));
  compare(table,
          strut,
          omega,
          end,
          exponential(end * precession) * exponential(end * spin));
}

TEST(FreeRotation, AFrameFollowsEulersEquations)
{
  const Body        frame = {{SpaceVector(),
                              SpaceVector({4., 0., 0.}),
                              SpaceVector({4., 5., 1.}),
                              SpaceVector({1., 2., 4.})},
                             {{0, 1}, {1, 2}, {1, 3}}};
  const SpaceVector omega({0.5, -0.9, 1.2});
  const double      end  = 20;
  const Attitude  at_end = euler(rigid_body(frame), {Quaternion(), omega}, end);
  ComparisonTable table("Free flight of a bent frame, Euler's equations, t = "
                        "20 s");
  compare(table, frame, omega, end, at_end.rotation);
}
