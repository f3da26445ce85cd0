#ifndef auxfem_tests_verification_momenta_h
#define auxfem_tests_verification_momenta_h

#include <verification/node_unknowns.h>

namespace auxfem
{
  namespace testing_support
  {
    /** Linear momentum (N s) and moment of momentum about the origin (N m s).
     */
    struct Momenta
    {
      double x = 0, y = 0, moment = 0;
    };

    /** Momenta from M v at the current nodes; for lattices without supports. */
    class MomentumMeter
    {
    public:
      /** @param state is that which is measured, and must outlive the meter. */
      MomentumMeter(const Equations &equations, const State &state)
        : state(state)
        , mass(mass_matrix(equations, state))
        , momentum(equations.model().numbering.layout().n_owned())
        , unknowns(node_unknowns(equations.model()))
      {}

      explicit MomentumMeter(const SceneRun &run)
        : MomentumMeter(run.equations, run.state)
      {}

      Momenta operator()()
      {
        mass->multiply(state.velocity->data(), momentum.data());
        const double *u = state.displacement.data();
        Momenta       sum;
        for (unsigned int i = 0; i < momentum.size(); ++i)
          {
            const NodeUnknown &at = unknowns[i];
            if (at.component == 0)
              {
                sum.x += momentum[i];
                sum.moment -= (at.position[1] + u[at.partner]) * momentum[i];
              }
            else if (at.component == 1)
              {
                sum.y += momentum[i];
                sum.moment += (at.position[0] + u[at.partner]) * momentum[i];
              }
            else
              sum.moment += momentum[i];
          }
        return sum;
      }

    private:
      const State                   &state;
      std::unique_ptr<TangentMatrix> mass;
      Vector                         momentum;
      std::vector<NodeUnknown>       unknowns;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
