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
   * @p text in UTF-8 with `?` in place of control characters, which terminals
   * take for commands, and of bytes that are no UTF-8. Line breaks and tabs
   * stay.
   */
  std::string printable(std::string_view text);

  /**
   * Passes what is written to another buffer on as printable() text. A single
   * carriage return passes, by which a line is written anew.
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

  /** While it lives, all that is written to @p stream is printable. */
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
   * @p json as text, members indented by two blanks. Numbers have as many digits
   * as are needed to read the same ones, null if they are not finite; bytes
   * that are no UTF-8, as file names may have, become U+FFFD.
   */
  std::string json_text(const Json &json);

  /**
   * @p value with @p digits significant digits for messages: without an
   * exponent between 1e-4 and 1e6, where digits before the point are all
   * written, and without the sign of a zero.
   */
  std::string rounded_text(double value, unsigned int digits = 3);

  /** @p part of one in percent, e.g. `12 %`. */
  std::string percentage_text(double part, unsigned int digits = 2);

  /** Items that a message lists before it says how many more there are. */
  inline constexpr std::size_t n_listed = 3;

  /**
   * @p message with lines of at most 800 bytes: of longer ones, in which a user's
   * text is quoted, the beginning and the end.
   */
  std::string with_short_lines(const std::string &message);
} // namespace auxfem

#endif
