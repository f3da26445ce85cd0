#ifndef auxfem_output_run_folder_h
#define auxfem_output_run_folder_h

#include <auxfem/scene/scene.h>

#include <fstream>
#include <string>

namespace auxfem
{
  /**
   * Makes the folder of a run, removes the results of an earlier run in it
   * (only files with the names a run gives) and writes original.prm, the file
   * as the user gave it, and parameters.prm, all values used. Returns the log,
   * open. Throws InputError that says why the folder cannot be used. To be
   * called on one rank.
   */
  std::ofstream open_run_folder(const Scene &scene, const std::string &folder);

  /**
   * Replaces @p file by @p text in one move, so that a reader finds the old or
   * the new text. Throws ComputationError if it cannot be written.
   */
  void replace_file(const std::string &file, const std::string &text);
} // namespace auxfem

#endif
