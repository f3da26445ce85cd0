#ifndef auxfem_analysis_small_motions_root_search_h
#define auxfem_analysis_small_motions_root_search_h

#include <auxfem/analysis/small_motions/root_count.h>

#include <algorithm>
#include <vector>

namespace auxfem
{
  /** Finds roots of a characteristic equation in a region, each once, those on
   * or above the real axis. What computes is collective. */
  class RootSearch
  {
  public:
    using Complex = CharacteristicEquation::Complex;
    using Root    = CharacteristicEquation::Root;

    /**
     * @param equation, layout must outlive the object
     * @param known roots that have been found before
     */
    RootSearch(CharacteristicEquation  &equation,
               const UnknownLayout     &layout,
               const RootRegion        &region,
               const std::vector<Root> &known);

    /**
     * Looks for roots until there are @p n in the region, of two conjugate ones
     * both, as n_roots() counts: from @p starts and then from all over the
     * region.
     */
    void find(unsigned int n, const std::vector<Complex> &starts);

    /** Those in the region, by rising |s|. */
    std::vector<Root> found() const;

    /** Of found() those that were not known before. */
    std::vector<Root> found_anew() const;

    /** Of @p root alone or with its conjugate. */
    static unsigned int weight(const Root &root)
    {
      return root.s.imag() > 0 ? 2 : 1;
    }

    /** Of all that were found. */
    unsigned int weight() const;

    /** What lacks to @p n in the region, as n_roots() counts. */
    unsigned int n_missing(const unsigned int n) const
    {
      return std::max(n, weight()) - weight();
    }

  private:
    /** How a root is found from a start. */
    enum class Way
    {
      deflation,        ///< one that is not known
      inverse_iteration ///< one near the start
    };

    std::optional<Complex> newton(Complex start);
    void                   find_from(Complex start, Way way);
    bool                   is_new(const Root &root) const;

    CharacteristicEquation &equation;
    const UnknownLayout    &layout;
    const RootRegion        region;
    /** Outside of the region, too: none is found again. */
    std::vector<Root> roots;
    std::size_t       n_given;
  };
} // namespace auxfem

#endif
