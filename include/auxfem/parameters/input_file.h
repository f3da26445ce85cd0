#ifndef auxfem_parameters_input_file_h
#define auxfem_parameters_input_file_h

#include <cstddef>
#include <string>

namespace auxfem
{
  /** Reason why a file cannot be read, to follow its name in a message. */
  struct UnreadableFile
  {
    std::string reason;
  };

  /** Largest table or mesh file that is read (bytes), half of a large memory:
   * more is taken for a mistake. */
  constexpr std::size_t largest_input_file = std::size_t(16) << 30;

  /**
   * Content of @p file. Throws UnreadableFile if it is no regular file (a FIFO
   * would block, a device need not end), cannot be opened, or has more than
   * @p most_bytes.
   */
  std::string read_input_file(const std::string &file,
                              std::size_t most_bytes = largest_input_file);
} // namespace auxfem

#endif
