#ifndef auxfem_analysis_watched_part_h
#define auxfem_analysis_watched_part_h

#include <auxfem/equations/equations.h>
#include <auxfem/scene/scene.h>
#include <auxfem/time/records.h>

#include <string>

namespace auxfem
{
  /**
   * Which unknowns a watch looks at in a step. Steps of linear scenes cost
   * little more than a look at every unknown; of such scenes with many unknowns
   * a part is looked at for some steps, then the next, in turn, each several
   * times in the run. Else all are one part.
   */
  class WatchedPart
  {
  public:
    /** @param n_steps accepted ones, of any length, for which a part is looked
     *   at, at least
     * @param time (s) for which it is, at least */
    WatchedPart(const Scene     &scene,
                const Equations &equations,
                unsigned int     n_steps,
                double           time = 0);

    /** The same on all ranks. */
    unsigned int n_parts() const
    {
      return n;
    }

    /** Of a local unknown. */
    unsigned int part_of(const unsigned int unknown) const
    {
      // Neighbours stay together, as they lie in memory.
      constexpr unsigned int n_neighbours = 8;
      return unknown / n_neighbours % n;
    }

    /** The one whose turn it is. */
    unsigned int now() const
    {
      return part;
    }

    /** Before a step of @p dt (s); whether another part takes its turn from it
     * on. */
    bool passes_on(double dt);

    /** @name For runs that are resumed.
     * @param name of the watch */
    ///@{
    void save(const std::string &name, Records &records) const;
    /** Returns whether the part is made of the same unknowns as before. */
    bool resume(const std::string &name, const Records &records);
    ///@}

  private:
    const UnknownLayout &layout;
    const unsigned int   n, n_steps;
    const double         time; ///< s
    unsigned int         part = 0, n_done = 0;
    double               elapsed = 0; ///< s
  };
} // namespace auxfem

#endif
