#ifndef auxfem_resumption_h
#define auxfem_resumption_h

#include <auxfem/output/run_checkpoints.h>
#include <auxfem/scene/scene.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * The scene of @p run, with @p overrides (`Subsection/Parameter=value`). Throws
   * InputError, with names, if these change what the results until now depend
   * on, if a file has changed that the scene is read from, and if the run has
   * got to its end time.
   */
  Scene scene_to_resume(const RunToResume              &run,
                        const std::vector<std::string> &overrides);
} // namespace auxfem

#endif
