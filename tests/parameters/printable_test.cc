#include <auxfem/parameters/text.h>

#include <gtest/gtest.h>

#include <sstream>

using namespace auxfem;

TEST(Printable, Utf8TextIsUnchanged)
{
  const std::string text = "E = 210 GPa\n\t\u00b5m \u00fcber \U0001f600";
  EXPECT_EQ(printable(text), text);
}

TEST(Printable, ControlCharactersAreReplaced)
{
  EXPECT_EQ(printable("\x1b[31mred\x07\x7f\r"), "?[31mred???");
  EXPECT_EQ(printable(std::string(1, '\0')), "?");
  // CSI as a single byte and in UTF-8; a truncated character.
  EXPECT_EQ(printable("\x9b"
                      "2J"),
            "?2J");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "?2J");
  EXPECT_EQ(printable("\xe2\x82"), "??");
}

TEST(Printable, StreamsWritePrintableTextOnly)
{
  std::ostringstream stream;
  {
    const PrintableStream clean(stream);
    stream << "title \x1b]0;x\x07" << std::endl << '\r' << "a\rb" << '\x1b';
  }
  EXPECT_EQ(stream.str(), "title ?]0;x?\n\ra?b?");
  stream << '\x1b';
  EXPECT_EQ(stream.str().back(), '\x1b');
}
