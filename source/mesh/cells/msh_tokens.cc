#include <auxfem/mesh/cells/msh_tokens.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace auxfem
{
  namespace
  {
    bool is_blank(const char c)
    {
      return c == ' ' || c == '\n' || c == '\t' || c == '\r';
    }
  } // namespace

  void MshTokens::skip_blanks()
  {
    for (; position < content.size() && is_blank(content[position]); ++position)
      line += content[position] == '\n';
  }

  std::string MshTokens::next()
  {
    skip_blanks();
    const std::size_t begin = position;
    while (position < content.size() && !is_blank(content[position]))
      ++position;
    return content.substr(begin, position - begin);
  }

  void MshTokens::skip_line()
  {
    const std::size_t end = content.find('\n', position);
    line += end != std::string::npos;
    position = end == std::string::npos ? content.size() : end + 1;
  }

  bool MshTokens::skip_to_end_of(const std::string &text)
  {
    const std::size_t begin = content.find(text, position);
    if (begin == std::string::npos)
      return false;
    line +=
      std::count(content.begin() + position, content.begin() + begin, '\n');
    position = begin + text.size();
    return true;
  }

  std::string MshTokens::quoted()
  {
    skip_blanks();
    if (position == content.size() || content[position] != '"')
      fail("a name in double quotes is expected");
    const std::size_t begin = position + 1,
                      end   = content.find_first_of("\"\n", begin);
    if (end == std::string::npos || content[end] == '\n')
      fail("a name has no closing double quote");
    position = end + 1;
    return content.substr(begin, end - begin);
  }

  long long MshTokens::integer(const std::string &noun)
  {
    return is_binary ? bytes<std::int32_t>(noun)
                     : number<long long>(noun, "a whole number");
  }

  long long MshTokens::long_integer(const std::string &noun)
  {
    return is_binary ? bytes<std::int64_t>(noun) : integer(noun);
  }

  long long MshTokens::count(const std::string &noun)
  {
    return checked_count(integer(noun), noun);
  }

  long long MshTokens::long_count(const std::string &noun)
  {
    return checked_count(long_integer(noun), noun);
  }

  double MshTokens::real(const std::string &noun)
  {
    const double value =
      is_binary ? bytes<double>(noun) : number<double>(noun, "a number");
    if (!std::isfinite(value))
      fail("the " + noun + " is not finite");
    return value;
  }

  void MshTokens::fail(const std::string &problem) const
  {
    throw MeshMistake{(is_binary ? "byte " + std::to_string(position)
                                 : "line " + std::to_string(line)) +
                      ": " + problem};
  }

  long long MshTokens::checked_count(const long long    n,
                                     const std::string &noun) const
  {
    if (n < 0 || n > static_cast<long long>(content.size()))
      fail("the " + noun + " is " + std::to_string(n) +
           ", and a file of this size cannot hold so many");
    return n;
  }

  template <class Number>
  Number MshTokens::bytes(const std::string &noun)
  {
    Number value;
    if (content.size() - position < sizeof(value))
      fail("the file ends where the " + noun + " is expected");
    std::memcpy(&value, content.data() + position, sizeof(value));
    position += sizeof(value);
    return value;
  }

  template <class Number>
  Number MshTokens::number(const std::string &noun, const std::string &kind)
  {
    constexpr std::size_t n_shown = 30;
    const std::string     word    = next();
    Number                value{};
    const char *const     begin =
      word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
    const char *const end    = word.data() + word.size();
    const auto        answer = std::from_chars(begin, end, value);
    if (word.empty())
      fail("the file ends where the " + noun + " is expected");
    if (answer.ec != std::errc() || answer.ptr != end)
      fail("'" + word.substr(0, n_shown) + "' is found where the " + noun +
           ", " + kind + ", is expected");
    return value;
  }
} // namespace auxfem
