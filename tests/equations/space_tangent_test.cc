#include <auxfem/equations/node_rotations.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

#include <random>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A frame in space with everything a scene may have. */
  const std::string frame_with_everything = R"(
set Dimension = 3
subsection Lattice
  set Cell = frame
  set Joints = 0 0 0; 1 0 0.2; 1 1 0; 0.2 1 1; 1.2 0.3 1; 1.8 0.9 0.9; 0.3 1.9 1
  set Struts = 0 1; 1 2 0.2 0 0.3 1; 2 3; 3 4; 4 1; 4 5; 3 6
end
subsection Sections
  subsection band
    set Shape = given
    set Area = 3
    set Shear area = 5
    set Shear area 3 = 4
    set Second moment of area = 0.7
    set Second moment of area 2 = 0.4
    set Torsion constant = 0.5
    set Young's modulus = 1
    set Poisson's ratio = 0.3
    set Density = 0.5
    set Stiffness-proportional damping = 0.3
    set Mass-proportional damping = 0.4
  end
end
subsection Joints
  subsection spring
    set Joints = 1
    set Struts = 4
    set Type = rotational spring
    set Stiffness = 0.8
  end
  subsection hinge
    set Joints = 2
    set Struts = 2
    set Type = hinge
  end
  subsection door
    set Joints = 3
    set Struts = 3
    set Type = revolute
    set Axis = 1 2 3
  end
end
subsection Rigid parts
  subsection bar
    set Struts = 6
    set Mass = 0.7
    set Rotary inertia = 0.2 0.3 0.4
    set Elastic struts = clamped
  end
end
subsection Connectors
  subsection damper
    set Law = kelvin-voigt
    set Between = 0 3; 1 6
    set Spring stiffness = 0.6
    set Damping coefficient = 0.9
  end
  subsection relaxing
    set Law = maxwell
    set Between = 2 4
    set Spring stiffness = 0.7
    set Damping coefficient = 0.8
  end
  subsection slide
    set Law = spring
    set Between = ground: 5
    set Geometry = direction
    set Direction = 1 2 -1
    set Ground offset = 0.1 0.5 0.2
    set Spring stiffness = 0.5
  end
end
subsection Supports
  subsection wall
    set Joints = 0
    set Type = clamp
  end
  subsection mover
    set Joints = 2
    set Type = prescribed
    set Displacement z = 0.1 * t
  end
end
subsection Masses
  subsection top
    set Joints = 4, 5
    set Mass = 0.6
    set Rotary inertia = 0.1 0.2 0.3
  end
end
subsection Loads
  subsection dead
    set Joints = 4
    set Force x = 0.3
    set Moment y = 0.4
  end
  subsection following
    set Joints = 5
    set Direction = follows the joint
    set Force x = 0.5
    set Force z = -0.7
    set Moment x = 0.4
    set Moment z = 0.6
  end
  subsection line
    set Type = line
    set Struts = 1
    set Force per length z = 0.2
  end
end
subsection Gravity
  set Acceleration z = -1
end
)";

  /** A trial state far from rest, all its rotations large. */
  struct SpaceTrial
  {
    explicit SpaceTrial(const std::vector<std::string> &overrides)
      : of_scene(frame_with_everything, overrides, MPI_COMM_SELF)
      , rotations(of_scene.dofs())
      , from(of_scene.equations.initial_state())
      , to(from)
    {
      add_noise(0.2, from.displacement);
      for (Quaternion &rotation : from.rotations)
        rotation = exponential(SpaceVector({noise(2), noise(2), noise(2)}));
      to.displacement = from.displacement;
      add_noise(0.3, to.displacement);
      rotations.follow(step(to));
      if (to.velocity)
        add_noise(0.5, *to.velocity);
      if (to.acceleration)
        add_noise(0.5, *to.acceleration);
      to.time = dt;
    }

    Evaluation step(State &trial) const
    {
      return of_scene.step(from, trial, dt);
    }

    /** Residual after an increment @p h of unknown @p i, as of Newton's method. */
    Vector
    moved_residual(const int i, const double h, const TangentFactors &factors)
    {
      State  moved = to;
      Vector increment(to.displacement);
      increment.assign(increment.size(), 0);
      increment[i] = h;
      rotations.rotate(step(moved), increment);
      add_multiple(factors.stiffness, increment, moved.displacement);
      if (moved.velocity)
        add_multiple(factors.damping, increment, *moved.velocity);
      if (moved.acceleration)
        add_multiple(factors.mass, increment, *moved.acceleration);
      of_scene.residual(step(moved));
      return moved.residual;
    }

    double noise(const double size)
    {
      return std::uniform_real_distribution<double>(-size, size)(generator);
    }

    void add_noise(const double size, Vector &vector)
    {
      for (unsigned int i = 0; i < vector.size(); ++i)
        vector[i] += noise(size);
    }

    std::mt19937     generator;
    double           dt = 0.4;
    EquationsOnRanks of_scene;
    NodeRotations    rotations;
    State            from, to;
  };

  void check_space_tangent(const std::vector<std::string> &overrides,
                           const TangentFactors           &factors)
  {
    SpaceTrial          trial(overrides);
    EquationsOnRanks   &of_scene = trial.of_scene;
    const DofNumbering &dofs     = of_scene.dofs();
    const auto          matrix   = of_scene.make_tangent();
    const Evaluation    step     = trial.step(trial.to);
    of_scene.residual(step);
    of_scene.tangent(step, factors, *matrix);

    Vector       unit(dofs.layout().n_local()), column(unit);
    double       worst = 0, scale = 0;
    const double h = 1e-5;
    for (unsigned int j = 0; j < unit.size(); ++j)
      {
        unit.assign(unit.size(), 0);
        unit[j] = 1;
        matrix->multiply(unit.data(), column.data());
        const Vector right = trial.moved_residual(j, h, factors),
                     left  = trial.moved_residual(j, -h, factors);
        for (unsigned int i = 0; i < unit.size(); ++i)
          if (dofs.unknowns().kinds[i] != UnknownKind::prescribed)
            {
              const double difference = (right[i] - left[i]) / (2 * h);
              worst = std::max(worst, std::abs(column[i] - difference));
              scale = std::max(scale, std::abs(column[i]));
            }
      }
    // The difference is right to h^2 and 1e-16 / h, 1e-10 and 1e-11.
    EXPECT_LT(worst, 1e-8 * scale);
  }
} // namespace

TEST(SpaceTangent, OfEverythingIsTheDerivativeOfTheResidual)
{
  check_space_tangent({}, {1., 5., 25.});
}

TEST(SpaceTangent, InStaticsIsTheDerivativeOfTheResidual)
{
  check_space_tangent({"Time/Scheme=static"}, {1., 2.5, 0.});
}

TEST(SpaceTangent, OfSmallDisplacementsIsTheDerivativeOfTheResidual)
{
  check_space_tangent({"Effects/Large rotation=off",
                       "Loads/following/Direction=fixed"},
                      {1., 5., 25.});
}

TEST(SpaceTangent, HoldsForEveryOrder)
{
  for (const std::string order : {"1", "2", "4"})
    {
      SCOPED_TRACE("order " + order);
      check_space_tangent({"Discretization/Order=" + order}, {1., 5., 25.});
    }
}
