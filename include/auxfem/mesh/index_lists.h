#ifndef auxfem_mesh_index_lists_h
#define auxfem_mesh_index_lists_h

#include <deal.II/base/array_view.h>

#include <numeric>
#include <vector>

namespace auxfem
{
  /** Many lists of indices, one behind the other in memory. */
  class IndexLists
  {
  public:
    IndexLists() = default;

    /**
     * @param n_lists number of lists
     * @param for_each_entry calls what it is given with the number of a list
     * and an index for it, for each entry; the same each time
     */
    template <class ForEachEntry>
    IndexLists(const std::size_t n_lists, const ForEachEntry &for_each_entry)
      : first(n_lists + 2, 0)
    {
      // Counted one place ahead, so that places are the first ones when all
      // are filled.
      for_each_entry(
        [this](const std::size_t list, unsigned int) { ++first[list + 2]; });
      std::partial_sum(first.begin(), first.end(), first.begin());
      entries.resize(first.back());
      for_each_entry([this](const std::size_t list, const unsigned int index) {
        entries[first[list + 1]++] = index;
      });
    }

    /** A list, in the order in which it was given. */
    dealii::ArrayView<const unsigned int>
    operator[](const std::size_t list) const
    {
      return {entries.data() + first[list], first[list + 1] - first[list]};
    }

  private:
    std::vector<unsigned int> first, entries;
  };
} // namespace auxfem

#endif
