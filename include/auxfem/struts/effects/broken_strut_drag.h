#ifndef auxfem_struts_effects_broken_strut_drag_h
#define auxfem_struts_effects_broken_strut_drag_h

#include <vector>

namespace auxfem
{
  /**
   * Viscous forces c (v_i - v_j) / d between neighbouring nodes of the elements
   * of broken struts, with their distance d over the mean one. Without
   * stiffness, each node would fly on alone and stretch its elements through
   * the lattice; with these forces what is left of a strut soon moves like a
   * slack chain between its joints. Rotations stay free.
   */
  class BrokenStrutDrag
  {
  public:
    /** @param nodes positions in [-1, 1], in the order of the unknowns
     * @param n_components unknowns per node: 3 in the plane, 6 in space */
    BrokenStrutDrag(const std::vector<double> &nodes,
                    unsigned int               n_components);

    /** Adds the forces at velocities @p v to @p residual, both by local
     * unknown.
     * @param c coefficient (N s/m) */
    void add_force(double        c,
                   const int    *unknowns,
                   const double *v,
                   double       *residual) const;

    /** Adds @p c times the derivative of the forces by the velocities to an
     * element @p block. */
    void add_block(double c, double *block) const;

    /** Power of the forces of velocities @p v with rates @p w, over c
     * (m2/s2). */
    double power(const int *unknowns, const double *v, const double *w) const;

  private:
    /** Two nodes, one beside the other. */
    struct Pair
    {
      unsigned int first, second;
      double       weight; ///< 1 / d
    };

    /** Calls @p action with the positions, among the unknowns of an element, of
     * each pair of components, and its weight. */
    template <class Action>
    void for_each_pair(const Action &action) const;

    const unsigned int n_nodes, n_components, n_translations;
    std::vector<Pair>  pairs;
  };
} // namespace auxfem

#endif
