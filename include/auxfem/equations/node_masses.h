#ifndef auxfem_equations_node_masses_h
#define auxfem_equations_node_masses_h

#include <auxfem/equations/equations.h>

#include <vector>

namespace auxfem
{
  /** A mass that moves with a displacement. */
  struct NodeMass
  {
    int    unknown; ///< local
    double mass;    ///< kg
  };

  /**
   * The mass of element @p e of the numbering on its nodes, by the weights of
   * Gauss and Lobatto (exact for polynomials of one degree less than twice the
   * order), by node.
   */
  std::vector<double> node_masses(const LatticeModel &model, unsigned int e);

  /**
   * All masses that this rank counts, for each component of displacements: of
   * struts, point masses, and of rigid parts half at each end of their base, or
   * at their centre of mass. Rotary inertia is left out.
   */
  std::vector<NodeMass> all_masses(const Equations &equations);

  /** Of struts, point masses, rigid parts and plates (kg). Collective. */
  double total_mass(const Equations &equations);
} // namespace auxfem

#endif
