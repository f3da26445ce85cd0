#ifndef auxfem_algebra_joint_system_h
#define auxfem_algebra_joint_system_h

#include <auxfem/algebra/inner_elimination.h>
#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/algebra/unknowns.h>

#include <memory>

namespace auxfem
{
  /**
   * Equations of the unknowns that remain after struts are eliminated. The
   * matrix is the sum of one condensed block per strut and all other blocks of
   * the pattern; prescribed rows are identity rows, prescribed columns are
   * dropped. The rank that owns the inside of a strut eliminates it and sends
   * its block to the owners of its end joints. StrutCondensation uses it.
   */
  class JointSystem
  {
  public:
    /** @param struts the eliminated struts. Collective. */
    JointSystem(const TangentPattern             &pattern,
                const std::vector<StrutElements> &struts);

    JointSystem(const JointSystem &)            = delete;
    JointSystem &operator=(const JointSystem &) = delete;

    const SparseMatrix &matrix() const;

    /** The unknowns of matrix(). */
    const Unknowns &unknowns() const
    {
      return joint_unknowns;
    }

    /** Local unknowns of the pattern, indexed by unknowns of the system. */
    const std::vector<int> &retained_unknowns() const;

    /** Prescribed unknowns of the system, ghosts included. */
    const std::vector<int> &prescribed() const
    {
      return prescribed_unknowns;
    }

    /** Sets all entries to zero, and prescribed rows to identity rows. */
    void reset(Symmetry symmetry);

    /** Adds the condensed row-major @p block of strut @p number. */
    void add_strut(std::size_t number, const double *block);

    /**
     * Adds all blocks that do not belong to struts, and exchanges the strut
     * blocks of other ranks. Collective.
     */
    void add_others(const TangentMatrix &matrix);

    /**
     * Adds values at ghosts to their owners, for ghosts at ends of struts
     * eliminated here. Collective.
     */
    void add_ghosts_to_owners(std::vector<double> &values) const;

    /**
     * Local unknowns of the system at the ends of strut @p number, first node
     * first.
     */
    const int *ends(const std::size_t number) const
    {
      return end_unknowns.data() + number * n_ends;
    }

  private:
    /** Data sent to one rank. */
    struct Neighbour
    {
      std::vector<std::size_t> struts;
      std::vector<int>         ghosts; ///< ends of these struts that it owns
    };

    void find_neighbours();
    void share_struts();
    void share_ends();
    void make_unknowns(const Unknowns &all);
    void make_assembly(const TangentPattern &pattern);

    const std::vector<StrutElements>     &struts;
    std::unique_ptr<UnknownSelection>     selection;
    Unknowns                              joint_unknowns;
    std::vector<int>                      prescribed_unknowns;
    std::size_t                           n_ends = 0; ///< of a strut
    std::vector<int>                      end_unknowns;
    std::map<unsigned int, Neighbour>     neighbours;
    std::vector<std::vector<std::size_t>> positions_to_send; ///< by strut
    std::vector<double>                   to_send;
    NeighbourExchange                     block_exchange, end_exchange;
    std::vector<int>                      received_unknowns;
    std::vector<int>                      received_ends;
    /** Blocks of the pattern that do not belong to eliminated struts. */
    std::vector<std::size_t>        other_blocks;
    std::unique_ptr<SparseAssembly> assembly;
  };
} // namespace auxfem

#endif
