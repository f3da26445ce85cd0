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
   * The unknowns that are left when those inside struts are eliminated, and the
   * matrix of their equations as the sum of one block for each strut and of all
   * other blocks of the pattern. Prescribed rows are those of the identity and
   * prescribed columns are left out.
   *
   * A strut is eliminated on the rank that owns its inside, which sends its
   * block to the ranks that own joints at its ends.
   */
  class JointSystem
  {
  public:
    /** @param struts those that are eliminated. Collective. */
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

    /** Local unknowns of the pattern, by those of the system. */
    const std::vector<int> &retained_unknowns() const;

    /** Prescribed ones among unknowns(), ghosts included. */
    const std::vector<int> &prescribed() const
    {
      return prescribed_unknowns;
    }

    /** Entries zero but for prescribed rows. */
    void reset(Symmetry symmetry);

    /** Adds the square row-major @p block that is left of strut @p number. */
    void add_strut(std::size_t number, const double *block);

    /** Adds all blocks that do not belong to struts, and what add_strut() has
     * set aside for other ranks. Collective. */
    void add_others(const TangentMatrix &matrix);

    /** Adds the values at ghosts to their owners; those of ghosts at ends of
     * struts that are eliminated here. Collective. */
    void add_ghosts_to_owners(std::vector<double> &values) const;

    /** Local unknowns of the system at the ends of strut @p number, first node
     * first. */
    const int *ends(const std::size_t number) const
    {
      return end_unknowns.data() + number * n_ends;
    }

  private:
    /** What goes to one rank. */
    struct Neighbour
    {
      std::vector<std::size_t> struts;
      std::vector<int>         ghosts; ///< their ends that it owns
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
    /** Blocks of the pattern that do not belong to struts. */
    std::vector<std::size_t>        other_blocks;
    std::unique_ptr<SparseAssembly> assembly;
  };
} // namespace auxfem

#endif
