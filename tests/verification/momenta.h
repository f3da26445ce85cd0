#ifndef auxfem_tests_verification_momenta_h
#define auxfem_tests_verification_momenta_h

#include <deal.II/fe/fe_q.h>

#include <support/scene_run.h>

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
      explicit MomentumMeter(SceneRun &run)
        : run(run)
        , mass(run.system.make_tangent())
        , momentum(run.system.numbering().owned_map())
        , places(momentum.MyLength())
      {
        const State before = run.state;
        run.system.tangent({before, run.state, 0}, {0, 0, 1}, *mass);
        find_nodes();
      }

      Momenta operator()()
      {
        mass->matrix().Multiply(false, *run.state.velocity, momentum);
        const double *u = run.state.displacement.Values();
        Momenta       sum;
        for (int i = 0; i < momentum.MyLength(); ++i)
          {
            const Place &at = places[i];
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
      struct Place
      {
        unsigned int     component = 0;
        int              partner   = 0; ///< the node's other displacement
        dealii::Point<3> position;      ///< at rest
      };

      void find_nodes()
      {
        const DofNumbering &numbering = run.system.numbering();
        const auto          nodes =
          dealii::FE_Q<1>(numbering.order()).get_unit_support_points();
        for (unsigned int e = 0; e < numbering.elements().size(); ++e)
          {
            const StrutMesh::Place &place    = numbering.elements()[e].place;
            const int              *unknowns = numbering.element_unknowns(e);
            for (unsigned int a = 0; a < nodes.size(); ++a)
              {
                dealii::Point<3>     position;
                dealii::Tensor<1, 3> tangent;
                run.lattice.axis(run.lattice.struts[place.strut],
                                 place.begin +
                                   (place.end - place.begin) * nodes[a][0],
                                 position,
                                 tangent);
                for (unsigned int c = 0; c < 3; ++c)
                  places[unknowns[3 * a + c]] = {c,
                                                 c < 2 ? unknowns[3 * a + 1 - c]
                                                       : 0,
                                                 position};
              }
          }
      }

      SceneRun                      &run;
      std::unique_ptr<TangentMatrix> mass;
      Epetra_Vector                  momentum;
      std::vector<Place>             places;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
