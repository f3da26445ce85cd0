#ifndef auxfem_analysis_spaced_looks_h
#define auxfem_analysis_spaced_looks_h

#include <auxfem/model/effect_decisions.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /** Steps after which a run is looked at: with inertia, where a step does
   * little, some of them and the last; without it all. */
  class SpacedLooks
  {
  public:
    /** @param distance steps between two looks with inertia */
    SpacedLooks(const Scene            &scene,
                const SimulatedEffects &simulated,
                const unsigned int      distance)
      : distance(simulated.inertia ? distance : 1)
      , end_time(scene.time.end_time)
    {}

    /** Of each step, which ends at @p time (s): whether to look at it. */
    bool are_due(const double time)
    {
      if (++n_steps < distance && time < end_time)
        return false;
      n_steps = 0;
      return true;
    }

    /** @name For runs that are resumed: steps since the last look. */
    ///@{
    double save() const
    {
      return n_steps;
    }
    void resume(const double saved)
    {
      n_steps = saved;
    }
    ///@}

  private:
    const unsigned int distance;
    const double       end_time; ///< s
    unsigned int       n_steps = 0;
  };
} // namespace auxfem

#endif
