#include "mutator.h"

#include <array>
#include <sstream>
#include <vector>

namespace auxfem
{
  namespace
  {
    /** Words that have been the end of programs. */
    const std::array<const char *, 28> words = {
      {"",          "0",          "-1",    "1",        "2",
       "7",         "1e30",       "1e400", "-1e-320",  "nan",
       "inf",       "-inf",       "0/0",   "99999999", "4294967296",
       "-99999999", "1000000000", "0.5",   "all",      "t",
       "set",       "end",        "=",     "#",        "subsection",
       "\xff\xfe",  "\"",         "(1"}};

    /** Begin and size of the words of a text. */
    std::vector<std::pair<std::size_t, std::size_t>>
    words_of(const std::string &text)
    {
      const std::string                                blanks = " \t\r\n,;=";
      std::vector<std::pair<std::size_t, std::size_t>> positions;
      for (std::size_t begin = text.find_first_not_of(blanks);
           begin != std::string::npos;)
        {
          const std::size_t end =
            std::min(text.find_first_of(blanks, begin), text.size());
          positions.emplace_back(begin, end - begin);
          begin = text.find_first_not_of(blanks, end);
        }
      return positions;
    }

    std::vector<std::string> lines_of(const std::string &text)
    {
      std::istringstream       stream(text);
      std::vector<std::string> lines;
      for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
      return lines;
    }
  } // namespace

  Mutator::Mutator(const unsigned int seed) : generator(seed)
  {}

  std::size_t Mutator::below(const std::size_t n)
  {
    // Distributions of the library differ from one to another.
    return generator() % n;
  }

  std::string Mutator::mutated(std::string text)
  {
    for (std::size_t n = 1 + below(3); n > 0; --n)
      text = change(text);
    return text;
  }

  std::string Mutator::change(const std::string &text)
  {
    if (text.empty())
      return "x";
    switch (below(8))
      {
        case 0:
        case 1:
          return change_line(text);
        case 2:
          return change_byte(text);
        case 3:
          return below(4) == 0 ? text.substr(0, below(text.size()))
                               : change_word(text);
        default:
          return change_word(text);
      }
  }

  std::string Mutator::change_word(const std::string &text)
  {
    const auto positions = words_of(text);
    if (positions.empty())
      return text + "x";
    const auto [begin, size] = positions[below(positions.size())];
    std::string word         = text.substr(begin, size);
    switch (below(4))
      {
        case 0:
          {
            const auto other = positions[below(positions.size())];
            word             = text.substr(other.first, other.second);
            break;
          }
        case 1:
          word += word;
          break;
        default:
          word = words[below(words.size())];
      }
    return text.substr(0, begin) + word + text.substr(begin + size);
  }

  std::string Mutator::change_line(const std::string &text)
  {
    std::vector<std::string> lines = lines_of(text);
    const std::size_t        line  = below(lines.size());
    const std::size_t        other = below(lines.size());
    switch (below(4))
      {
        case 0:
          lines.erase(lines.begin() + line);
          break;
        case 1:
          lines.insert(lines.begin() + other, std::string(lines[line]));
          break;
        case 2:
          std::swap(lines[line], lines[other]);
          break;
        default:
          lines[line] += std::string(5000, 'y');
      }
    std::string result;
    for (const std::string &kept : lines)
      result += kept + '\n';
    return result;
  }

  std::string Mutator::change_byte(std::string text)
  {
    const std::size_t position = below(text.size());
    switch (below(3))
      {
        case 0:
          text.erase(position, 1);
          break;
        case 1:
          text.insert(position, 1, char(below(256)));
          break;
        default:
          text[position] = char(below(256));
      }
    return text;
  }
} // namespace auxfem
