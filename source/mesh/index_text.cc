#include <auxfem/mesh/index_text.h>
#include <auxfem/mesh/lattice.h>

#include <deal.II/base/utilities.h>

#include <charconv>

namespace auxfem
{
  std::optional<unsigned int> read_index(const std::string &text)
  {
    const std::string digits = dealii::Utilities::trim(text);
    const char *const end    = digits.data() + digits.size();
    unsigned int      index  = 0;
    const auto        answer = std::from_chars(digits.data(), end, index);
    if (answer.ec != std::errc() || answer.ptr != end || index == invalid_index)
      return {};
    return index;
  }
} // namespace auxfem
