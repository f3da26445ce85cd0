#ifndef auxfem_mesh_index_text_h
#define auxfem_mesh_index_text_h

#include <optional>
#include <string>

namespace auxfem
{
  /**
   * The joint or strut number @p text stands for: digits only, blanks around
   * them allowed; nothing for any other text and for numbers too large to be
   * an index.
   */
  std::optional<unsigned int> read_index(const std::string &text);
} // namespace auxfem

#endif
