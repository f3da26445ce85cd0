#include <auxfem/mathematics/lanes.h>
#include <auxfem/struts/beam_3d_damping.h>

#include <gtest/gtest.h>
#include <struts/beam_3d_on_trial.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // Both sum the same products. Sines and cosines differ in the last digit, and
  // terms are some hundred times larger than the sum.
  constexpr double lanes_round_off = 1e-12;

  /**
   * Motions of the lanes (rad, m): some rotations are small enough for series,
   * others are not.
   */
  constexpr double sizes[] = {1e-4, 1.2, 0.3, 0.6};
  static_assert(std::size(sizes) >= n_lanes);

  /** One of @p objects for each lane. */
  ///@{
  template <class T, std::size_t... lane>
  LaneArray<T> one_each(const std::vector<T> &objects,
                        std::index_sequence<lane...>)
  {
    return {{objects[lane]...}};
  }

  template <class T>
  LaneArray<T> one_each(const std::vector<T> &objects)
  {
    return one_each(objects, std::make_index_sequence<n_lanes>());
  }
  ///@}

  /** Irregular numbers that differ from lane to lane. */
  template <class Array>
  LaneArray<Array> irregular_lanes(const unsigned int seed)
  {
    LaneArray<Array> result;
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
      result[lane] = irregular<Array>(sizes[lane], seed + lane);
    return result;
  }

  /**
   * Largest difference between @p numbers and those in @p lane, relative to the
   * largest number.
   */
  template <class Array>
  double difference(const Array                                       &numbers,
                    const std::array<Lanes, std::tuple_size_v<Array>> &lanes,
                    const std::size_t                                  lane)
  {
    Array deviation = numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      deviation[i] -= lane_value(lanes[i], lane);
    return largest(deviation) / largest(numbers);
  }

  /** Plane elements of different lengths, directions and curvatures. */
  template <int order>
  struct PlaneElements
  {
    using Beam                  = BeamOnTrial<order>;
    using Vector                = typename Beam::Vector;
    using Matrix                = typename Beam::Matrix;
    const LaneArray<Beam> beams = one_each<Beam>(
      {{1.6, 0.4, 0.}, {0.7, 2., 0.8}, {2.2, -1., -0.3}, {1., 3., 0.}});
    const LaneArray<Vector> u = irregular_lanes<Vector>(1),
                            v = irregular_lanes<Vector>(11);

    std::array<Beam2D::FrameOf<Lanes>, order> frames() const
    {
      LaneArray<std::array<Beam2D::Frame, order>> by_beam;
      for (std::size_t lane = 0; lane < n_lanes; ++lane)
        std::copy_n(beams[lane].gauss_frames(), order, by_beam[lane].begin());
      return pack_lanes<std::array<Beam2D::FrameOf<Lanes>, order>>(by_beam);
    }

    Lanes jacobian() const
    {
      return make_lanes([&](const auto lane) { return beams[lane].jacobian; });
    }

    Beam2D::StiffnessOf<Lanes> section() const
    {
      LaneArray<Beam2D::Stiffness> by_beam;
      by_beam.fill(beams[0].section);
      return pack_lanes<Beam2D::StiffnessOf<Lanes>>(by_beam);
    }
  };

  template <int order, bool large_rotation, bool damped>
  void expect_plane_beams_agree()
  {
    using Elements = PlaneElements<order>;
    using Vector   = typename Elements::Vector;
    using Matrix   = typename Elements::Matrix;
    const Elements        elements;
    constexpr std::size_t n      = std::tuple_size_v<Vector>;
    const auto            frames = elements.frames();
    const auto            u      = pack_lanes<std::array<Lanes, n>>(elements.u),
               v                 = pack_lanes<std::array<Lanes, n>>(elements.v);
    std::array<Lanes, n>         force;
    std::array<Lanes, n * n>     matrix;
    const auto                   stiffness = elements.section();
    const Beam2D::ElasticSection section{stiffness};
    const auto energy = Beam2D::internal_force<order, large_rotation, damped>(
      elements.beams[0].shape,
      frames.data(),
      elements.jacobian(),
      section,
      u.data(),
      v.data(),
      force.data());
    Beam2D::tangent<order, large_rotation, damped>(elements.beams[0].shape,
                                                   frames.data(),
                                                   elements.jacobian(),
                                                   section,
                                                   u.data(),
                                                   v.data(),
                                                   0.9,
                                                   2.5,
                                                   matrix.data());
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
      {
        SCOPED_TRACE("lane " + std::to_string(lane));
        const auto &beam = elements.beams[lane];
        Vector      beam_force;
        const auto  beam_energy =
          beam.template force<large_rotation, damped>(elements.u[lane],
                                                      elements.v[lane],
                                                      beam_force);
        const Matrix beam_tangent =
          beam.template tangent<large_rotation, damped>(elements.u[lane],
                                                        elements.v[lane],
                                                        0.9,
                                                        2.5);
        EXPECT_NEAR(lane_value(energy.strain, lane) / beam_energy.strain,
                    1,
                    lanes_round_off);
        if (damped)
          {
            EXPECT_NEAR(lane_value(energy.dissipation, lane) /
                          beam_energy.dissipation,
                        1,
                        lanes_round_off);
          }

        EXPECT_LT(difference(beam_force, force, lane), lanes_round_off);
        EXPECT_LT(difference(beam_tangent, matrix, lane), lanes_round_off);
      }
  }

  /**
   * Elements in space of different shapes, with nodal velocities and their
   * derivatives by spins.
   */
  template <int order>
  struct SpaceElements
  {
    using Beam       = Beam3DOnTrial<order>;
    using Vector     = typename Beam::Vector;
    using Velocities = std::array<Beam3D::NodeVelocity, order + 1>;
    using Tensors    = std::array<SpaceTensor, order + 1>;

    const LaneArray<Beam> beams = one_each<Beam>({{1.6, {0., 0.3, 0.}},
                                                  {0.7, {0.8, 0.3, 0.8}},
                                                  {2.2, {0.4, -0.5, 0.}},
                                                  {1., {0., 1., 0.7}}});
    LaneArray<typename Beam::Nodes> nodes;
    LaneArray<Velocities>           velocities;
    LaneArray<Tensors>              by_spin;

    SpaceElements()
    {
      const auto u = irregular_lanes<Vector>(1),
                 v = irregular_lanes<Vector>(11),
                 w = irregular_lanes<Vector>(21);
      for (std::size_t lane = 0; lane < n_lanes; ++lane)
        {
          nodes[lane] = Beam::nodes_of(u[lane]);
          for (int a = 0; a <= order; ++a)
            for (int i = 0; i < 3; ++i)
              {
                velocities[lane][a].linear[i]  = v[lane][6 * a + i];
                velocities[lane][a].angular[i] = v[lane][6 * a + 3 + i];
                for (int j = 0; j < 3; ++j)
                  by_spin[lane][a][i][j] = w[lane][6 * a + i + j];
              }
        }
    }

    std::array<Beam3D::FrameOf<Lanes>, order> frames() const
    {
      LaneArray<const std::array<Beam3D::Frame, order> *> by_beam;
      for (std::size_t lane = 0; lane < n_lanes; ++lane)
        by_beam[lane] = &beams[lane].frames;
      return pack_lanes<std::array<Beam3D::FrameOf<Lanes>, order>>(by_beam);
    }

    Lanes jacobian() const
    {
      return make_lanes([&](const auto lane) { return beams[lane].jacobian; });
    }

    Beam3D::StiffnessOf<Lanes> section() const
    {
      LaneArray<Beam3D::Stiffness> by_beam;
      by_beam.fill(beams[0].section);
      return pack_lanes<Beam3D::StiffnessOf<Lanes>>(by_beam);
    }
  };

  /** Force and tangent of elastic and damping forces, of double or Lanes. */
  template <int order, class Number>
  struct SpaceResults
  {
    static constexpr int      n = 6 * (order + 1);
    Number                    energy, power;
    std::array<Number, n>     force;
    std::array<Number, n * n> matrix;
    static constexpr double   stiffness_factor = 0.9, damping_factor = 2.5;

    SpaceResults(const BeamShape<order>               &shape,
                 const Beam3D::FrameOf<Number>        *frames,
                 const Number                          jacobian,
                 const Beam3D::StiffnessOf<Number>    &section,
                 const Beam3D::NodeOf<Number>         *nodes,
                 const Beam3D::NodeVelocityOf<Number> *velocities,
                 const TensorOf<Number>               *by_spin)
    {
      const Beam3D::ElementKinematics<order, Number> element(shape,
                                                             frames,
                                                             jacobian,
                                                             nodes);
      const Number                                   damping_time = 0.4;
      energy = Beam3D::internal_force(shape,
                                      element,
                                      jacobian,
                                      Beam3D::ElasticSection{section},
                                      force.data());
      power  = Beam3D::add_damping_force(shape,
                                        element,
                                        jacobian,
                                        section,
                                        damping_time,
                                        velocities,
                                        force.data());
      Beam3D::tangent(shape,
                      element,
                      jacobian,
                      Beam3D::ElasticSection{section},
                      Number(stiffness_factor),
                      matrix.data());
      Beam3D::add_damping_tangent(shape,
                                  element,
                                  jacobian,
                                  section,
                                  damping_time,
                                  velocities,
                                  stiffness_factor,
                                  damping_factor,
                                  by_spin,
                                  matrix.data());
    }
  };

  /** As SpaceResults, for small displacements. */
  template <int order, class Number>
  struct SmallDisplacementResults
  {
    static constexpr int      n = 6 * (order + 1);
    Number                    energy;
    std::array<Number, n>     force;
    std::array<Number, n * n> matrix;

    SmallDisplacementResults(const BeamShape<order>            &shape,
                             const Beam3D::FrameOf<Number>     *frames,
                             const Number                       jacobian,
                             const Beam3D::StiffnessOf<Number> &section,
                             const Number                      *u)
    {
      energy = Beam3D::small_displacement_force(shape,
                                                frames,
                                                jacobian,
                                                Beam3D::ElasticSection{section},
                                                u,
                                                force.data());
      Beam3D::small_displacement_tangent(shape,
                                         frames,
                                         jacobian,
                                         Beam3D::ElasticSection{section},
                                         u,
                                         Number(0.9),
                                         matrix.data());
    }
  };
} // namespace

TEST(Lanes, UnpackToTheObjectsTheyWerePackedFrom)
{
  using Object = std::array<double, 3>;
  LaneArray<Object> objects;
  for (std::size_t lane = 0; lane < n_lanes; ++lane)
    objects[lane] = {{1. + lane, -0.5 * lane, 1e-3}};
  const auto lanes = pack_lanes<std::array<Lanes, 3>>(objects);
  for (std::size_t lane = 0; lane < n_lanes; ++lane)
    EXPECT_EQ(unpack_lane<Object>(lanes, lane), objects[lane]);
}

TEST(Lanes, KeepTheOrderOfTheNumbersOfObjects)
{
  using Nodes      = std::array<Beam3D::Node, 2>;
  using LanesNodes = std::array<Beam3D::NodeOf<Lanes>, 2>;
  LaneArray<Nodes> nodes;
  double           number = 0;
  for (Nodes &lane_nodes : nodes)
    for (Beam3D::Node &node : lane_nodes)
      {
        for (int i = 0; i < 3; ++i)
          node.displacement[i] = ++number;
        node.rotation.scalar = ++number;
        for (int i = 0; i < 3; ++i)
          node.rotation.vector[i] = ++number;
      }
  const auto lanes = pack_lanes<LanesNodes>(nodes);
  for (std::size_t lane = 0; lane < n_lanes; ++lane)
    for (int a = 0; a < 2; ++a)
      {
        const Beam3D::Node &node = nodes[lane][a];
        for (int i = 0; i < 3; ++i)
          {
            const Lanes displacement = lanes[a].displacement[i],
                        vector       = lanes[a].rotation.vector[i];
            EXPECT_EQ(lane_value(displacement, lane), node.displacement[i]);
            EXPECT_EQ(lane_value(vector, lane), node.rotation.vector[i]);
          }
        EXPECT_EQ(lane_value(lanes[a].rotation.scalar, lane),
                  node.rotation.scalar);
      }
}

TEST(Lanes, AreCopiedOneByOne)
{
  const Lanes lanes[] = {make_lanes([](const auto lane) { return 10. + lane; }),
                         make_lanes(
                           [](const auto lane) { return 20. + lane; })};
  for (std::size_t lane = 0; lane < n_lanes; ++lane)
    {
      double numbers[2];
      copy_lane(lanes, lane, numbers);
      EXPECT_EQ(numbers[0], 10. + lane);
      EXPECT_EQ(numbers[1], 20. + lane);
    }
}

TEST(Lanes, BeamsInThePlaneAgreeWithScalarOnes)
{
  for (unsigned int order = 1; order <= largest_plane_order; ++order)
    {
      SCOPED_TRACE("order " + std::to_string(order));
      dispatch_order(order, [](auto p) {
        expect_plane_beams_agree<p, true, false>();
        expect_plane_beams_agree<p, true, true>();
        expect_plane_beams_agree<p, false, true>();
      });
    }
}

TEST(Lanes, BeamsInSpaceAgreeWithScalarOnes)
{
  for (unsigned int order = 1; order <= largest_space_order; ++order)
    {
      SCOPED_TRACE("order " + std::to_string(order));
      dispatch_order<largest_space_order>(order, [](auto p) {
        const SpaceElements<p> elements;
        const auto             frames = elements.frames();
        const auto             nodes =
          pack_lanes<std::array<Beam3D::NodeOf<Lanes>, p + 1>>(elements.nodes);
        const auto velocities =
          pack_lanes<std::array<Beam3D::NodeVelocityOf<Lanes>, p + 1>>(
            elements.velocities);
        const auto by_spin =
          pack_lanes<std::array<TensorOf<Lanes>, p + 1>>(elements.by_spin);
        const SpaceResults<p, Lanes> lanes(elements.beams[0].shape,
                                           frames.data(),
                                           elements.jacobian(),
                                           elements.section(),
                                           nodes.data(),
                                           velocities.data(),
                                           by_spin.data());
        for (std::size_t lane = 0; lane < n_lanes; ++lane)
          {
            SCOPED_TRACE("lane " + std::to_string(lane));
            const auto                   &beam = elements.beams[lane];
            const SpaceResults<p, double> single(
              beam.shape,
              beam.frames.data(),
              beam.jacobian,
              beam.section,
              elements.nodes[lane].data(),
              elements.velocities[lane].data(),
              elements.by_spin[lane].data());
            EXPECT_NEAR(lane_value(lanes.energy, lane) / single.energy,
                        1,
                        lanes_round_off);
            EXPECT_NEAR(lane_value(lanes.power, lane) / single.power,
                        1,
                        lanes_round_off);
            EXPECT_LT(difference(single.force, lanes.force, lane),
                      lanes_round_off);
            EXPECT_LT(difference(single.matrix, lanes.matrix, lane),
                      lanes_round_off);
          }
      });
    }
}

TEST(Lanes, SmallDisplacementsInSpaceAgreeWithScalarOnes)
{
  for (unsigned int order = 1; order <= largest_space_order; ++order)
    {
      SCOPED_TRACE("order " + std::to_string(order));
      dispatch_order<largest_space_order>(order, [](auto p) {
        const SpaceElements<p> elements;
        using Vector             = typename SpaceElements<p>::Vector;
        const auto frames        = elements.frames();
        const auto displacements = irregular_lanes<Vector>(31);
        const auto u = pack_lanes<std::array<Lanes, std::tuple_size_v<Vector>>>(
          displacements);
        const SmallDisplacementResults<p, Lanes> lanes(elements.beams[0].shape,
                                                       frames.data(),
                                                       elements.jacobian(),
                                                       elements.section(),
                                                       u.data());
        for (std::size_t lane = 0; lane < n_lanes; ++lane)
          {
            SCOPED_TRACE("lane " + std::to_string(lane));
            const auto &beam = elements.beams[lane];
            const SmallDisplacementResults<p, double> single(
              beam.shape,
              beam.frames.data(),
              beam.jacobian,
              beam.section,
              displacements[lane].data());
            EXPECT_NEAR(lane_value(lanes.energy, lane) / single.energy,
                        1,
                        lanes_round_off);
            EXPECT_LT(difference(single.force, lanes.force, lane),
                      lanes_round_off);
            EXPECT_LT(difference(single.matrix, lanes.matrix, lane),
                      lanes_round_off);
          }
      });
    }
}
