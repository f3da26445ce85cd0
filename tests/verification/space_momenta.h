#ifndef auxfem_tests_verification_space_momenta_h
#define auxfem_tests_verification_space_momenta_h

#include <deal.II/fe/fe_q.h>

#include <verification/space_text.h>

#include <map>
#include <memory>

namespace auxfem
{
  namespace testing_support
  {
    /** Linear momentum (N s) and moment of momentum about the origin (N m s).
     */
    struct SpaceMomenta
    {
      SpaceVector linear, angular;
    };

    /**
     * Momenta of struts and masses in space, for lattices without supports.
     * The mass matrix at rest takes velocities to the momentum of each node and
     * material angular velocities to its material moment of momentum.
     */
    class SpaceMomentumMeter
    {
    public:
      /** @param state is that which is measured; both must outlive the meter. */
      SpaceMomentumMeter(const Equations &equations, const State &state)
        : dofs(equations.model().numbering)
        , state(state)
        , mass(mass_matrix(equations, state))
        , momentum(dofs.layout().n_owned())
      {
        const Lattice &lattice = equations.model().lattice;
        const auto     points  = dealii::FE_Q<1>(dofs.divisions().front().order)
                              .get_unit_support_points();
        for (unsigned int e = 0; e < dofs.elements().size(); ++e)
          for (unsigned int a = 0; a < points.size(); ++a)
            {
              const StrutInterval &interval = dofs.elements()[e].interval;
              dealii::Point<3>     position;
              SpaceVector          tangent;
              lattice.axis(lattice.struts[interval.strut],
                           interval.at(2 * points[a][0] - 1),
                           position,
                           tangent);
              nodes[dofs.element_unknowns(e)[6 * a]] = position;
            }
      }

      explicit SpaceMomentumMeter(const SceneRun &run)
        : SpaceMomentumMeter(run.equations, run.state)
      {}

      SpaceMomenta operator()()
      {
        mass->multiply(state.velocity->data(), momentum.data());
        SpaceMomenta sum;
        for (const auto &[first, position] : nodes)
          {
            const SpaceVector p = values(momentum, first);
            sum.linear += p;
            sum.angular +=
              dealii::cross_product_3d(position +
                                         values(state.displacement, first),
                                       p);
            sum.angular +=
              rotated(state.rotations[dofs.rotations().with(first + 3)],
                      values(momentum, first + 3));
          }
        return sum;
      }

    private:
      static SpaceVector values(const Vector &vector, const int first)
      {
        return SpaceVector(
          {vector[first], vector[first + 1], vector[first + 2]});
      }

      const DofNumbering            &dofs;
      const State                   &state;
      std::unique_ptr<TangentMatrix> mass;
      Vector                         momentum;
      /** Position at rest by the first unknown of the node. */
      std::map<int, SpaceVector> nodes;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
