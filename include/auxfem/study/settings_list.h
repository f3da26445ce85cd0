#ifndef auxfem_study_settings_list_h
#define auxfem_study_settings_list_h

#include <auxfem/study/settings.h>
#include <auxfem/study/study_runs.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** The different settings that a study computes a scene with, each once. */
  class SettingsList
  {
  public:
    /**
     * Does nothing with those that are in the list.
     * @param repetitions how often they are computed, for their time.
     */
    void add(const std::vector<Settings> &settings, unsigned int repetitions);

    /** The simulations of @p scene with them. Throws InputError if one is wrong,
     * or has another limit than the scene. */
    std::vector<PlannedRun> planned_runs(const Scene &scene) const;

    /** Those of @p runs, the results of planned_runs(), that were done with
     * @p settings, which must be in the list. */
    std::vector<MeasuredRun> of(const std::vector<Settings>    &settings,
                                const std::vector<MeasuredRun> &runs) const;

  private:
    std::size_t index(const Settings &settings) const;

    std::vector<Settings>     list;
    std::vector<unsigned int> repetitions;
  };

  /** E.g. `order 2, 4 elements a strut, newmark, step 2e-05 s`. */
  std::string name_of_run(const Scene &scene, const Settings &settings);
} // namespace auxfem

#endif
