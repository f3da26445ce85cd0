#ifndef auxfem_algebra_tangent_pattern_h
#define auxfem_algebra_tangent_pattern_h

#include <auxfem/algebra/unknowns.h>

#include <cstddef>
#include <functional>

namespace auxfem
{
  /**
   * Which unknowns act on each other: dense blocks on the unknowns that effects
   * register. It may change between steps; its version then changes too.
   *
   * The blocks of a strut's elements can be condensed if they are registered
   * one after the other along it, each on the unknowns of its first node, of
   * its last one, and then of those between (see StrutCondensation).
   */
  class TangentPattern
  {
  public:
    /** @param unknowns must outlive the object. */
    explicit TangentPattern(const Unknowns &unknowns);

    /**
     * Announces a dense block on @p n local unknowns (entries -1: not there).
     * A block is announced on all ranks that own one of its unknowns. Returns
     * its number; blocks are numbered in the order in which they come.
     */
    std::size_t register_block(const int *unknowns, unsigned int n);

    /**
     * Announces a block for each of @p items, on the array of unknowns that
     * @p unknowns_of (a member or a function) gives of it. Returns the number of
     * the first.
     */
    template <class Items, class UnknownsOf>
    std::size_t register_blocks(const Items      &items,
                                const UnknownsOf &unknowns_of)
    {
      const std::size_t first_of_items = n_blocks();
      for (const auto &item : items)
        {
          const auto &unknowns = std::invoke(unknowns_of, item);
          register_block(std::data(unknowns), std::size(unknowns));
        }
      return first_of_items;
    }

    /** No blocks; @p unknowns must outlive the object. */
    void reset(const Unknowns &unknowns);

    /** A number that grows with every change. */
    unsigned long version() const
    {
      return changes;
    }

    const Unknowns &unknowns() const
    {
      return *all;
    }

    std::size_t n_blocks() const
    {
      return first.size() - 1;
    }

    /** Begin and end of the unknowns of a block. */
    ///@{
    const int *begin(const std::size_t block) const
    {
      return of_blocks.data() + first[block];
    }

    const int *end(const std::size_t block) const
    {
      return of_blocks.data() + first[block + 1];
    }
    ///@}

    /** Number of unknowns of a block. */
    unsigned int size(const std::size_t block) const
    {
      return first[block + 1] - first[block];
    }

  private:
    const Unknowns          *all;
    std::vector<int>         of_blocks;
    std::vector<std::size_t> first; ///< of each block, and the end of the last
    unsigned long            changes = 0;
  };
} // namespace auxfem

#endif
