#ifndef auxfem_tests_support_run_program_h
#define auxfem_tests_support_run_program_h

#include <auxfem/program.h>

#include <gtest/gtest.h>
#include <support/text_file.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace auxfem
{
  namespace testing_support
  {
    using Words = std::vector<std::string>;

    /** The file @p name of tests/data, as text. */
    inline std::string data_text(const std::string &name)
    {
      return read_text(std::string(AUXFEM_TEST_DATA_DIRECTORY) + "/" + name);
    }

    /** The shipped scene @p name of prm/, as text. */
    inline std::string prm_text(const std::string &name)
    {
      return read_text(std::string(AUXFEM_PRM_DIRECTORY) + "/" + name);
    }

    /** @p text with its only @p from replaced by @p to. */
    inline std::string
    replaced(std::string text, const std::string &from, const std::string &to)
    {
      const std::size_t position = text.find(from);
      if (position == std::string::npos ||
          text.find(from, position + 1) != std::string::npos)
        throw std::runtime_error("Not exactly one \"" + from + "\" to replace");
      return text.replace(position, from.size(), to);
    }

    inline unsigned int count_lines(const std::string &text)
    {
      return std::count(text.begin(), text.end(), '\n');
    }

    /** Output and exit code of a program. */
    struct ProgramRun
    {
      int         exit_code; ///< -1: ended by a signal
      std::string output;    ///< on its standard output
      std::string errors;    ///< on its standard error
    };

    /** A table with a header, as history.csv: columns by name. */
    struct Table
    {
      explicit Table(const std::string &file)
      {
        std::ifstream stream(file);
        std::string   line;
        std::getline(stream, line);
        names = split(line);
        while (std::getline(stream, line))
          {
            const Words cells = split(line);
            if (cells.size() != names.size())
              throw std::runtime_error(file + " has the ragged row " + line);
            for (unsigned int i = 0; i < cells.size(); ++i)
              columns[names[i]].push_back(number_in(cells[i]));
            ++n_rows;
          }
      }

      const std::vector<double> &operator[](const std::string &name) const
      {
        const auto column = columns.find(name);
        if (column == columns.end())
          throw std::runtime_error("There is no column " + name);
        return column->second;
      }

      double largest(const std::string &name) const
      {
        double size = 0;
        for (const double value : (*this)[name])
          size = std::max(size, std::abs(value));
        return size;
      }

      Words                                      names;
      std::map<std::string, std::vector<double>> columns;
      unsigned int                               n_rows = 0;

    private:
      /** Not a number for texts. */
      static double number_in(const std::string &cell)
      {
        char        *end   = nullptr;
        const double value = std::strtod(cell.c_str(), &end);
        return end != cell.c_str() && *end == 0 ? value : std::nan("");
      }

      static Words split(const std::string &line)
      {
        Words             cells;
        std::stringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');)
          cells.push_back(cell);
        return cells;
      }
    };

    /**
     * The value of @p key in JSON @p text: the first one, whatever its depth;
     * strings without quotes and as they are escaped.
     */
    inline std::string json_value(const std::string &text,
                                  const std::string &key)
    {
      const std::regex pattern(
        "\"" + key + "\": *(?:\"((?:[^\"\\\\]|\\\\.)*)\"|([^,\\s]+))");
      std::smatch match;
      if (!std::regex_search(text, match, pattern))
        throw std::runtime_error("There is no " + key + " in " + text);
      return match[1].matched ? match[1] : match[2];
    }

    /** Redirects a file descriptor to a file for its lifetime. */
    class Redirection
    {
    public:
      Redirection(const int descriptor, const std::string &file)
        : descriptor(descriptor)
      {
        flush();
        former           = dup(descriptor);
        const int target = creat(file.c_str(), 0666);
        if (former < 0 || target < 0 || dup2(target, descriptor) < 0)
          throw std::runtime_error("Cannot write " + file);
        close(target);
      }

      Redirection(const Redirection &)            = delete;
      Redirection &operator=(const Redirection &) = delete;

      ~Redirection()
      {
        flush();
        dup2(former, descriptor);
        close(former);
      }

    private:
      static void flush()
      {
        std::cout.flush();
        std::cerr.flush();
        std::fflush(nullptr);
      }

      const int descriptor;
      int       former;
    };

    /**
     * For tests that start programs: a fresh folder for each test, below
     * AUXFEM_TEST_OUTPUT_DIRECTORY.
     */
    class ProgramTest : public testing::Test
    {
    protected:
      /** @param suffix of the folder, which tells those of ranks apart */
      explicit ProgramTest(const std::string &suffix = "")
      {
        const testing::TestInfo &test =
          *testing::UnitTest::GetInstance()->current_test_info();
        folder = std::string(AUXFEM_TEST_OUTPUT_DIRECTORY) + "/" +
          test.test_suite_name() + "." + test.name() + suffix;
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
      }

      /** The path of @p name in the test's folder. */
      std::string path(const std::string &name) const
      {
        return folder + "/" + name;
      }

      /** Writes @p text to the file @p name in the test's folder: its path. */
      std::string write(const std::string &name, const std::string &text) const
      {
        write_text(path(name), text);
        return path(name);
      }

      /** Runs a program, whose words need no quotes, in the test's folder. */
      ProgramRun run_program(const Words &words) const
      {
        // Ranks that wait for each other shall fail the test, not hang it.
        return run_in_shell("timeout 300" + quoted(words));
      }

      /** Lets the program run inside the test, in its folder: starting it takes
       * longer than most scenes. */
      ProgramRun run_auxfem(const Words &arguments) const
      {
        const auto        before = std::filesystem::current_path();
        const std::string output = path("stdout.txt");
        const std::string errors = path("stderr.txt");
        int               exit_code;
        {
          const Redirection redirected_output(STDOUT_FILENO, output);
          const Redirection redirected_errors(STDERR_FILENO, errors);
          std::filesystem::current_path(folder);
          exit_code = auxfem::run_program(arguments, {});
          std::filesystem::current_path(before);
        }
        return {exit_code, read_text(output), read_text(errors)};
      }

      /** run_auxfem() of prm/@p file into the folder `out`, unless @p overrides
       * say otherwise. */
      ProgramRun run_shipped(const std::string &file,
                             const Words       &overrides) const
      {
        Words arguments = {std::string(AUXFEM_PRM_DIRECTORY) + "/" + file,
                           "--set",
                           "Output/Directory=out"};
        for (const std::string &text : overrides)
          {
            arguments.push_back("--set");
            arguments.push_back(text);
          }
        return run_auxfem(arguments);
      }

      /** The same as a process of its own, as users start it. */
      ProgramRun start_auxfem(const Words &arguments) const
      {
        Words words = {AUXFEM_EXECUTABLE};
        words.insert(words.end(), arguments.begin(), arguments.end());
        return run_program(words);
      }

      ProgramRun run_auxfem_on(const unsigned int n_ranks,
                               const Words       &arguments) const
      {
        return run_in_shell("timeout 300 " AUXFEM_MPIRUN " -n " +
                            std::to_string(n_ranks) +
                            quoted({AUXFEM_EXECUTABLE}) + quoted(arguments));
      }

      Table history(const std::string &output = "out") const
      {
        return Table(path(output) + "/history.csv");
      }

      std::string summary(const std::string &key,
                          const std::string &output = "out") const
      {
        return json_value(read_text(path(output) + "/summary.json"), key);
      }

      std::string folder;

    private:
      static std::string quoted(const Words &words)
      {
        std::string text;
        for (const std::string &word : words)
          text +=
            " '" + std::regex_replace(word, std::regex("'"), "'\\''") + "'";
        return text;
      }

      ProgramRun run_in_shell(const std::string &command) const
      {
        const std::string output = path("stdout.txt");
        const std::string errors = path("stderr.txt");
        const int         status = std::system(
          ("cd" + quoted({folder}) + " && " + command + " </dev/null >" +
           quoted({output}) + " 2>" + quoted({errors}))
            .c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
                read_text(output),
                read_text(errors)};
      }
    };

    inline void expect_contains(const std::string &text, const Words &parts)
    {
      for (const std::string &part : parts)
        EXPECT_TRUE(text.find(part) != std::string::npos)
          << "no \"" << part << "\" in:\n"
          << text;
    }

    inline void expect_without(const std::string &text, const Words &parts)
    {
      for (const std::string &part : parts)
        EXPECT_TRUE(text.find(part) == std::string::npos)
          << "\"" << part << "\" in:\n"
          << text;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
