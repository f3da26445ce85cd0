#ifndef auxfem_tests_verification_node_unknowns_h
#define auxfem_tests_verification_node_unknowns_h

#include <deal.II/fe/fe_q.h>

#include <support/scene_run.h>

namespace auxfem
{
  namespace testing_support
  {
    /** Component and node of an unknown. */
    struct NodeUnknown
    {
      unsigned int     component; ///< 0, 1: displacement, 2: rotation
      int              partner;   ///< the node's other displacement
      dealii::Point<3> position;  ///< of its node at rest (m)
    };

    /** Nodes of all unknowns of struts and plates, by local number. */
    inline std::vector<NodeUnknown> node_unknowns(const LatticeModel &model)
    {
      const DofNumbering      &numbering = model.numbering;
      std::vector<NodeUnknown> result(numbering.layout().n_local());
      const auto nodes = dealii::FE_Q<1>(numbering.divisions().front().order)
                           .get_unit_support_points();
      for (unsigned int e = 0; e < numbering.elements().size(); ++e)
        {
          const StrutInterval &interval = numbering.elements()[e].interval;
          const int           *unknowns = numbering.element_unknowns(e);
          for (unsigned int a = 0; a < nodes.size(); ++a)
            {
              dealii::Point<3>     position;
              dealii::Tensor<1, 3> tangent;
              model.lattice.axis(model.lattice.struts[interval.strut],
                                 interval.at(2 * nodes[a][0] - 1),
                                 position,
                                 tangent);
              for (unsigned int c = 0; c < 3; ++c)
                result[unknowns[3 * a + c]] = {c,
                                               c < 2 ? unknowns[3 * a + 1 - c]
                                                     : -1,
                                               position};
            }
        }
      // Plates are joints without struts.
      for (unsigned int i = 0; i < model.lattice.n_plates; ++i)
        for (unsigned int c = 0; c < 2; ++c)
          {
            const unsigned int joint = model.lattice.joint_of_plate(i);
            result[numbering.joint_unknown(joint, c)] = {
              c,
              numbering.joint_unknown(joint, 1 - c),
              model.lattice.joints[joint]};
          }
      return result;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
