#include <auxfem/parameters/text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    /**
     * Number of bytes of the UTF-8 character that begins with @p first; 0 if
     * invalid.
     */
    std::size_t length_of_character(const unsigned char first)
    {
      if (first < 0x80)
        return 1;
      if (first < 0xC2 || first > 0xF4)
        return 0;
      return first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    }

    bool is_continuation(const unsigned char byte)
    {
      return (byte & 0xC0) == 0x80;
    }

    /** Length of the first character of @p text; 0 if it is not UTF-8. */
    std::size_t valid_length(const std::string_view text)
    {
      const std::size_t length = length_of_character(text[0]);
      if (length > text.size())
        return 0;
      for (std::size_t i = 1; i < length; ++i)
        if (!is_continuation(text[i]))
          return 0;
      return length;
    }

    bool is_control(const std::string_view character)
    {
      const unsigned char first = character[0];
      if (character.size() == 1)
        return (first < 0x20 && first != '\n' && first != '\t') ||
          first == 0x7F;
      // U+0080 to U+009F are control characters.
      return first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
    }
  } // namespace

  std::string printable(std::string_view text)
  {
    std::string result;
    result.reserve(text.size());
    while (!text.empty())
      {
        const std::size_t      length = valid_length(text);
        const std::string_view character =
          text.substr(0, length == 0 ? 1 : length);
        if (length == 0 || is_control(character))
          result += '?';
        else
          result += character;
        text.remove_prefix(character.size());
      }
    return result;
  }

  PrintableBuffer::int_type PrintableBuffer::overflow(const int_type character)
  {
    if (traits_type::eq_int_type(character, traits_type::eof()))
      return traits_type::not_eof(character);
    const char one = traits_type::to_char_type(character);
    return xsputn(&one, 1) == 1 ? character : traits_type::eof();
  }

  std::streamsize PrintableBuffer::xsputn(const char           *text,
                                          const std::streamsize size)
  {
    const std::string_view piece(text, size);
    const std::string      clean =
      piece == "\r" ? std::string(piece) : printable(piece);
    const std::streamsize n = clean.size();
    return target->sputn(clean.data(), n) == n ? size : 0;
  }

  int PrintableBuffer::sync()
  {
    return target->pubsync();
  }

  std::string json_text(const Json &json)
  {
    return json.dump(/*indent=*/2,
                     /*indent_char=*/' ',
                     /*ensure_ascii=*/false,
                     Json::error_handler_t::replace);
  }

  std::string rounded_text(const double value, const unsigned int digits)
  {
    if (value == 0)
      return "0";
    char         text[64];
    const double size = std::abs(value);
    if (!(size >= 1e-4 && size < 1e6))
      {
        std::snprintf(text, sizeof(text), "%.*g", int(digits), value);
        return text;
      }
    const int after_point =
      std::max(0, int(digits) - 1 - int(std::floor(std::log10(size))));
    std::snprintf(text, sizeof(text), "%.*f", after_point, value);
    std::string result = text;
    if (after_point > 0)
      result.erase(result.find_last_not_of('0') + 1);
    if (result.back() == '.')
      result.pop_back();
    return result;
  }

  std::string number_text(const double value, const int digits)
  {
    // Sign, 17 digits, point and exponent (e-308) need 24 characters.
    char       text[32];
    const auto end = std::to_chars(text,
                                   text + sizeof(text),
                                   value,
                                   std::chars_format::general,
                                   digits)
                       .ptr;
    return {text, end};
  }

  std::string percentage_text(const double part, const unsigned int digits)
  {
    return rounded_text(100 * part, digits) + " %";
  }

  namespace
  {
    /** First position from @p location on where a UTF-8 character begins. */
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
