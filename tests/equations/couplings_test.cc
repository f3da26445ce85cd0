#include <auxfem/time/time_stepper.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <iterator>

// Couplings that appear during a run between unknowns of different ranks.

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A spring along x between two joints, from a time on. */
  class LateSpring : public Effect, public ChangingCouplings
  {
  public:
    LateSpring(const LatticeModel               &model,
               const std::array<unsigned int, 2> joints,
               const double                      stiffness,
               const double                      from_time)
      : numbers({{model.numbering.global().joints[joints[0]][0],
                  model.numbering.global().joints[joints[1]][0]}})
      , layout(&model.numbering.layout())
      , stiffness(stiffness)
      , from_time(from_time)
    {}

    bool is_linear() const override
    {
      return true;
    }

    bool update_couplings(const State      &accepted,
                          std::vector<int> &required_unknowns) override
    {
      if (acts || accepted.time < from_time)
        return false;
      acts = true;
      required_unknowns.insert(required_unknowns.end(),
                               numbers.begin(),
                               numbers.end());
      return true;
    }

    void register_blocks(TangentPattern &pattern) override
    {
      if (!acts)
        return;
      layout = &pattern.unknowns().layout;
      for (unsigned int i = 0; i < 2; ++i)
        unknowns[i] = layout->local(numbers[i]);
      block = pattern.register_block(unknowns.data(), 2);
    }

    void add_residual(const Evaluation &evaluation,
                      double           *residual,
                      EffectCache * /*results*/) const override
    {
      if (!acts)
        return;
      const double *u     = evaluation.to.displacement.data();
      const double  force = stiffness * (u[unknowns[1]] - u[unknowns[0]]);
      residual[unknowns[0]] -= force;
      residual[unknowns[1]] += force;
    }

    void add_tangent(const Evaluation & /*evaluation*/,
                     const EffectCache * /*results*/,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const override
    {
      if (!acts)
        return;
      const double k         = stiffness * factors.stiffness;
      const double values[4] = {k, -k, -k, k};
      matrix.add(block, values);
    }

  private:
    const std::array<int, 2> numbers;
    const UnknownLayout     *layout;
    const double             stiffness, from_time;
    bool                     acts     = false;
    std::array<int, 2>       unknowns = {{-1, -1}};
    std::size_t              block    = 0;
  };

  /** Four cantilevers side by side; the first is pulled along x. */
  const SceneText cantilevers =
    frame_scene("0 0; 0 1; 1 0; 1 1; 2 0; 2 1; 3 0; 3 1", "0 1; 2 3; 4 5; 6 7")
      .support("ground", "0, 2, 4, 6", "clamp")
      .add("Loads/pull", "Joints = 1 | Force x = 0.01")
      .time(4, 0.1);

  /** Displacements of the free ends along x at the end. */
  std::vector<double> ends_of_run(const MPI_Comm communicator)
  {
    const Scene   scene   = read_scene_from_text(cantilevers, "test.prm", {});
    const Lattice lattice = build_lattice(scene);
    const LatticeModel                   model(scene, lattice, communicator);
    std::vector<std::unique_ptr<Effect>> further;
    further.push_back(
      std::make_unique<LateSpring>(model,
                                   std::array<unsigned int, 2>{{1, 7}},
                                   0.5,
                                   1.95));
    Equations   equations(model, std::move(further));
    Work        work;
    TimeStepper stepper(equations, work);
    Solution    solution = equations.initial_solution();
    stepper.start(solution);
    Recorder            nobody;
    std::vector<double> ends;
    for (unsigned int step = 0; step < 40; ++step)
      {
        stepper.advance(solution, nobody);
        if (step != 19 && step != 39)
          continue;
        for (const unsigned int joint : {1u, 3u, 5u, 7u})
          {
            const int unknown = model.numbering.joint_unknown(joint, 0);
            ends.push_back(model.numbering.layout().sum(
              model.numbering.layout().is_owned(unknown)
                ? solution.state.displacement[unknown]
                : 0.));
          }
      }
    return ends;
  }
} // namespace

TEST(Couplings, MayAppearBetweenUnknownsOfAnyRanks)
{
  const std::vector<double> all   = ends_of_run(MPI_COMM_WORLD),
                            alone = ends_of_run(MPI_COMM_SELF);
  // Before the spring acts only the first end moves; then also the last.
  EXPECT_GT(alone[0], 1e-3);
  EXPECT_EQ(alone[3], 0.);
  EXPECT_GT(std::abs(alone[7]), 1e-3);
  EXPECT_EQ(alone[5], 0.);
  ASSERT_EQ(all.size(), alone.size());
  for (unsigned int i = 0; i < all.size(); ++i)
    EXPECT_NEAR(all[i], alone[i], 1e-12) << i;
}
