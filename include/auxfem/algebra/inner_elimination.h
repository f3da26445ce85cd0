#ifndef auxfem_algebra_inner_elimination_h
#define auxfem_algebra_inner_elimination_h

#include <auxfem/algebra/tangent_matrix.h>

namespace auxfem
{
  /**
   * A dense block of a few unknowns, those at its ends first, then the inner
   * ones that are eliminated:
   *
   *     [ A_EE A_EI ]
   *     [ A_IE A_II ],   S = A_EE - A_EI A_II^-1 A_IE.
   */
  struct EliminationSizes
  {
    unsigned int n_inner, n_ends;
  };

  /** What came of an elimination. */
  struct EliminationResult
  {
    bool is_regular = true;
    /** Negative eigenvalues of A_II; where it is unsymmetric, an odd number if
     * its determinant is negative, else an even one. */
    unsigned int n_negative = 0;
  };

  /**
   * Elimination of the inner unknowns of one size of blocks, once for all
   * right-hand sides. What these need are small dense matrices, A_II^-1 and
   * A_II^-1 A_IE, besides A_EI A_II^-1 where A is unsymmetric: products with
   * them, unlike substitution with triangles, do not wait for one another. They
   * take factor_size() numbers.
   */
  class InnerElimination
  {
  public:
    virtual ~InnerElimination() = default;

    virtual std::size_t factor_size(Symmetry symmetry) const = 0;

    /**
     * Eliminates the inner unknowns of the whole row-major @p block; returns S,
     * row-major, in @p condensed. An A_II is not regular if a pivot is the
     * round-off of what it was the difference of.
     *
     * @param added to the diagonal of A_II; none: nullptr
     */
    virtual EliminationResult eliminate(const double *block,
                                        const double *added,
                                        Symmetry      symmetry,
                                        double       *factors,
                                        double       *condensed) const = 0;

    /**
     * Subtracts A_EI A_II^-1 x_I from x_E.
     * @param inner, ends where the entries of x_I stand in @p inner_values, those of
     *   x_E in @p end_values
     */
    virtual void reduce(const double *factors,
                        Symmetry      symmetry,
                        const int    *inner,
                        const double *inner_values,
                        const int    *ends,
                        double       *end_values) const = 0;

    /** Replaces x_I by A_II^-1 (x_I - A_IE x_E). */
    virtual void expand(const double *factors,
                        const int    *inner,
                        double       *inner_values,
                        const int    *ends,
                        const double *end_values) const = 0;
  };

  /**
   * The elimination for blocks of this size; nullptr if there is none. There
   * are those for elements with nodes of 3 unknowns up to order 6 and of 6 up
   * to order 4, and for the node between two elements.
   */
  const InnerElimination *inner_elimination(EliminationSizes sizes);

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
    unsigned int n_node_unknowns, n_element_unknowns;
    /** Eliminates what is between the nodes; nullptr if nothing is. */
    const InnerElimination *between_nodes;
    /** Eliminates a node between two elements. */
    const InnerElimination *node;

    unsigned int n_between_nodes() const
    {
      return n_element_unknowns - 2 * n_node_unknowns;
    }
  };

  /**
   * The struts of @p pattern whose inside can be eliminated: it is owned and
   * free, and nothing but its elements acts on it.
   */
  std::vector<StrutElements> find_strut_elements(const TangentPattern &pattern);
} // namespace auxfem

#endif
