#ifndef auxfem_parameters_short_lines_h
#define auxfem_parameters_short_lines_h

#include <string>

namespace auxfem
{
  /**
   * @p message with lines of at most 800 bytes: of longer ones, in which a user's
   * text is quoted, the beginning and the end.
   */
  std::string with_short_lines(const std::string &message);
} // namespace auxfem

#endif
