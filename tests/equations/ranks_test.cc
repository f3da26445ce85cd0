#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/model/numbering.h>
#include <auxfem/rigid/effects/rigid_part_group.h>
#include <auxfem/time/time_stepper.h>

#include <deal.II/base/mpi.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/run_program.h>
#include <support/scene_text.h>

#include <map>
#include <set>

using namespace auxfem;
using namespace auxfem::testing_support;

// Compares the same scene on all ranks and on each rank alone; meaningful with
// two or more ranks.

namespace
{
  /** Equations and a state with irregular motion, residual and tangent there.
   */
  struct Evaluated
  {
    Evaluated(const std::string &text, const MPI_Comm communicator)
      : on_ranks(text, {}, communicator)
      , from(on_ranks.equations.initial_state())
      , to(from)
      , matrix(on_ranks.make_tangent())
      , product(on_ranks.dofs().layout().n_owned())
    {
      const LatticeModel &model = on_ranks.model;
      to.time                   = 0.3;
      fill_by_position(model, 0.1, from.displacement);
      fill_by_position(model, 0.5, to.displacement);
      fill_by_position(model, 0.7, *to.velocity);
      fill_by_position(model, 1.1, *to.acceleration);
      const Evaluation step = Evaluation::step(from, to, 0.3);
      NodeRotations(model.numbering).follow(step);
      on_ranks.residual(step);
      on_ranks.tangent(step, {1., 3., 5.}, *matrix);

      Vector direction(on_ranks.dofs().layout().n_local());
      fill_by_position(model, 1., direction);
      matrix->multiply(direction.data(), product.data());
    }

    EquationsOnRanks               on_ranks;
    State                          from, to;
    std::unique_ptr<TangentMatrix> matrix;
    Vector                         product;
  };

  /** Compares owned values with those of the same unknowns on one rank. */
  void expect_equal(const LatticeModel &model,
                    const Vector       &values,
                    const LatticeModel &alone,
                    const Vector       &values_alone,
                    const double        relative_tolerance)
  {
    const double scale = largest_size(values_alone);
    ASSERT_GT(scale, 0);
    const auto reference = by_name(alone, values_alone);
    for (const auto &[name, value] : by_name(model, values))
      EXPECT_NEAR(value, reference.at(name), relative_tolerance * scale)
        << (std::get<0>(name) ? "joint " : "strut ") << std::get<1>(name)
        << ", component " << std::get<3>(name);
  }
} // namespace

namespace
{
  void compare_evaluated(const std::string &text)
  {
    const Evaluated all(text, MPI_COMM_WORLD), alone(text, MPI_COMM_SELF);
    ASSERT_EQ(all.on_ranks.dofs().layout().n_global(),
              alone.on_ranks.dofs().layout().n_global());
    // Tolerance for a different order of summation.
    const double tolerance = 1e-13;
    expect_equal(all.on_ranks.model,
                 all.to.residual,
                 alone.on_ranks.model,
                 alone.to.residual,
                 tolerance);
    expect_equal(all.on_ranks.model,
                 all.product,
                 alone.on_ranks.model,
                 alone.product,
                 tolerance);
    const EvaluationResults &together = all.on_ranks.results,
                            &single   = alone.on_ranks.results;
    EXPECT_NEAR(together.force, single.force, tolerance * single.force);
    EXPECT_NEAR(together.moment, single.moment, tolerance * single.moment);
    EXPECT_NEAR(together.force_scale,
                single.force_scale,
                tolerance * single.force_scale);
    EXPECT_EQ(all.on_ranks.dofs().unknowns().n_free(),
              alone.on_ranks.dofs().unknowns().n_free());
    EXPECT_EQ(unknown_with_largest_residual(all.on_ranks.model, all.to),
              unknown_with_largest_residual(alone.on_ranks.model, alone.to));
  }
} // namespace

TEST(Ranks, ResidualAndTangentAreThoseOfOneRank)
{
  compare_evaluated(star_with_everything(3, 3));
  compare_evaluated(star_with_everything(3, 3) + yielding_struts("3, 40"));
}

TEST(Ranks, ResidualAndTangentInSpaceAreThoseOfOneRank)
{
  compare_evaluated(space_star_with_everything());
  compare_evaluated(space_star_with_everything() + yielding_struts("3, 20"));
}

namespace
{
  /** A scene advanced to its end. */
  struct Advanced
  {
    Advanced(const std::string              &text,
             const std::vector<std::string> &overrides,
             const MPI_Comm                  communicator)
      : on_ranks(text, overrides, communicator)
      , stepper(on_ranks.equations, work)
      , solution(on_ranks.equations.initial_solution())
    {
      stepper.start(solution);
      Recorder nobody;
      while (state.step < on_ranks.scene.time.n_steps())
        iterations += stepper.advance(solution, nobody).iterations;
    }

    EquationsOnRanks on_ranks;
    Work             work;
    TimeStepper      stepper;
    Solution         solution;
    const State     &state      = solution.state;
    unsigned int     iterations = 0;
  };

  /**
   * Force, extension and dissipation of the connectors of this rank, by
   * position.
   */
  std::map<std::string, std::array<double, 3>>
  connector_reports(const Advanced &run)
  {
    std::map<std::string, std::array<double, 3>> reports;
    for (const ConnectorGroup &group :
         run.on_ranks.equations.reporting().connectors)
      for (unsigned int i = 0; i < group.forces->n_reported(); ++i)
        {
          const ConnectorReport report =
            group.report(i, run.state, run.solution.results);
          std::ostringstream name;
          name << group.forces->name() << ' ' << report.ends[0] << ' '
               << report.ends[1];
          reports[name.str()] = {
            {report.force, report.extension, report.dissipated}};
        }
    return reports;
  }

  std::vector<double> as_list(const Energies &e)
  {
    return {e.kinetic(), e.strain(), e.stored(), e.dissipated(), e.external()};
  }

  /**
   * Stars with all features; stubs are rigid and clamped, and some edges are
   * rigid bars.
   */
  SceneText stars_with_rigid_parts()
  {
    // Rigid stubs leave no elastic struts for some releases, clamps and
    // springs.
    return star_with_everything(3, 3)
      .remove("Joints/hinges")
      .remove("Joints/springs/Stiffness")
      .set("Joints/springs/Type", "hinge")
      .set("Supports/foundation/Type", "pin")
      .add("Rigid parts/stubs",
           "Struts = stubs | Mass = 0.4 | Elastic struts = clamped")
      .add("Rigid parts/bars",
           "Struts = 0, 13, 37, 50 | Parts = single struts | Mass = 0.2");
  }

  /** Start from rest, since rigid parts cannot follow a velocity jump. */
  const std::string slow_shaker =
    "Supports/shaker/Displacement x=0.02 * (1 - cos(3 * t))";

  /** Runs the same scene on all ranks and alone and compares everything. */
  void compare_runs(const std::vector<std::string> &overrides,
                    const std::string &text = star_with_everything(3, 3))
  {
    const Advanced all(text, overrides, MPI_COMM_WORLD);
    const Advanced alone(text, overrides, MPI_COMM_SELF);
    EXPECT_EQ(all.iterations, alone.iterations);
    EXPECT_EQ(all.state.time, alone.state.time);

    // Round-off of some ten steps with a few iterations each.
    const double        tolerance = 1e-10;
    const LatticeModel &model     = all.on_ranks.model,
                       &reference = alone.on_ranks.model;
    expect_equal(model,
                 all.state.displacement,
                 reference,
                 alone.state.displacement,
                 tolerance);
    if (all.state.velocity)
      expect_equal(model,
                   *all.state.velocity,
                   reference,
                   *alone.state.velocity,
                   tolerance);
    if (all.state.acceleration)
      expect_equal(model,
                   *all.state.acceleration,
                   reference,
                   *alone.state.acceleration,
                   tolerance);

    const auto mine = connector_reports(all), whole = connector_reports(alone);
    for (const auto &[name, values] : mine)
      for (unsigned int k = 0; k < 3; ++k)
        EXPECT_NEAR(values[k], whole.at(name)[k], tolerance) << name;
    EXPECT_EQ(dealii::Utilities::MPI::sum(mine.size(), MPI_COMM_WORLD),
              whole.size());

    const auto energies = as_list(all.state.energies),
               wanted   = as_list(alone.state.energies);
    for (unsigned int k = 0; k < energies.size(); ++k)
      EXPECT_NEAR(energies[k], wanted[k], tolerance * wanted[3]);
  }
} // namespace

TEST(Ranks, DynamicRunIsThatOfOneRankWithKlu)
{
  compare_runs({"Solver/Type=klu"});
}

TEST(Ranks, DynamicRunIsThatOfOneRankWithMumps)
{
  compare_runs({"Solver/Type=mumps", "Time/Scheme=generalized-alpha"});
}

TEST(Ranks, ImpactInSpaceIsThatOfOneRank)
{
  compare_runs({"Solver/Type=klu", "Time/Scheme=generalized-alpha"},
               space_star_with_everything());
  compare_runs({"Solver/Type=mumps", "Time/Scheme=newmark"},
               space_star_with_everything());
}

TEST(Ranks, StaticRunIsThatOfOneRank)
{
  compare_runs({"Time/Scheme=static", "Discretization/Order=3"});
}

TEST(Ranks, RigidAndElasticStrutsMoveAsOnOneRank)
{
  compare_runs({"Time/Scheme=generalized-alpha", slow_shaker},
               stars_with_rigid_parts());
  compare_runs({"Time/Scheme=static"}, stars_with_rigid_parts());
  compare_runs({"Solver/Type=klu", "Effects/Large rotation=off", slow_shaker},
               stars_with_rigid_parts());
}

TEST(Ranks, RigidPartsAreReportedOnceAndAlike)
{
  const std::string text = stars_with_rigid_parts();
  const Advanced    all(text, {slow_shaker}, MPI_COMM_WORLD),
    alone(text, {slow_shaker}, MPI_COMM_SELF);
  const RigidPartGroup &parts = *all.on_ranks.equations.reporting().rigid_parts,
                       &reference =
                         *alone.on_ranks.equations.reporting().rigid_parts;
  EXPECT_EQ(dealii::Utilities::MPI::sum(parts.n_reported(), MPI_COMM_WORLD),
            alone.on_ranks.lattice.rigid_parts.size());
  for (unsigned int i = 0; i < parts.n_reported(); ++i)
    {
      // One rank reports all parts in order.
      const unsigned int    part   = parts.part(i);
      const RigidPartReport report = parts.report(i, all.state),
                            wanted = reference.report(part, alone.state);
      ASSERT_EQ(wanted.part, part);
      for (unsigned int k = 0; k < report.forces.size(); ++k)
        EXPECT_LT((report.forces[k] - wanted.forces[k]).norm(), 1e-10);
      EXPECT_LT((parts.rotation(i, all.state) -
                 reference.rotation(part, alone.state))
                  .norm(),
                1e-10);
    }
}

TEST(Ranks, ConnectorsRubAndBreakAsOnOneRank)
{
  for (const std::string scheme : {"newmark", "energy-momentum", "static"})
    compare_runs({"Time/Scheme=" + scheme, "Solver/Type=klu"},
                 star_with_nonlinear_connectors(3, 2));
}

TEST(Ranks, RigidPartsAloneMoveAsOnOneRank)
{
  // A chain of six bars without finite elements.
  const SceneText chain =
    SceneText()
      .frame("0 0; 1 0.2; 2 0; 3 0.1; 4 0; 5 0; 6 0.3",
             "0 1; 1 2; 2 3; 3 4; 4 5; 5 6")
      .add("Rigid parts/bars",
           "Struts = all | Parts = single struts | Mass = 0.5")
      .support("pivot", "0", "pin")
      .connector("anchor",
                 "kelvin-voigt",
                 "Spring stiffness = 3 | "
                 "Damping coefficient = 0.4 | Between = 1 5; 0 6")
      .set("Gravity/Acceleration y", -1)
      .time(0.5, 0.05, "generalized-alpha");
  compare_runs({}, chain);
  compare_runs({"Solver/Type=klu"}, chain);
}

namespace
{
  /** Names of all records with the items that the ranks of @p communicator keep. */
  std::map<std::string, std::set<unsigned int>>
  kept_items(const StateLayout &layout, const MPI_Comm communicator)
  {
    std::map<std::string, std::vector<unsigned int>> mine;
    for (const Record &record : layout.history.list())
      {
        EXPECT_EQ(mine.count(record.name), 0u);
        mine[record.name] = record.items;
      }
    std::map<std::string, std::set<unsigned int>> all;
    for (const auto &rank_items :
         dealii::Utilities::MPI::all_gather(communicator, mine))
      for (const auto &[name, items] : rank_items)
        {
          all[name].insert(items.begin(), items.end());
          // No rank keeps an item twice.
          EXPECT_EQ(std::set<unsigned int>(items.begin(), items.end()).size(),
                    items.size());
        }
    return all;
  }

  /** Value of each item of each record after a run. */
  std::map<std::string, std::map<unsigned int, std::vector<double>>>
  kept_values(const Advanced &run)
  {
    std::map<std::string, std::map<unsigned int, std::vector<double>>> values;
    for (const Record &record : run.on_ranks.equations.layout().history.list())
      for (unsigned int i = 0; i < record.items.size(); ++i)
        {
          const double *first = run.state.history.data() + record.first +
            i * record.values_per_item;
          values[record.name][record.items[i]] = {first,
                                                  first +
                                                    record.values_per_item};
        }
    return values;
  }

  void compare_history(const std::string              &text,
                       const std::vector<std::string> &overrides,
                       const unsigned int              n_records)
  {
    const Advanced all(text, overrides, MPI_COMM_WORLD),
      alone(text, overrides, MPI_COMM_SELF);
    const auto items =
      kept_items(alone.on_ranks.equations.layout(), MPI_COMM_SELF);
    EXPECT_EQ(items.size(), n_records);
    for (const auto &[name, numbers] : items)
      {
        // Numbered from 0 on; elements by their numbers in the lattice.
        if (name.rfind("struts", 0) != 0)
          {
            EXPECT_EQ(*numbers.rbegin() + 1, numbers.size()) << name;
          }
      }
    EXPECT_EQ(kept_items(all.on_ranks.equations.layout(), MPI_COMM_WORLD),
              items);

    const auto wanted  = kept_values(alone);
    double     largest = 0;
    for (const auto &[name, values] : kept_values(all))
      for (const auto &[item, item_values] : values)
        for (unsigned int k = 0; k < item_values.size(); ++k)
          {
            const double reference = wanted.at(name).at(item).at(k);
            largest                = std::max(largest, std::abs(reference));
            EXPECT_NEAR(item_values[k], reference, 1e-10)
              << name << ' ' << item;
          }
    EXPECT_GT(largest, 1e-5);
  }
} // namespace

TEST(Ranks, HistoryIsNamedAlikeOnAnyNumberOfRanks)
{
  // Internal variables of two groups, dissipated energies of four, internal
  // variables, strains and lost energies of struts.
  compare_history(star_with_everything(3, 3), {}, 9);
  compare_history(star_with_everything(3, 3) + yielding_struts("3, 40"),
                  {},
                  11);
  // Rotational springs are included.
  compare_history(space_star_with_everything(),
                  {"Time/Scheme=generalized-alpha"},
                  10);
}

namespace
{
  /** Numbers of the rotations of this rank, by name. */
  std::map<UnknownName, unsigned int>
  numbered_rotations(const std::string              &text,
                     const std::vector<std::string> &overrides,
                     const MPI_Comm                  communicator)
  {
    const EquationsOnRanks          on_ranks(text, overrides, communicator);
    const std::vector<NamedUnknown> names = name_unknowns(on_ranks.model);
    const std::vector<unsigned int> numbers =
      rotation_numbers(on_ranks.lattice, on_ranks.dofs());
    std::map<UnknownName, unsigned int> result;
    for (unsigned int i = 0; i < numbers.size(); ++i)
      result[names[on_ranks.dofs().rotations()[i][0]].name] = numbers[i];
    EXPECT_EQ(result.size(), numbers.size());
    return result;
  }

  void compare_numbers(const std::string              &text,
                       const std::vector<std::string> &overrides)
  {
    const auto alone = numbered_rotations(text, overrides, MPI_COMM_SELF);
    std::set<unsigned int> numbers;
    for (const auto &[name, number] : alone)
      numbers.insert(number);
    EXPECT_EQ(numbers.size(), alone.size());
    for (const auto &[name, number] :
         numbered_rotations(text, overrides, MPI_COMM_WORLD))
      EXPECT_EQ(number, alone.at(name));
  }
} // namespace

TEST(Ranks, RotationsAreNumberedAlikeOnAnyNumberOfRanks)
{
  compare_numbers(space_star_with_everything(),
                  {"Discretization/Order=3",
                   "Discretization/Global refinements=1"});
  compare_numbers(data_text("space-parts.prm"), {});
}

TEST(Ranks, GhostsOfAnAcceptedStateHaveTheValuesOfTheirOwners)
{
  const Advanced all(star_with_everything(3, 3), {}, MPI_COMM_WORLD);
  const auto    &dofs = all.on_ranks.dofs();
  for (const Vector *vector : {&all.state.displacement,
                               &*all.state.velocity,
                               &*all.state.acceleration})
    {
      Vector local(dofs.layout().n_local());
      std::copy_n(vector->begin(), dofs.layout().n_owned(), local.begin());
      dofs.layout().update_ghosts(local.data());
      // Each rank adds the same increments in the same order.
      for (unsigned int i = 0; i < dofs.layout().n_local(); ++i)
        EXPECT_EQ(local[i], (*vector)[i]);
    }
}
