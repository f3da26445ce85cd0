#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/struts/effects/struts.h>

#include <analysis/verdict/findings_of.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * A small frame with every effect: damped and relaxing struts, every
   * connector law, springs, hinges, a rigid part, plates with friction, contact
   * of struts, follower loads, masses, weight, moved supports.
   */
  SceneText with_every_effect(const unsigned int dimension)
  {
    const bool in_space = dimension == 3;
    const auto point    = [in_space](const std::string &x_y,
                                  const std::string &z) {
      return in_space ? x_y + " " + z : x_y;
    };
    SceneText text;
    text.dimension(dimension)
      .frame(point("0 0", "0") + "; " + point("1 0", "0.2") + "; " +
               point("1 1", "0") + "; " + point("0.2 1", "1") + "; " +
               point("1.8 0.3", "1") + "; " + point("2.4 0.9", "0.9") + "; " +
               point("0.3 1.9", "1"),
             "0 1; 1 2 0.2" + std::string(in_space ? " 0 0.3 1" : "") +
               "; 2 3; 1 4; 4 5; 3 6")
      .rectangle("band", 0.2, 0.2, {50, 0.3})
      .add("Sections/band",
           "Stiffness-proportional damping = 0.03 | "
           "Mass-proportional damping = 0.04")
      .add("Materials/rubber",
           "Law = viscoelastic | Young's modulus = 100 | Density = 0.3 | "
           "Relaxing parts = 0.3, 0.2 | Relaxation times = 0.05, 1 | "
           "Volume change = elastic")
      .add("Sections/rubber",
           "Struts = 0 | Material = rubber | Shape = rectangle | "
           "Width = 0.2 | Height = 0.2")
      .add("Joints/spring",
           "Joints = 1 | Struts = 3 | Type = rotational spring | "
           "Stiffness = 0.8")
      .add("Joints/hinge", "Joints = 2 | Struts = 2 | Type = hinge")
      .add("Rigid parts/bar",
           "Struts = 5 | Mass = 0.7 | Elastic struts = clamped | "
           "Rotary inertia = " +
             std::string(in_space ? "0.2 0.3 0.4" : "0.2"))
      .connector("spring", "spring", "Between = 0 2 | Spring stiffness = 0.5")
      .connector("dashpot",
                 "dashpot",
                 "Between = 0 3 | Damping coefficient = 0.9")
      .connector("kelvin-voigt",
                 "kelvin-voigt",
                 "Between = 1 6 | Spring stiffness = 0.6 | "
                 "Damping coefficient = 0.9")
      .connector("maxwell",
                 "maxwell",
                 "Between = 2 4 | Spring stiffness = 0.7 | "
                 "Damping coefficient = 0.8")
      .connector("solid",
                 "standard-linear-solid",
                 "Between = 2 5 | Long-time stiffness = 0.2 | "
                 "Spring stiffness = 0.5 | Damping coefficient = 0.4")
      .connector("generalized",
                 "generalized-maxwell",
                 "Between = 0 4 | Long-time stiffness = 0.2 | "
                 "Stiffnesses = 0.5, 0.3 | Relaxation times = 0.4, 2")
      .connector("slide",
                 "kelvin-voigt",
                 "Between = ground: 5 | Geometry = direction | "
                 "Spring stiffness = 0.5 | Damping coefficient = 0.2 | "
                 "Direction = 1 2" +
                   std::string(in_space ? " -1" : "") +
                   " | Ground offset = " + point("0.1 0.5", "0.2"))
      .support("wall", "0", "clamp")
      .add("Supports/post",
           "Joints = 6 | Type = prescribed | Displacement x = 0 | "
           "Displacement y = 0" +
             std::string(in_space ? " | Displacement z = 0 | Rotation y = 0"
                                  : ""))
      .add("Supports/mover",
           "Joints = 2 | Type = prescribed | Displacement x = 0.01 * t")
      .add("Plates/ball",
           "Shape = sphere | Position = " + point("1.4 -0.45", "0.6") +
             " | Radius = 0.4")
      .add("Contact", "Friction coefficient = 0.3 | Slip velocity = 0.1")
      .mass("top", "4, 5", 0.6, in_space ? "0.1 0.2 0.3" : "0.1")
      .add("Loads/following",
           "Joints = 5 | Direction = follows the joint | Force x = 0.05 | "
           "Moment z = 0.02 * t")
      .add("Loads/dead", "Joints = 4 | Force y = 0.03 * t | Moment z = 0.01")
      .add("Loads/line", "Type = line | Struts = 1 | Force per length x = 0.02")
      .set("Gravity/Acceleration y", -0.1)
      .set("Base motion/Acceleration x", "0.2 * t")
      .mesh(2)
      .time(0.02, 0.01);
    if (in_space)
      text.add("Joints/door",
               "Joints = 3 | Struts = 2 | Type = revolute | Axis = 1 2 3");
    return text;
  }

  /** Sums of the results of an evaluation over all ranks. */
  struct Answer
  {
    double              force, moment, constraint, force_scale, tangent;
    std::vector<double> energies;
  };

  /** Evaluates every query of the equations. */
  Answer ask_all(EquationsOnRanks &setup, const Evaluation &evaluation)
  {
    const Equations         &equations = setup.equations;
    const UnknownLayout     &layout    = equations.unknowns().layout;
    const EvaluationResults &results   = setup.residual(evaluation);
    const auto matrix = setup.make_tangent(), other = setup.make_tangent();
    equations.tangent(evaluation, results, {1., 2., 3.}, *matrix);
    const Vector ones(evaluation.to.displacement.size(), 1.);
    Vector       image(layout.n_owned());
    matrix->multiply(ones.data(), image.data());
    double sum = 0;
    for (const double value : image)
      sum += std::abs(value);

    Vector forces(ones.size(), 0.);
    equations.row_force_bounds(evaluation, results, forces.data());
    for (const double force : forces)
      EXPECT_TRUE(std::isfinite(force));
    EXPECT_TRUE(std::isfinite(equations.round_off_floor(evaluation, results)));
    for (const double value : equations.load_derivative(evaluation))
      EXPECT_TRUE(std::isfinite(value));
    EXPECT_EQ(equations.nonfinite_reason(evaluation, results), "");
    equations.rejection_reason(evaluation);
    if (evaluation.kind == Evaluation::Kind::equilibrium)
      {
        equations.dynamic_stiffness(evaluation,
                                    results,
                                    {-0.1, 2.},
                                    *matrix,
                                    *other);
        matrix->reset();
        equations.add_geometric_tangent({evaluation.to,
                                         evaluation.from,
                                         evaluation.to,
                                         results,
                                         results,
                                         results,
                                         1.},
                                        *matrix);
      }
    if (evaluation.kind == Evaluation::Kind::stage)
      {
        for (const double rate :
             equations.find_internal_rates(evaluation.to, results))
          EXPECT_TRUE(std::isfinite(rate));
      }
    // Instants have energies, but no increments.
    if (evaluation.dt > 0)
      equations.accept(evaluation, results);

    const ReportingEffects &reporting = equations.reporting();
    for (const ConnectorGroup &group : reporting.connectors)
      for (unsigned int i = 0; i < group.forces->n_reported(); ++i)
        EXPECT_TRUE(
          std::isfinite(group.report(i, evaluation.to, results).force));
    const std::vector<StrainLimit> limits(equations.model().sections.size(),
                                          {1e-9, fibres_at({{0.1, 0.1}})});
    for (const StrutGroup &group : reporting.struts)
      {
        EXPECT_TRUE(
          std::isfinite(group.forces
                          ->largest_strain(evaluation.to,
                                           *results.effect_caches[group.effect],
                                           limits,
                                           0.)
                          .ratio));
        for (unsigned int e = group.forces->elements().begin;
             e < group.forces->elements().end;
             ++e)
          group.forces->sample(evaluation.to, e, 3);
      }
    return {results.force,
            results.moment,
            results.constraint,
            results.force_scale,
            layout.sum(sum),
            evaluation.to.energies.amounts()};
  }

  using Kind = Evaluation::Kind;

  Evaluation evaluation_of(const Kind kind, const State &from, State &to)
  {
    const double dt = 0.1;
    switch (kind)
      {
        case Kind::step:
          return Evaluation::step(from, to, dt);
        case Kind::stage:
          return Evaluation::stage(from, to, dt, dt);
        case Kind::discrete_gradient:
          return Evaluation::discrete_gradient(from, to, dt);
        case Kind::static_step:
          return Evaluation::static_step(from, to, dt);
        case Kind::equilibrium:
          return Evaluation::equilibrium(from, to);
        case Kind::consistent_rates:
          break;
      }
    return Evaluation::consistent_rates(from, to);
  }

  /** Answer at a state in which everything moves, rotates and touches. */
  Answer answer_of(const std::string              &text,
                   const std::vector<std::string> &overrides,
                   const Kind                      kind,
                   const MPI_Comm                  communicator)
  {
    EquationsOnRanks    setup(text, overrides, communicator);
    const NodeRotations rotations(setup.dofs());
    State               from = setup.equations.initial_state();
    setup.equations.update_couplings(from);
    setup.results = setup.equations.make_results();
    State to      = from;
    to.time       = kind == Kind::consistent_rates ? 0. : 0.1;
    fill_by_position(setup.model, 0.02, to.displacement);
    rotations.follow(evaluation_of(kind, from, to));
    for (std::optional<Vector> *rates : {&to.velocity, &to.acceleration})
      if (*rates)
        fill_by_position(setup.model, 0.1, **rates);
    return ask_all(setup, evaluation_of(kind, from, to));
  }

  /** Kinds of evaluations that a scheme uses. */
  std::vector<Kind> kinds_of(const std::string &scheme)
  {
    std::vector<Kind> kinds = {Kind::equilibrium, Kind::consistent_rates};
    kinds.push_back(scheme == "static"              ? Kind::static_step
                      : scheme == "esdirk"          ? Kind::stage
                      : scheme == "energy-momentum" ? Kind::discrete_gradient
                                                    : Kind::step);
    return kinds;
  }
} // namespace

TEST(EveryEffectOnRanks, AnswersAtEveryKindOfEvaluation)
{
  for (const unsigned int dimension : {2u, 3u})
    for (const std::string rotation : {"on", "off"})
      for (const std::string scheme :
           {"newmark", "esdirk", "energy-momentum", "static"})
        for (const Kind kind : kinds_of(scheme))
          {
            SCOPED_TRACE(std::to_string(dimension) + "D, " + scheme +
                         ", large rotation " + rotation + ", kind " +
                         std::to_string(static_cast<int>(kind)));
            SceneText text = with_every_effect(dimension);
            if (rotation == "off")
              text.remove("Loads/following");
            const std::vector<std::string> overrides =
              {"Time/Scheme=" + scheme, "Effects/Large rotation=" + rotation};
            const Answer alone =
                           answer_of(text, overrides, kind, MPI_COMM_SELF),
                         together =
                           answer_of(text, overrides, kind, MPI_COMM_WORLD);
            EXPECT_GT(alone.force, 0);
            EXPECT_TRUE(std::isfinite(alone.tangent));
            EXPECT_NEAR(together.force, alone.force, 1e-9 * alone.force_scale);
            EXPECT_NEAR(together.moment,
                        alone.moment,
                        1e-9 * alone.force_scale);
            EXPECT_NEAR(together.constraint, alone.constraint, 1e-9);
            EXPECT_NEAR(together.tangent, alone.tangent, 1e-9 * alone.tangent);
            ASSERT_EQ(together.energies.size(), alone.energies.size());
            for (std::size_t i = 0; i < alone.energies.size(); ++i)
              {
                EXPECT_TRUE(std::isfinite(alone.energies[i]));
                EXPECT_NEAR(together.energies[i], alone.energies[i], 1e-9);
              }
          }
}

TEST(EveryEffectOnRanks, WorksOrIsRefusedInEveryAnalysis)
{
  const std::vector<std::vector<std::string>> analyses = {
    {"Time/Scheme=static"},
    {"Time/Scheme=newmark"},
    {"Time/Scheme=newmark", "Time/Start from=static equilibrium"},
    {"Time/Scheme=generalized-alpha", "Time/Relative tolerance=1e-2"},
    {"Time/Scheme=energy-momentum"},
    {"Time/Scheme=esdirk"},
    {"Time/Scheme=newmark", "Discretization/Order=auto"},
    {"Analysis=modes", "Modes/Number=2"},
    {"Analysis=modes", "Modes/Number=2", "Modes/Damped=true"},
    {"Analysis=buckling", "Modes/Number=2"},
    {"Analysis=frequency response", "Frequency response/Number=3"},
    {"Analysis=static path", "Time/Scheme=static"}};
  unsigned int n_answers = 0;
  for (const unsigned int dimension : {2u, 3u})
    {
      // Every effect, then those that analyses of small motions accept, then
      // small displacements that the program may choose.
      SceneText small = with_every_effect(dimension);
      small.remove("Plates/ball").remove("Contact").remove("Rigid parts/bar");
      small.set("Supports/mover/Displacement x", 0);
      if (dimension == 3)
        small.remove("Joints/door");
      SceneText simple = small;
      for (const std::string name : {"dashpot",
                                     "kelvin-voigt",
                                     "maxwell",
                                     "solid",
                                     "generalized",
                                     "slide"})
        simple.remove("Connectors/" + name);
      simple.remove("Loads/following");
      for (const SceneText &text :
           {with_every_effect(dimension), small, simple})
        for (std::vector<std::string> overrides : analyses)
          {
            SCOPED_TRACE(std::to_string(dimension) + "D, " + overrides.front());
            try
              {
                result_of(text, overrides, MPI_COMM_WORLD);
                ++n_answers;
              }
            catch (const InputError &refusal)
              {
                EXPECT_GT(std::string(refusal.what()).size(), 20u);
              }
            catch (const ComputationError &refusal)
              {
                EXPECT_GT(std::string(refusal.what()).size(), 20u);
              }
          }
    }
  EXPECT_GT(n_answers, 50u);
}
