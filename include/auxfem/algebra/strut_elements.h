#ifndef auxfem_algebra_strut_elements_h
#define auxfem_algebra_strut_elements_h

#include <auxfem/algebra/inner_elimination.h>

namespace auxfem
{
  /**
   * The elements of a strut whose inside can be eliminated on this rank: blocks
   * one after the other, each on the unknowns of its first node, of its last
   * one, which is the first of the next, and then of those between.
   */
  struct StrutElements
  {
    unsigned int strut;
    std::size_t  first_block;
    unsigned int n_elements;
    /** Unknowns of a node and of an element. */
    unsigned int n_of_node, n_of_element;
    /** Eliminates what is between the nodes; nullptr if nothing is. */
    const InnerElimination *between_nodes;
    /** Eliminates a node between two elements. */
    const InnerElimination *node;

    unsigned int n_between_nodes() const
    {
      return n_of_element - 2 * n_of_node;
    }
  };

  /**
   * The struts of @p pattern whose inside can be eliminated: it is owned and
   * free, and nothing but its elements acts on it.
   */
  std::vector<StrutElements> find_strut_elements(const TangentPattern &pattern);
} // namespace auxfem

#endif
