#ifndef auxfem_output_output_file_h
#define auxfem_output_output_file_h

#include <fstream>
#include <string>
#include <system_error>

namespace auxfem
{
  /**
   * Opens @p file to be written in @p mode, unless it is a link, a device or a
   * pipe: output never ends up outside of its folder. The stream has failed if
   * that is not possible, and errno says why.
   */
  std::ofstream open_output_file(const std::string &file,
                                 std::ios::openmode mode = std::ios::out);

  /** Makes the folder @p path in an output folder; a link is an error. */
  std::error_code make_output_subfolder(const std::string &path);

  /** Message of an errno; for a link in words that help. */
  std::string output_error_text(int error);
} // namespace auxfem

#endif
