#ifndef auxfem_tests_elements_beam_3d_on_trial_h
#define auxfem_tests_elements_beam_3d_on_trial_h

#include <auxfem/struts/beam_3d_tangent.h>
#include <auxfem/struts/beam_dispatch.h>

#include <struts/beam_on_trial.h>

#include <array>
#include <cmath>
#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /** Axis and section axes of a strut at rest. */
    struct Beam3DShape
    {
      double curvature; ///< of the axis, a helix about z (1/m); 0: straight
      double rise;      ///< dz/ds
      double twist;     ///< twist rate of the section (rad/m)

      SpaceVector position(const double s) const
      {
        const double along = std::sqrt(1 - rise * rise);
        if (curvature == 0)
          return SpaceVector({along * s, 0., rise * s});
        const double angle = curvature * s, radius = along / curvature;
        return SpaceVector(
          {radius * std::sin(angle), radius * (1 - std::cos(angle)), rise * s});
      }

      SpaceTensor axes(const double s) const
      {
        const double      along = std::sqrt(1 - rise * rise);
        const SpaceVector tangent({along * std::cos(curvature * s),
                                   along * std::sin(curvature * s),
                                   rise});
        return rotated(exponential(twist * s * tangent),
                       section_frame(tangent, default_reference(tangent)));
      }
    };

    /** One beam element in space, with distinct section stiffnesses of equal
     * size, so that no term hides behind another. */
    template <int p>
    class Beam3DOnTrial
    {
    public:
      static constexpr int order             = p;
      static constexpr int n                 = Beam3D::n_components * (p + 1);
      using Vector                           = std::array<double, n>;
      using Matrix                           = std::array<double, n * n>;
      using Nodes                            = std::array<Beam3D::Node, p + 1>;
      const Beam3D::Stiffness        section = {3, 2, 1.6, 0.9, 0.7, 1.2};
      const double                   jacobian;
      const BeamShape<p>             shape;
      std::array<SpaceVector, p + 1> positions;
      std::array<Beam3D::Frame, p>   frames;

      Beam3DOnTrial(const double       length,
                    const Beam3DShape &rest,
                    const bool         makes_up_for_shear = false)
        : jacobian(length / 2)
        , shape(makes_up_for_shear ? BeamShape<p>::max_compensated_shear : 0.)
      {
        for (int a = 0; a <= p; ++a)
          positions[a] = rest.position(jacobian * (1 + shape.node[a]));
        for (int g = 0; g < p; ++g)
          {
            SpaceVector slope;
            for (int a = 0; a <= p; ++a)
              slope += shape.derivative[g][a] / jacobian * positions[a];
            frames[g] = {rest.axes(jacobian * (1 + shape.point[g])), slope};
          }
      }

      Beam3D::ElementKinematics<p> kinematics(const Nodes &nodes) const
      {
        return {shape, frames.data(), jacobian, nodes.data()};
      }

      double force(const Nodes &nodes, Vector &result) const
      {
        return Beam3D::internal_force(shape,
                                      kinematics(nodes),
                                      jacobian,
                                      Beam3D::ElasticSection{section},
                                      result.data());
      }

      Matrix tangent(const Nodes &nodes, const double factor = 1) const
      {
        Matrix matrix;
        Beam3D::tangent(shape,
                        kinematics(nodes),
                        jacobian,
                        Beam3D::ElasticSection{section},
                        factor,
                        matrix.data());
        return matrix;
      }

      Beam3D::Strains strains(const Nodes &nodes, const int g) const
      {
        return kinematics(nodes).points[g].strains;
      }

      /** Node motion of displacements and rotation vectors @p u. */
      static Nodes nodes_of(const Vector &u)
      {
        Nodes nodes;
        for (int a = 0; a <= p; ++a)
          {
            const double *at = u.data() + Beam3D::n_components * a;
            nodes[a]         = {SpaceVector({at[0], at[1], at[2]}),
                                exponential(SpaceVector({at[3], at[4], at[5]}))};
          }
        return nodes;
      }

      /** Rotates @p nodes about the origin, then translates them. */
      Nodes moved(Nodes              nodes,
                  const Quaternion  &rotation,
                  const SpaceVector &shift) const
      {
        for (int a = 0; a <= p; ++a)
          nodes[a] = {rotated(rotation, positions[a] + nodes[a].displacement) +
                        shift - positions[a],
                      rotation * nodes[a].rotation};
        return nodes;
      }

      /** Varies unknown @p j of @p nodes by @p step. */
      static Nodes varied(Nodes nodes, const int j, const double step)
      {
        Beam3D::Node &node      = nodes[j / Beam3D::n_components];
        const int     component = j % Beam3D::n_components;
        if (component < 3)
          node.displacement[component] += step;
        else
          {
            SpaceVector spin;
            spin[component - 3] = step;
            node.rotation       = exponential(spin) * node.rotation;
          }
        return nodes;
      }
    };

    /** Calls @p check with straight and curved elements of orders 1 to 4, with
     * and without shear flexibility. */
    template <class Check>
    void for_each_beam_3d(const Check &check)
    {
      for (unsigned int order = 1; order <= 4; ++order)
        for (const double curvature : {0., 0.8})
          for (const bool makes_up_for_shear : {false, true})
            {
              SCOPED_TRACE("order " + std::to_string(order) + ", curvature " +
                           std::to_string(curvature) +
                           (makes_up_for_shear ? ", without shear" : ""));
              dispatch_order(order, [&](auto p) {
                check(Beam3DOnTrial<p>(1.6,
                                       {curvature, 0.3, curvature},
                                       makes_up_for_shear));
              });
            }
    }

    /** Calls @p check with straight elements of length 1.6 along x. */
    template <class Check>
    void for_each_straight_beam_3d(const Check &check)
    {
      for (unsigned int order = 1; order <= 4; ++order)
        {
          SCOPED_TRACE("order " + std::to_string(order));
          dispatch_order(order, [&](auto p) {
            check(Beam3DOnTrial<p>(1.6, {0, 0, 0}));
          });
        }
    }
  } // namespace testing_support
} // namespace auxfem

#endif
