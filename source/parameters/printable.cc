#include <auxfem/parameters/printable.h>

namespace auxfem
{
  namespace
  {
    /** Number of bytes of the character of UTF-8 that begins with @p first; 0
     * for none. */
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

    /** Length of the character at the begin of @p text; 0 if it is no UTF-8. */
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
      // U+0080 to U+009F.
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
} // namespace auxfem
