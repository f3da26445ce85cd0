#ifndef auxfem_output_run_report_h
#define auxfem_output_run_report_h

#include <auxfem/equations/equations.h>
#include <auxfem/output/console.h>
#include <auxfem/output/run_folder.h>
#include <auxfem/output/verdict.h>

#include <optional>

namespace auxfem
{
  /**
   * Folder, log and screen of a run that tells no Recorder, as its questions
   * have no course in time.
   */
  class RunReport
  {
  public:
    /** Makes the folder and prints the overview. @p scene must outlive the
     * object. Throws as RunFolder. Collective. */
    RunReport(const Scene          &scene,
              const Equations      &equations,
              const FileRules      &rules,
              const FolderContents &further);

    /** @name On the first rank. */
    ///@{
    void print(const std::string &text);
    void claim_series(const std::vector<std::string> &names);

    /** Writes summary.json with @p found, prints where results are, and the
     * verdict. */
    void finish(const Json &found, const std::vector<Finding> &findings);
    ///@}

  private:
    const Scene                   &scene;
    const std::vector<std::string> notes;
    std::optional<RunFolder>       files;   ///< on rank 0
    std::optional<Console>         console; ///< on rank 0
  };
} // namespace auxfem

#endif
