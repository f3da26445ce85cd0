#ifndef auxfem_parameters_short_lines_h
#define auxfem_parameters_short_lines_h

#include <cstddef>
#include <string>

namespace auxfem
{
  /** Items that a message lists before it says how many more there are. */
  inline constexpr std::size_t n_listed = 3;

  /**
   * @p message with lines of at most 800 bytes: of longer ones, in which a user's
   * text is quoted, the beginning and the end.
   */
  std::string with_short_lines(const std::string &message);
} // namespace auxfem

#endif
