#ifndef auxfem_analysis_touch_watch_h
#define auxfem_analysis_touch_watch_h

#include <auxfem/analysis/watch.h>
#include <auxfem/equations/strut_lookout.h>

namespace auxfem
{
  /** Struts that have come to touch where contact is left out. */
  struct FirstTouch
  {
    std::array<unsigned int, 2> struts;
    double                      time; ///< end of the step (s)
  };

  /**
   * Looks for the first struts that touch in a run that ends there, as one by
   * small displacements does. Finds nothing wrong with what came before, and
   * has nothing to remember: what a resumed run may touch next follows from
   * where it is.
   */
  class TouchWatch : public Watch
  {
  public:
    explicit TouchWatch(std::unique_ptr<StrutLookout> lookout)
      : lookout(std::move(lookout))
    {}

    void step(const Evaluation        &step,
              const EvaluationResults &results,
              TangentSolver           &solver) override;

    const std::optional<FirstTouch> &first_touch() const
    {
      return first;
    }

    std::vector<Finding> findings() const override
    {
      return {};
    }

    void save(Records & /*records*/) const override
    {}

    void resume(const Records & /*records*/) override
    {}

  private:
    std::unique_ptr<StrutLookout> lookout;
    std::optional<FirstTouch>     first;
  };
} // namespace auxfem

#endif
