#include <gtest/gtest.h>

#include "beam_3d_on_trial.h"

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // Forces are sums of some 100 products of numbers of about 1 to 10, each
  // rounded once.
  constexpr double planar_round_off = 1e-12;
} // namespace

namespace
{
  /** Unknown of the beam in space for an unknown of the planar beam. */
  int in_space(const int planar)
  {
    const int component = planar % 3;
    return Beam3D::n_components * (planar / 3) +
      (component == 2 ? 5 : component);
  }

  struct Differences
  {
    double energy, force, tangent;
  };

  /** A beam in space with the axis and section of a planar test beam. */
  template <int p>
  class PlanarBeamInSpace
  {
  public:
    static constexpr int   n = 3 * (p + 1);
    const BeamOnTrial<p>   planar;
    const Beam3DOnTrial<p> space;

    explicit PlanarBeamInSpace(const double curvature)
      : planar(1.6, 0, curvature)
      , space(1.6, {curvature, 0, 0})
    {}

    /** Largest differences under a planar motion. */
    Differences differences(const typename BeamOnTrial<p>::Vector &u) const
    {
      typename Beam3DOnTrial<p>::Vector in_space_u{}, force;
      typename BeamOnTrial<p>::Vector   planar_force;
      for (int i = 0; i < n; ++i)
        in_space_u[in_space(i)] = u[i];
      const auto element = space.kinematics(space.nodes_of(in_space_u));
      const Beam3D::Stiffness section = {planar.section.axial,
                                         planar.section.shear,
                                         5,
                                         6,
                                         7,
                                         planar.section.bending};
      const double            energy =
        Beam3D::internal_force(space.shape,
                               element,
                               space.jacobian,
                               Beam3D::ElasticSection{section},
                               force.data());
      typename Beam3DOnTrial<p>::Matrix matrix;
      Beam3D::tangent(space.shape,
                      element,
                      space.jacobian,
                      Beam3D::ElasticSection{section},
                      1.,
                      matrix.data());
      const auto planar_energy =
        planar.template force<true, false>(u, u, planar_force);
      const auto planar_matrix =
        planar.template tangent<true, false>(u, u, 1, 0);
      Differences worst = {std::abs(energy - planar_energy.strain), 0, 0};
      for (int i = 0; i < n; ++i)
        {
          worst.force =
            std::max(worst.force,
                     std::abs(force[in_space(i)] - planar_force[i]));
          for (int j = 0; j < n; ++j)
            worst.tangent =
              std::max(worst.tangent,
                       std::abs(matrix[in_space(i) * space.n + in_space(j)] -
                                planar_matrix[i * n + j]));
        }
      return worst;
    }
  };

  /** Calls @p check with pairs of planar beams and beams in space. */
  template <class Check>
  void for_each_planar_beam(const Check &check)
  {
    for (unsigned int order = 1; order <= 4; ++order)
      for (const double curvature : {0., 0.8})
        {
          SCOPED_TRACE("order " + std::to_string(order) + ", curvature " +
                       std::to_string(curvature));
          dispatch_order(order, [&](auto p) {
            check(PlanarBeamInSpace<p>(curvature));
          });
        }
  }
} // namespace

TEST(PlanarMotionOfBeam3D, EqualsThePlanarBeam)
{
  for_each_planar_beam([](const auto &beams) {
    using Vector = typename std::decay_t<decltype(beams.planar)>::Vector;
    auto u       = irregular<Vector>(0.3, 9);
    for (unsigned int i = 2; i < u.size(); i += 3)
      u[i] = 2.2 + 3 * u[i];
    const auto worst = beams.differences(u);
    EXPECT_LT(worst.energy, planar_round_off);
    EXPECT_LT(worst.force, planar_round_off);
    EXPECT_LT(worst.tangent, 10 * planar_round_off);
  });
}
