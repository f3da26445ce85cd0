#ifndef auxfem_parameters_text_h
#define auxfem_parameters_text_h

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <iostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace auxfem
{
  /**
   * @p text in UTF-8 with `?` in place of invalid bytes and of control
   *   characters, which a terminal would execute. Line breaks and tabs stay.
   */
  std::string printable(std::string_view text);

  /**
   * Stream buffer that passes text on as printable() text. A single carriage
   * return, which rewrites a line, passes unchanged.
   */
  class PrintableBuffer : public std::streambuf
  {
  public:
    explicit PrintableBuffer(std::streambuf *target) : target(target)
    {}

  protected:
    int_type        overflow(int_type character) override;
    std::streamsize xsputn(const char *text, std::streamsize size) override;
    int             sync() override;

  private:
    std::streambuf *const target;
  };

  /** Makes all output to @p stream printable during its lifetime. */
  class PrintableStream
  {
  public:
    explicit PrintableStream(std::ostream &stream)
      : stream(stream)
      , raw(stream.rdbuf())
      , buffer(raw)
    {
      stream.rdbuf(&buffer);
    }

    ~PrintableStream()
    {
      stream.rdbuf(raw);
    }

    PrintableStream(const PrintableStream &)            = delete;
    PrintableStream &operator=(const PrintableStream &) = delete;

  private:
    std::ostream         &stream;
    std::streambuf *const raw;
    PrintableBuffer       buffer;
  };

  /** Members keep the order in which they are added. */
  using Json = nlohmann::ordered_json;

  /**
   * @p json as text, indented by two blanks. Numbers are written exactly,
   *   non-finite ones as null; invalid UTF-8 bytes become U+FFFD.
   */
  std::string json_text(const Json &json);

  /**
   * @p value with @p digits significant digits for messages. Between 1e-4 and
   *   1e6 there is no exponent and all digits before the point are written;
   *   zero has no sign.
   */
  std::string rounded_text(double value, unsigned int digits = 3);

  /**
   * @p value with at most @p digits significant digits, without trailing zeros.
   *   Twelve digits hide round-off, such as that of 20 us halved.
   */
  std::string number_text(double value, int digits = 12);

  /** @p part in percent, e.g. `12 %`. */
  std::string percentage_text(double part, unsigned int digits = 2);

  /** Number of items that a message lists before it gives a count. */
  inline constexpr std::size_t max_listed_items = 3;

  /**
   * @p message with lines of at most 800 bytes; longer lines, which quote a
   *   user's text, keep their beginning and end.
   */
  std::string with_short_lines(const std::string &message);
} // namespace auxfem

#endif
