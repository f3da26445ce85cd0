#ifndef auxfem_parameters_printable_h
#define auxfem_parameters_printable_h

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
} // namespace auxfem

#endif
