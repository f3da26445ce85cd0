#ifndef auxfem_study_recommendation_h
#define auxfem_study_recommendation_h

#include <auxfem/study/settings.h>

#include <functional>
#include <optional>
#include <string>

namespace auxfem
{
  /** Settings that a study recommends for an error. */
  struct Recommendation
  {
    Settings settings;
    /** What the user should know of them, in brackets after them. */
    std::string remark;
  };

  /** The cheapest for a relative error of at most @p target, if there is one. */
  using Recommend = std::function<std::optional<Recommendation>(double target)>;

  /**
   * Lines of what @p recommend says for errors from 10 % down to a ten-thousandth
   * of a percent, ready for the command line; each recommendation with the
   * smallest error that it serves for.
   */
  std::string recommendations_text(const Scene     &scene,
                                   const Recommend &recommend);
} // namespace auxfem

#endif
