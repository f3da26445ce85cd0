#include <auxfem/contact/effects/touching_struts.h>

#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <random>
#include <set>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Two struts of two elements each that press on each other. */
  SceneText pressed_struts(const unsigned int dimension)
  {
    return SceneText()
      .dimension(dimension)
      .frame(dimension == 2 ? "0 0; 1 0; 0.3 0.22; 1.1 0.23"
                            : "0 0 0; 1 0 0.05; 0.5 -0.6 0.24; 0.4 0.5 0.27",
             "0 1; 2 3")
      .rectangle("bar", "0.2 m", "0.2 m", {"1 Pa", 1, 0.3})
      .set("Lattice/Struts may cross", "true")
      .set("Contact/Smoothing", 0.5)
      .set("Time/Time step", 0.1)
      .set("Time/End time", 1)
      .mesh(3, 1);
  }

  /** The contact effect of two pressed struts alone. */
  struct Pressed
  {
    Pressed(const SceneText &text, const unsigned int seed)
      : setup(text.str(), {}, MPI_COMM_SELF)
      , kept(make_strut_contact(setup.model))
      , effect(*kept)
      , from(setup.equations.initial_state())
      , to(from)
      , generator(seed)
    {
      StateLayout layout;
      layout.acceleration = true;
      effect.register_in(layout);
      make_room(layout, from);
      // The second strut touches the first one lightly so far.
      lower_second_strut(0.03, from);
      add_noise(0.004, from.displacement);
      to = from;
      lower_second_strut(0.03, to);
      add_noise(0.004, to.displacement);
      add_noise(0.5, *to.velocity);
      to.time = dt;
      std::vector<int> required_unknowns;
      effect.update_couplings(to, required_unknowns);
      tangent = std::make_unique<TangentAlone>(effect, setup.dofs());
    }

    /** Moves all its nodes along the last axis. */
    void lower_second_strut(const double way, State &state) const
    {
      const DofNumbering &dofs = setup.dofs();
      std::set<int>       heights;
      for (unsigned int e = 0; e < dofs.elements().size(); ++e)
        if (dofs.elements()[e].interval.strut == 1)
          for (unsigned int node = 0; node <= dofs.elements()[e].order; ++node)
            heights.insert(dofs.element_unknowns(
              e)[node * dofs.n_components() + setup.lattice.dimension - 1]);
      for (const int height : heights)
        state.displacement[height] -= way;
    }

    void add_noise(const double size, Vector &vector)
    {
      for (double &value : vector)
        value += std::uniform_real_distribution<double>(-size, size)(generator);
    }

    Evaluation evaluation(State &state, const Evaluation::Kind kind) const
    {
      return {from, state, kind, dt};
    }

    const double                        dt = 0.1;
    EquationsOnRanks                    setup;
    const std::unique_ptr<StrutContact> kept;
    StrutContact                       &effect;
    State                               from, to;
    std::mt19937                        generator;
    std::unique_ptr<TangentAlone>       tangent;
  };

  /** Compares the tangent with differences of the residual. */
  void expect_tangent(const SceneText       &text,
                      const Evaluation::Kind kind,
                      const TangentFactors  &factors,
                      const double           tolerance)
  {
    for (unsigned int seed = 1; seed < 6; ++seed)
      {
        Pressed              pressed(text, seed);
        const EvaluatedAlone at(pressed.effect,
                                pressed.evaluation(pressed.to, kind));
        ASSERT_FALSE(
          static_cast<const ContactResults<StrutTouch> &>(*at.results)
            .points.empty());
        pressed.tangent->fill(at, factors);
        double       largest = 0, error = 0;
        const double h = 1e-7;
        for (std::size_t i = 0; i < pressed.to.displacement.size(); ++i)
          {
            std::vector<double> direction(pressed.to.displacement.size(), 0.);
            direction[i] = 1;
            const std::vector<double> column =
              pressed.tangent->times(direction);
            const auto residual = [&](const double step) {
              State moved = pressed.to;
              moved.displacement[i] +=
                (kind == Evaluation::Kind::discrete_gradient
                   ? 1.
                   : factors.stiffness) *
                step;
              (*moved.velocity)[i] += factors.damping * step;
              return EvaluatedAlone(pressed.effect,
                                    pressed.evaluation(moved, kind))
                .residual;
            };
            const std::vector<double> after  = residual(h),
                                      before = residual(-h);
            for (std::size_t k = 0; k < column.size(); ++k)
              {
                largest = std::max(largest, std::abs(column[k]));
                error   = std::max(error,
                                 std::abs(column[k] -
                                          (after[k] - before[k]) / (2 * h)));
              }
          }
        EXPECT_GT(largest, 0);
        EXPECT_LT(error, tolerance * largest) << "seed " << seed;
      }
  }
} // namespace

TEST(StrutContact, TangentsAreDerivatives)
{
  for (const unsigned int dimension : {2u, 3u})
    {
      SCOPED_TRACE(std::to_string(dimension) + " dimensions");
      expect_tangent(pressed_struts(dimension),
                     Evaluation::Kind::step,
                     {0.7, 0, 0},
                     1e-5);
      // Includes the change of direction and location of friction.
      SceneText rubbed = pressed_struts(dimension);
      rubbed.set("Contact/Friction coefficient", 0.4)
        .set("Contact/Slip velocity", 0.3);
      for (const TangentFactors &factors : {TangentFactors{0.7, 0, 0},
                                            TangentFactors{0, 3, 0},
                                            TangentFactors{0.7, 3, 0}})
        expect_tangent(rubbed, Evaluation::Kind::step, factors, 1e-5);
      // Velocity is the displacement over the step of 0.1 s.
      expect_tangent(rubbed, Evaluation::Kind::static_step, {1, 10, 0}, 1e-5);
    }
}

TEST(StrutContact, MeanForcesConserveMomentumAndReportTheirEnergyDefect)
{
  for (const unsigned int dimension : {2u, 3u})
    for (unsigned int seed = 1; seed < 6; ++seed)
      {
        SCOPED_TRACE(std::to_string(dimension) + " dimensions, seed " +
                     std::to_string(seed));
        Pressed              pressed(pressed_struts(dimension), seed);
        const EvaluatedAlone step(
          pressed.effect,
          pressed.evaluation(pressed.to, Evaluation::Kind::discrete_gradient));
        State                before = pressed.from;
        const EvaluatedAlone at_start(pressed.effect,
                                      Evaluation::consistent_rates(pressed.from,
                                                                   before));
        const double         stored_before = at_start.accept().stored(),
                     stored                = step.accept().stored();
        ASSERT_GT(stored, stored_before);
        double work = 0;
        for (std::size_t i = 0; i < step.residual.size(); ++i)
          work += step.residual[i] *
            (pressed.to.displacement[i] - pressed.from.displacement[i]);
        const double missed = pressed.to.energies.numerical();
        EXPECT_NEAR(work, stored - stored_before + missed, 1e-13 * stored);
        // The defect is of third order in the step, which is large here.
        EXPECT_LT(std::abs(missed), 0.05 * (stored - stored_before));

        const std::vector<NamedUnknown> names =
          name_unknowns(pressed.setup.model);
        dealii::Tensor<1, 3>                force, moment;
        double                              size = 0;
        std::map<UnknownName, unsigned int> unknowns;
        for (unsigned int i = 0; i < names.size(); ++i)
          unknowns[names[i].name] = i;
        for (const auto &[name, i] : unknowns)
          if (std::get<3>(name) == 0)
            {
              dealii::Tensor<1, 3> position, node_force;
              for (unsigned int c = 0; c < dimension; ++c)
                {
                  auto component_name         = name;
                  std::get<3>(component_name) = c;
                  const unsigned int k        = unknowns.at(component_name);
                  node_force[c]               = step.residual[k];
                  position[c]                 = names[k].position[c] +
                    (pressed.from.displacement[k] +
                     pressed.to.displacement[k]) /
                      2;
                }
              force += node_force;
              moment += dealii::cross_product_3d(position, node_force);
              size += node_force.norm();
            }
        EXPECT_LT(force.norm(), 1e-13 * size);
        EXPECT_LT(moment.norm(), 1e-13 * size);
      }
}
