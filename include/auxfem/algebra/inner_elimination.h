#ifndef auxfem_algebra_inner_elimination_h
#define auxfem_algebra_inner_elimination_h

#include <auxfem/algebra/tangent_matrix.h>

namespace auxfem
{
  /**
   * Sizes of a dense block: unknowns at its ends first, then the inner ones to
   * eliminate,
   *
   *     [ A_EE A_EI ]
   *     [ A_IE A_II ],   S = A_EE - A_EI A_II^-1 A_IE.
   */
  struct EliminationSizes
  {
    unsigned int n_inner, n_ends;
  };

  /** Outcome of an elimination. */
  struct EliminationResult
  {
    bool is_regular = true;
    /**
     * Negative eigenvalues of A_II; if it is unsymmetric, odd if and only if
     * its determinant is negative.
     */
    unsigned int n_negative = 0;
  };

  /**
   * Elimination of the inner unknowns of blocks of one size, once for all
   * right-hand sides. It stores the dense matrices A_II^-1 and A_II^-1 A_IE,
   * and A_EI A_II^-1 if A is unsymmetric, in factor_size() numbers: products
   * with them vectorize, unlike triangular substitution.
   */
  class InnerElimination
  {
  public:
    virtual ~InnerElimination() = default;

    virtual std::size_t factor_size(Symmetry symmetry) const = 0;

    /**
     * Eliminates the inner unknowns of the row-major @p block and writes S,
     * row-major, to @p condensed. A_II counts as singular if a pivot is
     * round-off of the terms it is the difference of.
     *
     * @param added added to the diagonal of A_II; may be nullptr
     */
    virtual EliminationResult eliminate(const double *block,
                                        const double *added,
                                        Symmetry      symmetry,
                                        double       *factors,
                                        double       *condensed) const = 0;

    /**
     * Subtracts A_EI A_II^-1 x_I from x_E.
     * @param inner, ends positions of the entries of x_I in @p inner_values, of
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
   * Elimination for blocks of this size, or nullptr. Supported are elements
   * with nodes of 3 unknowns up to order 6 and of 6 up to order 4, and the node
   * between two elements.
   */
  const InnerElimination *inner_elimination(EliminationSizes sizes);

  /**
   * Elements of a strut whose inside can be eliminated on this rank:
   * consecutive blocks, each on the unknowns of its first node, of its last
   * node (the first of the next block), then of those between.
   */
  struct StrutElements
  {
    unsigned int strut;
    std::size_t  first_block;
    unsigned int n_elements;
    /** Numbers of unknowns of a node and of an element. */
    unsigned int n_node_unknowns, n_element_unknowns;
    /** Eliminates the unknowns between the nodes; nullptr if there are none. */
    const InnerElimination *between_nodes;
    /** Eliminates a node between two elements. */
    const InnerElimination *node;

    unsigned int n_between_nodes() const
    {
      return n_element_unknowns - 2 * n_node_unknowns;
    }
  };

  /**
   * The struts of @p pattern whose inside is owned and free, and not touched by
   * blocks other than its elements'.
   */
  std::vector<StrutElements> find_strut_elements(const TangentPattern &pattern);
} // namespace auxfem

#endif
