#ifndef auxfem_equations_node_masses_h
#define auxfem_equations_node_masses_h

#include <auxfem/equations/equations.h>

#include <vector>

namespace auxfem
{
  /** A mass attached to a displacement unknown. */
  struct NodeMass
  {
    int    unknown; ///< local
    double mass;    ///< kg
  };

  /** Mass of element @p e lumped to its nodes by Gauss-Lobatto weights. */
  std::vector<double> node_masses(const LatticeModel &model, unsigned int e);

  /**
   * All lumped masses of this rank per displacement component: struts, point
   * masses and rigid parts, at their centre of mass or half at each base joint.
   * Excludes rotary inertia.
   */
  std::vector<NodeMass> all_masses(const Equations &equations);

  /**
   * Total mass of struts, point masses, rigid parts and plates (kg).
   * Collective.
   */
  double total_mass(const Equations &equations);
} // namespace auxfem

#endif
