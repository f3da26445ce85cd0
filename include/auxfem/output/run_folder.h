#ifndef auxfem_output_run_folder_h
#define auxfem_output_run_folder_h

#include <auxfem/output/output_folder.h>
#include <auxfem/parameters/printable.h>
#include <auxfem/scene/scene.h>

#include <fstream>
#include <string>

namespace auxfem
{
  /** @p rules that spare all files @p scene was read from, too. */
  FileRules with_inputs_of(const Scene &scene, FileRules rules);

  /**
   * The folder of a run, with original.prm, the file as the user gave it,
   * parameters.prm, all values used, and the log. To be used on one rank.
   */
  class RunFolder
  {
  public:
    /**
     * Makes the folder that @p scene names, whose files are spared, and removes
     * the results of an earlier run in it, unless they are continued: then the
     * log is. Throws InputError that says why the folder cannot be used, see
     * OutputFolder.
     * @param further that the run writes, besides those of a simulation.
     */
    RunFolder(const Scene          &scene,
              const FileRules      &rules,
              const FolderContents &further        = {},
              FormerResults         former_results = FormerResults::removed);

    /** Notes that the run writes the series @p name. */
    void claim_series(const std::string &name);

    /** log.txt, which is read on terminals. */
    std::ostream &log()
    {
      return log_stream;
    }

  private:
    void write(const std::string &name, const std::string &text) const;

    OutputFolder      folder;
    const std::string path;
    std::ofstream     log_file;
    PrintableBuffer   log_buffer{log_file.rdbuf()};
    std::ostream      log_stream{&log_buffer};
  };

  /**
   * Replaces @p file by @p text in one move, so that a reader finds the old or
   * the new text. Throws ComputationError if it cannot be written.
   */
  void replace_file(const std::string &file, const std::string &text);
} // namespace auxfem

#endif
