#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter_file.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <support/messages.h>
#include <sys/stat.h>

namespace
{
  using namespace auxfem;

  std::string message_of(const std::string &text)
  {
    try
      {
        parse_parameter_text(text, "scene.prm");
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  void expect_message(const std::string              &text,
                      const std::vector<std::string> &parts)
  {
    const std::string message = message_of(text);
    for (const std::string &part : parts)
      EXPECT_NE(message.find(part), std::string::npos)
        << "no \"" << part << "\" in: " << message;
  }

  /** Temporary folder with files, removed at the end. */
  class TemporaryFolder
  {
  public:
    TemporaryFolder()
      : path("parameter_file_test_" +
             std::string(
               testing::UnitTest::GetInstance()->current_test_info()->name()))
    {
      std::filesystem::create_directories(path / "inner");
    }

    ~TemporaryFolder()
    {
      std::filesystem::remove_all(path);
    }

    std::string write(const std::string &name, const std::string &text) const
    {
      std::ofstream(path / name) << text;
      return (path / name).string();
    }

  private:
    const std::filesystem::path path;
  };

  TEST(ParameterFile, ReadsSubsectionsEntriesAndLocations)
  {
    const ParameterSubsection root =
      parse_parameter_text("# comment\n"
                           "set Title = a = b # rest\n"
                           "\n"
                           "subsection  Outer\n"
                           "  subsection  two   words\n"
                           "    set  Key   word=  1 mm  \n"
                           "  end\n"
                           "end\n"
                           "subsection Outer\n"
                           "  set Empty =\n"
                           "end # comment\n",
                           "scene.prm");
    ASSERT_NE(root.find_entry("Title"), nullptr);
    EXPECT_EQ(root.find_entry("Title")->value, "a = b");
    EXPECT_EQ(root.find_entry("Title")->location.text(), "scene.prm:2");
    ASSERT_EQ(root.subsections.size(), 1u);
    const ParameterSubsection &outer = root.subsections[0];
    EXPECT_EQ(outer.location.text(), "scene.prm:4");
    ASSERT_NE(outer.find_entry("Empty"), nullptr);
    EXPECT_EQ(outer.find_entry("Empty")->value, "");
    ASSERT_NE(outer.find_subsection("two words"), nullptr);
    const ParameterEntry *entry =
      outer.find_subsection("two words")->find_entry("Key word");
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(entry->value, "1 mm");
    EXPECT_EQ(entry->location.line, 6u);
    EXPECT_EQ(root.find_subsection("Inner"), nullptr);
  }



  TEST(ParameterFile, JoinsContinuedLines)
  {
    const ParameterSubsection root = parse_parameter_text("set A = 1, \\\n"
                                                          "# between\n"
                                                          "   2, \\   # after\n"
                                                          "3\n"
                                                          "set B = 4\n",
                                                          "scene.prm");
    EXPECT_EQ(root.find_entry("A")->value, "1, 2, 3");
    EXPECT_EQ(root.find_entry("B")->location.line, 5u);
  }



  TEST(ParameterFile, RefusesInvalidLines)
  {
    expect_message(
      "set A = 1\nsett B = 2\n",
      {"scene.prm:2", "line not understood", "sett B = 2", "set NAME = VALUE"});
    expect_message("set A 1\n", {"scene.prm:1", "set A 1"});
    expect_message("set = 1\n", {"scene.prm:1", "line not understood"});
    expect_message("subsection\nend\n", {"scene.prm:1", "scene.prm:2"});
    expect_message("set A = 1 \\\n", {"scene.prm:1", "continued"});
  }



  TEST(ParameterFile, RefusesUnbalancedEnds)
  {
    expect_message("subsection A\nsubsection B\nend\n",
                   {"scene.prm:1", "\"A\"", "not closed"});
    expect_message("subsection A\nend\nend\n",
                   {"scene.prm:3", "without a subsection"});
  }



  TEST(ParameterFile, RefusesDuplicatesNamingBothLines)
  {
    expect_message("subsection A\n set B = 1\nend\n"
                   "subsection A\n set B = 2\nend\n",
                   {"scene.prm:5", "A/B", "scene.prm:2", "\"1\"", "\"2\""});
  }



  TEST(ParameterFile, RefusesTwoGroupsOfOneNameNamingBothLines)
  {
    expect_message("subsection Supports\n subsection ground\n  set A = 1\n"
                   " end\n subsection ground\n  set B = 2\n end\nend\n",
                   {"scene.prm:5",
                    "Supports/ground",
                    "second time",
                    "scene.prm:2",
                    "another name"});
    expect_message("subsection Loads\n subsection a\n end\nend\n"
                   "subsection Loads\n subsection a\n end\nend\n",
                   {"scene.prm:6", "Loads/a", "scene.prm:2"});
  }



  TEST(ParameterFile, ReportsAllMistakesAtOnce)
  {
    expect_message("what\nset A = 1\nset A = 2\nend\n",
                   {"3 mistakes", "scene.prm:1", "scene.prm:3", "scene.prm:4"});
  }



  TEST(ParameterFile, IncludesFilesFromTheIncludingFilesFolder)
  {
    const TemporaryFolder folder;
    folder.write("inner/last.prm", "set C = 3\n");
    folder.write("inner/part.prm", "set B = 2\ninclude last.prm\n");
    const std::string main =
      folder.write("main.prm", "subsection S\ninclude inner/part.prm\nend\n");

    const ParameterSubsection  root = read_parameter_file(main);
    const ParameterSubsection *s    = root.find_subsection("S");
    ASSERT_NE(s, nullptr);
    ASSERT_NE(s->find_entry("B"), nullptr);
    ASSERT_NE(s->find_entry("C"), nullptr);
    EXPECT_NE(s->find_entry("C")->location.text().find("inner/last.prm:1"),
              std::string::npos);
  }



  TEST(ParameterFile, AddsToGroupsOfAnIncludedFile)
  {
    const TemporaryFolder folder;
    folder.write("part.prm",
                 "subsection S\nsubsection a\nset A = 1\nend\nend\n");
    const ParameterSubsection root = read_parameter_file(
      folder.write("main.prm",
                   "include part.prm\n"
                   "subsection S\nsubsection a\nset B = 2\nend\nend\n"));
    const ParameterSubsection &a = root.subsections.at(0).subsections.at(0);
    EXPECT_NE(a.find_entry("A"), nullptr);
    EXPECT_NE(a.find_entry("B"), nullptr);
  }



  TEST(ParameterFile, RefusesIncludesThatCannotWork)
  {
    const TemporaryFolder folder;
    const std::string     loop = folder.write("loop.prm", "include loop.prm\n");
    const std::string     open =
      folder.write("open.prm", "subsection A\ninclude end.prm\n");
    folder.write("end.prm", "end\n");
    const std::string missing =
      folder.write("missing.prm", "include nowhere.prm\n");
    for (const std::string &file : {loop, open, missing})
      EXPECT_THROW(read_parameter_file(file), InputError) << file;
  }



  TEST(ParameterFile, NamesAFileThatCannotBeOpened)
  {
    const TemporaryFolder folder;
    for (const std::string &file : {std::string("nowhere.prm"),
                                    folder.write("x.prm", "") + "/y.prm",
                                    std::string(".")})
      try
        {
          read_parameter_file(file);
          FAIL() << file;
        }
      catch (const InputError &error)
        {
          EXPECT_NE(std::string(error.what()).find("\"" + file + "\""),
                    std::string::npos)
            << error.what();
        }
  }



  TEST(ParameterFile, LimitsFilesThatIncludeEachOther)
  {
    const TemporaryFolder folder;
    for (unsigned int i = 0; i < 30; ++i)
      {
        const std::string next = "include " + std::to_string(i + 1) + ".prm\n";
        folder.write(std::to_string(i) + ".prm", next + next);
      }
    folder.write("30.prm", "");
    const std::string main = folder.write("main.prm", "include 0.prm\n");
    const std::string message =
      input_error_of([&]() { read_parameter_file(main); });
    EXPECT_TRUE(contains(message, "more than 1000 files")) << message;
  }



  TEST(ParameterFile, RefusesPipesAndDevices)
  {
    const TemporaryFolder folder;
    const std::string     pipe = folder.write("pipe.prm", "");
    std::filesystem::remove(pipe);
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const std::string &file : {pipe, std::string("/dev/zero")})
      {
        const std::string message =
          input_error_of([&]() { read_parameter_file(file); });
        EXPECT_TRUE(contains(message, "pipe, socket or device")) << message;
      }
  }



  TEST(ParameterFile, OverridesReplaceAndAdd)
  {
    ParameterSubsection root =
      parse_parameter_text("subsection A\n set B = 1\nend\n", "scene.prm");
    apply_override(root, "A/B=2");
    apply_override(root, "A/New group/C d = x = y");
    apply_override(root, "Title=");
    const ParameterSubsection *a = root.find_subsection("A");
    EXPECT_EQ(a->entries.size(), 1u);
    EXPECT_EQ(a->find_entry("B")->value, "2");
    EXPECT_EQ(a->find_entry("B")->location.text(), "command line");
    EXPECT_EQ(a->find_subsection("New group")->find_entry("C d")->value,
              "x = y");
    EXPECT_EQ(root.find_entry("Title")->value, "");
  }



  TEST(ParameterFile, RefusesOverridesOfAnotherForm)
  {
    ParameterSubsection root = parse_parameter_text("", "scene.prm");
    for (const char *text : {"A/B", "=3", "A/=3", "/B=3", "A//B=3", "A=1#2"})
      EXPECT_THROW(apply_override(root, text), InputError) << text;
  }
} // namespace
