#include <auxfem/parameters/short_lines.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** The first position from @p position on where a character of UTF-8 begins. */
    std::size_t character_from(const std::string &text, std::size_t location)
    {
      while (location < text.size() && (text[location] & 0xC0) == 0x80)
        ++location;
      return location;
    }

    std::string shortened(const std::string &line)
    {
      constexpr std::size_t longest = 800, n_first = 500, n_last = 250;
      if (line.size() <= longest)
        return line;
      return line.substr(0, character_from(line, n_first)) + " [...] " +
        line.substr(character_from(line, line.size() - n_last));
    }
  } // namespace

  std::string with_short_lines(const std::string &message)
  {
    std::string text;
    for (std::size_t begin = 0, end; begin <= message.size(); begin = end + 1)
      {
        end = std::min(message.find('\n', begin), message.size());
        text += (begin == 0 ? "" : "\n") +
          shortened(message.substr(begin, end - begin));
      }
    return text;
  }
} // namespace auxfem
