#include <auxfem/equations/node_rotations.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <random>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A spatial frame with all features of scenes. */
  const SceneText frame_with_everything =
    SceneText()
      .dimension(3)
      .frame(
        "0 0 0; 1 0 0.2; 1 1 0; 0.2 1 1; 1.2 0.3 1; 1.8 0.9 0.9; 0.3 1.9 1",
        "0 1; 1 2 0.2 0 0.3 1; 2 3; 3 4; 4 1; 4 5; 3 6")
      .given("band", {3, 5, 0.7}, {1, 0.5, 0.3})
      .add("Sections/band",
           "Shear area 3 = 4 | Second moment of area 2 = 0.4 | "
           "Torsion constant = 0.5 | "
           "Stiffness-proportional damping = 0.3 | "
           "Mass-proportional damping = 0.4")
      .add("Materials/rubber",
           "Law = viscoelastic | Young's modulus = 1 | Density = 1 | "
           "Poisson's ratio = 0.3 | Relaxing parts = 0.5 | "
           "Relaxation times = 0.3 | Volume change = elastic")
      .add("Sections/rubber",
           "Struts = 0, 2 | Material = rubber | Shape = given | Area = 3 | "
           "Shear area = 5 | Second moment of area = 0.7 | Shear area 3 = 4 | "
           "Second moment of area 2 = 0.4 | Torsion constant = 0.5")
      .add(yielding_struts("5"))
      .add("Joints/spring",
           "Joints = 1 | Struts = 4 | Type = rotational spring | "
           "Stiffness = 0.8")
      .add("Joints/hinge", "Joints = 2 | Struts = 2 | Type = hinge")
      .add("Joints/door",
           "Joints = 3 | Struts = 3 | Type = revolute | Axis = 1 2 3")
      .add("Rigid parts/bar",
           "Struts = 6 | Mass = 0.7 | Rotary inertia = 0.2 0.3 0.4 | "
           "Elastic struts = clamped")
      .connector("damper",
                 "kelvin-voigt",
                 "Between = 0 3; 1 6 | "
                 "Spring stiffness = 0.6 | Damping coefficient = 0.9")
      .connector("relaxing",
                 "maxwell",
                 "Between = 2 4 | Spring stiffness = 0.7 | "
                 "Damping coefficient = 0.8")
      .connector("slide",
                 "spring",
                 "Between = ground: 5 | Geometry = direction | "
                 "Direction = 1 2 -1 | Ground offset = 0.1 0.5 0.2 | "
                 "Spring stiffness = 0.5")
      .support("wall", "0", "clamp")
      .add("Supports/mover",
           "Joints = 2 | Type = prescribed | Displacement z = 0.1 * t")
      .mass("top", "4, 5", 0.6, "0.1 0.2 0.3")
      .add("Loads/dead", "Joints = 4 | Force x = 0.3 | Moment y = 0.4")
      .add("Loads/following",
           "Joints = 5 | Direction = follows the joint | Force x = 0.5 | "
           "Force z = -0.7 | Moment x = 0.4 | Moment z = 0.6")
      .add("Loads/line", "Type = line | Struts = 1 | Force per length z = 0.2")
      .set("Gravity/Acceleration z", -1);

  /** A trial state far from rest, all its rotations large. */
  struct SpaceTrial
  {
    explicit SpaceTrial(const std::vector<std::string> &overrides)
      : setup(frame_with_everything, overrides, MPI_COMM_SELF)
      , rotations(setup.dofs())
      , from(setup.equations.initial_state())
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
      return setup.step(from, trial, dt);
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
      setup.residual(step(moved));
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
    EquationsOnRanks setup;
    NodeRotations    rotations;
    State            from, to;
  };

  /** A step of the energy-momentum scheme between states far from rest. */
  struct SpaceMeanStep
  {
    /** @param size of increments in the step (m, rad) */
    SpaceMeanStep(std::vector<std::string> overrides, const double size)
      : trial(with_scheme(overrides))
      , scheme(trial.setup.scene.time.implicit_scheme())
    {
      State &from = trial.from;
      // Neighbouring nodes rotate relative to each other by less than half a
      // turn.
      for (Quaternion &rotation : from.rotations)
        rotation = exponential(SpaceVector(
                     {trial.noise(0.5), trial.noise(0.5), trial.noise(0.5)})) *
          exponential(SpaceVector({1.1, -0.8, 0.9}));
      trial.add_noise(0.3, *from.velocity);
      const State before = from;
      trial.setup.residual(Evaluation::consistent_rates(before, from));
      trial.setup.accept(Evaluation::consistent_rates(before, from));
      trial.to      = from;
      trial.to.time = from.time + trial.dt;
      scheme.predict(from, trial.dt, trial.to);
      Vector increment(from.displacement.size(), 0.);
      trial.add_noise(size, increment);
      move(increment, trial.to);
    }

    static std::vector<std::string>
    with_scheme(std::vector<std::string> overrides)
    {
      overrides.push_back("Time/Scheme=energy-momentum");
      return overrides;
    }

    Evaluation evaluation(State &to) const
    {
      return Evaluation::discrete_gradient(trial.from, to, trial.dt);
    }

    /** Applies an increment as Newton's method does. */
    void move(Vector increment, State &to) const
    {
      trial.rotations.rotate(evaluation(to), increment);
      scheme.correct(trial.from, increment, trial.dt, to);
    }

    /** Largest error of the tangent against differences, relative to its
     * largest entry. */
    double error_of_tangent()
    {
      EquationsOnRanks &setup      = trial.setup;
      const auto        matrix     = setup.make_tangent();
      const Evaluation  evaluation = this->evaluation(trial.to);
      setup.residual(evaluation);
      setup.tangent(evaluation, scheme.factors(trial.from, trial.dt), *matrix);
      const unsigned int n = trial.to.displacement.size();
      Vector             column(n);
      double             worst = 0, scale = 0;
      const double       h = 1e-5;
      for (unsigned int j = 0; j < n; ++j)
        {
          Vector unit(n, 0.);
          unit[j] = 1;
          matrix->multiply(unit.data(), column.data());
          State right = trial.to, left = trial.to;
          unit[j] = h;
          move(unit, right);
          unit[j] = -h;
          move(unit, left);
          setup.residual(this->evaluation(right));
          setup.residual(this->evaluation(left));
          for (unsigned int i = 0; i < n; ++i)
            if (setup.dofs().unknowns().kinds[i] != UnknownKind::prescribed)
              {
                const double difference =
                  (right.residual[i] - left.residual[i]) / (2 * h);
                worst = std::max(worst, std::abs(column[i] - difference));
                scale = std::max(scale, std::abs(column[i]));
              }
        }
      return worst / scale;
    }

    SpaceTrial            trial;
    const ImplicitScheme &scheme;
  };

  void check_space_tangent(const std::vector<std::string> &overrides,
                           const TangentFactors           &factors)
  {
    SpaceTrial          trial(overrides);
    EquationsOnRanks   &setup  = trial.setup;
    const DofNumbering &dofs   = setup.dofs();
    const auto          matrix = setup.make_tangent();
    const Evaluation    step   = trial.step(trial.to);
    setup.residual(step);
    setup.tangent(step, factors, *matrix);

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

// All effects at once: the work of every row must balance the energy ledger.
TEST(SpaceTangent, MeanForcesBetweenStatesBalanceTheLedger)
{
  for (const std::string order : {"1", "2", "4"})
    {
      SCOPED_TRACE("order " + order);
      SpaceMeanStep     step({"Discretization/Order=" + order}, 0.4);
      State            &from = step.trial.from, &to = step.trial.to;
      const Evaluation  evaluation = step.evaluation(to);
      EquationsOnRanks &setup      = step.trial.setup;
      const StepTravel  travel(evaluation, setup.dofs());
      setup.residual(evaluation);
      // Constraints are not satisfied here; whole runs test that their forces
      // do no work.
      double     work = 0, multiplier_work = 0;
      const auto without_multipliers = [&] {
        State free = to;
        for (unsigned int i = 0; i < free.displacement.size(); ++i)
          if (setup.dofs().unknowns().kinds[i] == UnknownKind::multiplier)
            free.displacement[i] = 0;
        setup.residual(step.evaluation(free));
        return free.residual;
      };
      const Vector residual = without_multipliers();
      for (unsigned int i = 0; i < residual.size(); ++i)
        if (setup.dofs().unknowns().kinds[i] != UnknownKind::multiplier)
          {
            work += residual[i] * travel.of(i);
            multiplier_work += (to.residual[i] - residual[i]) * travel.of(i);
          }
      EXPECT_GT(std::abs(multiplier_work), 1e-3);
      setup.residual(evaluation);
      setup.accept(evaluation);
      const Energies &start = from.energies, &end = to.energies;
      double          loads = end.external();
      for (unsigned int i = 0; i < end.ledger().entries().size(); ++i)
        if (end.ledger().entries()[i].name == "mover.support_work")
          loads -= end[i];
      EXPECT_GT(end.dissipated(), 0);
      EXPECT_NEAR(work,
                  end.total() - start.total() + end.dissipated() - loads,
                  1e-12 * end.total());
    }
}

// The tangent omits terms proportional to the rotation of the step and
// derivatives times section forces, which are small here.
TEST(SpaceTangent, BetweenStatesIsTheDerivativeOfMeanForcesUpToTheTurn)
{
  const std::vector<std::string> soft = {
    "Sections/band/Young's modulus=1e-9",
    "Materials/rubber/Young's modulus=1e-9",
    "Materials/steel/Young's modulus=1e-9",
    "Materials/steel/Yield stress=5e-11",
    "Materials/steel/Flow stresses=2e-8",
    "Materials/steel/Kinematic hardening modulus=1e-10"};
  const double coarse = SpaceMeanStep(soft, 1e-2).error_of_tangent(),
               fine   = SpaceMeanStep(soft, 1e-3).error_of_tangent();
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine, 0.12 * coarse);
}
