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
    /** Negative eigenvalues of A_II; unknown where it is unsymmetric. */
    unsigned int n_negative = 0;
  };

  /** A_IE and A_EI in row-major storage; the latter not used where A is
   * symmetric. */
  struct EliminationCouplings
  {
    const double *inner_ends;
    unsigned int  inner_ends_stride;
    const double *ends_inner;
    unsigned int  ends_inner_stride;
  };

  /**
   * Elimination of the inner unknowns of one size of blocks: L D L^T of a
   * symmetric A_II, else L U with its rows exchanged. The factors take
   * factor_size() numbers.
   */
  class InnerElimination
  {
  public:
    virtual ~InnerElimination() = default;

    virtual std::size_t factor_size(Symmetry symmetry) const = 0;

    /**
     * Factorizes A_II of the whole row-major @p block into @p factors and
     * returns S, row-major, in @p condensed. An A_II is not regular if a pivot
     * is the round-off of what it was the difference of.
     *
     * @param added to the diagonal of A_II; none: nullptr
     */
    virtual EliminationResult eliminate(const double *block,
                                        const double *added,
                                        Symmetry      symmetry,
                                        double       *factors,
                                        double       *condensed) const = 0;

    /** Subtracts A_EI A_II^-1 @p of_inner from @p of_ends. */
    virtual void reduce(const double               *factors,
                        const EliminationCouplings &couplings,
                        Symmetry                    symmetry,
                        const double               *of_inner,
                        double                     *of_ends) const = 0;

    /** Replaces @p of_inner by A_II^-1 (of_inner - A_IE of_ends). */
    virtual void expand(const double               *factors,
                        const EliminationCouplings &couplings,
                        Symmetry                    symmetry,
                        const double               *of_ends,
                        double                     *of_inner) const = 0;
  };

  /**
   * The elimination for blocks of this size; nullptr if there is none. There
   * are those for elements with nodes of 3 unknowns up to order 6 and of 6 up
   * to order 4, and for the node between two elements.
   */
  const InnerElimination *inner_elimination(EliminationSizes sizes);
} // namespace auxfem

#endif
