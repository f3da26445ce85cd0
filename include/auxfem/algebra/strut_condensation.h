#ifndef auxfem_algebra_strut_condensation_h
#define auxfem_algebra_strut_condensation_h

#include <auxfem/algebra/direct_solver.h>
#include <auxfem/algebra/joint_system.h>

#include <memory>
#include <string>

namespace auxfem
{
  /**
   * Static condensation of A x = b: eliminates the unknowns I inside struts and
   * leaves those at joints J,
   *
   *     S z = g,  S = A_JJ - A_JI A_II^-1 A_IJ
   *
   * (E. L. Wilson, Int. J. Numer. Meth. Eng. 8, 1974, 198-203), element by
   * element along each strut. A strut whose inside other blocks act on is not
   * condensed. Prescribed rows of S are identity rows; prescribed columns move
   * to the right-hand side. S is symmetric if A is in free rows and columns.
   */
  class StrutCondensation
  {
  public:
    /**
     * @param matrix must outlive the object; only condense() needs its entries.
     */
    explicit StrutCondensation(const TangentMatrix &matrix);

    /**
     * Computes S from the matrix as it is now. Returns `singular` if the inside
     * of a strut is singular; see description(). Collective.
     */
    FactorizationOutcome condense(Symmetry symmetry);

    /** The strut whose condensation failed; empty if all succeeded. */
    const std::string &description() const
    {
      return failure_place;
    }

    /** S; valid until a condense() after a change of the pattern. */
    const SparseMatrix &matrix() const;

    /** Unknowns of S; valid as long as matrix(). */
    const Unknowns &joints() const;

    /** Version of the pattern that matrix() was made for. */
    unsigned long version() const
    {
      return built_version;
    }

    /**
     * Inertia of A_II over all ranks; none if it is unsymmetric. The inertia of
     * A is the sum of this and that of S (Haynsworth 1968), whose prescribed
     * rows add one positive eigenvalue each.
     */
    const std::optional<Inertia> &inner_inertia() const
    {
      return inertia;
    }

    /**
     * Sign of the determinant of A_II over all ranks, 1 or -1. The sign for A
     * is the product of this and that of S.
     */
    int inner_determinant_sign() const
    {
      return determinant;
    }

    /**
     * Computes the right-hand side @p g of S, owned rows with room for ghosts,
     * from @p values: b in owned rows, increments in prescribed ones. On return
     * @p values are the input of expand(). Collective.
     */
    void reduce(std::vector<double> &values, std::vector<double> &g) const;

    /**
     * Computes @p values at all local unknowns, ghosts included, from the
     * solution @p z of S z = g on owned rows. Collective.
     */
    void expand(std::vector<double> &z, std::vector<double> &values) const;

    /** Memory of the factors (bytes). */
    std::size_t memory() const
    {
      return factors.size() * sizeof(double);
    }

  private:
    void        update_pattern();
    std::size_t node_size(const StrutElements &elements) const;
    std::size_t factors_size(const StrutElements &elements) const;

    /** Scratch arrays used by all struts in turn. */
    struct Room
    {
      std::vector<double> element, strut, around_node, inner;
    };

    /**
     * Eliminates a strut: writes the factors to @p strut_factors and the
     * condensed block to Room::strut. Returns whether it is regular.
     */
    bool              condense_strut(const StrutElements &elements,
                                     double              *strut_factors,
                                     Room                &room,
                                     unsigned long       &n_negative) const;
    EliminationResult condense_element(const StrutElements &elements,
                                       std::size_t          block,
                                       double              *element_factors,
                                       Room                &room) const;
    EliminationResult eliminate_node(const StrutElements &elements,
                                     std::size_t          block,
                                     double              *node_factors,
                                     Room                &room) const;
    /** Terms added to the diagonal at these unknowns; nullptr if none. */
    const double *
    added(const int *unknowns, unsigned int n, std::vector<double> &room) const;
    bool has_finite_entries(const StrutElements &elements) const;
    void keep_prescribed_entries();
    void move_prescribed(std::vector<double> &values) const;
    /** Local unknowns between the nodes of element @p e of a strut. */
    const int *inner_unknowns(const StrutElements &elements,
                              unsigned int         e) const;
    /** Right-hand side and solution of a strut of several elements. */
    ///@{
    void reduce_chain(const StrutElements &elements,
                      const double        *strut_factors,
                      std::vector<double> &values,
                      const int           *ends,
                      std::vector<double> &g,
                      Room                &room) const;
    void expand_chain(const StrutElements       &elements,
                      const double              *strut_factors,
                      std::vector<double>       &values,
                      const int                 *ends,
                      const std::vector<double> &z,
                      Room                      &room) const;
    ///@}

    /**
     * Symmetry of nodes between elements, whose blocks are symmetrized already.
     */
    Symmetry symmetry_of_nodes() const
    {
      return symmetry == Symmetry::enforced ? Symmetry::given : symmetry;
    }

    const TangentMatrix         &tangent;
    unsigned long                built_version = 0;
    std::vector<StrutElements>   struts;
    std::unique_ptr<JointSystem> system;
    /**
     * Owned prescribed unknowns, blocks with any, and the entries of these
     * blocks.
     */
    ///@{
    std::vector<int>         prescribed_unknowns;
    std::vector<std::size_t> prescribed_blocks;
    std::vector<double>      prescribed_entries;
    ///@}
    Symmetry            symmetry = Symmetry::given;
    std::vector<double> factors;
    /** Index of the first factor of each strut, and the end. */
    std::vector<std::size_t> first_factor;
    std::optional<Inertia>   inertia;
    int                      determinant = 1; ///< its sign
    std::string              failure_place;
  };
} // namespace auxfem

#endif
