#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter_file.h>
#include <auxfem/parameters/registry.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace auxfem
{
  namespace
  {
    [[noreturn]] void fail(const std::string &action, const int error)
    {
      throw UnreadableFile{"cannot be " + action + " (" +
                           std::generic_category().message(error) + ")"};
    }

    /** File descriptor for reading, closed by the destructor. */
    class InputDescriptor
    {
    public:
      explicit InputDescriptor(const std::string &file)
        // O_NONBLOCK: opening a FIFO would block until a process writes.
        : number(
            ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC))
      {
        if (number < 0)
          fail("opened", errno);
      }

      ~InputDescriptor()
      {
        close(number);
      }

      InputDescriptor(const InputDescriptor &)            = delete;
      InputDescriptor &operator=(const InputDescriptor &) = delete;

      void require_regular_file() const
      {
        struct stat status = {};
        if (fstat(number, &status) != 0)
          fail("read", errno);
        if (S_ISDIR(status.st_mode))
          fail("opened", EISDIR);
        if (!S_ISREG(status.st_mode))
          throw UnreadableFile{
            "cannot be opened (it is a pipe, socket or device)"};
      }

      std::size_t read_some(char *const buffer, const std::size_t size) const
      {
        ssize_t n = -1;
        do
          n = read(number, buffer, size);
        while (n < 0 && errno == EINTR);
        if (n < 0)
          fail("read", errno);
        return n;
      }

    private:
      const int number;
    };
  } // namespace

  std::string read_input_file(const std::string &file,
                              const std::size_t  most_bytes)
  {
    const InputDescriptor input(file);
    input.require_regular_file();
    std::string             content;
    std::array<char, 65536> buffer;
    while (const std::size_t n = input.read_some(buffer.data(), buffer.size()))
      {
        // The file size reported by the system may be wrong.
        if (content.size() + n > most_bytes)
          throw UnreadableFile{"has more than " + std::to_string(most_bytes) +
                               " bytes"};
        content.append(buffer.data(), n);
      }
    return content;
  }

  namespace
  {
    using dealii::Utilities::trim;

    /**
     * Limits that stop files which include each other. A frame of a million
     * joints takes 100 MB.
     */
    constexpr unsigned int max_files  = 1000;
    constexpr std::size_t  most_bytes = std::size_t(1) << 30;

    std::string directory_of(const std::string &file)
    {
      const std::size_t slash = file.rfind('/');
      return slash == std::string::npos ? "" : file.substr(0, slash + 1);
    }

    /** Splits `subsection a b` into `subsection` and `a b`. */
    std::pair<std::string, std::string> first_word(const std::string &line)
    {
      const std::size_t end = line.find_first_of(" \t");
      return end == std::string::npos
        ? std::make_pair(line, std::string())
        : std::make_pair(line.substr(0, end), trim(line.substr(end)));
    }

    /** Joins words by single blanks; the spacing of names is free. */
    std::string single_blanks(const std::string &text)
    {
      std::istringstream words(text);
      std::string        result, word;
      while (words >> word)
        result += (result.empty() ? "" : " ") + word;
      return result;
    }

    /** Parses lines into the tree; continues after a mistake to report all. */
    class Scanner
    {
    public:
      void read_file(const std::string &file)
      {
        const std::string where =
          open_files.empty() ? "" : location().text() + ": ";
        if (++n_files > max_files)
          throw InputError(where + "the scene is read from more than " +
                           std::to_string(max_files) +
                           " files; look for files that include each other");
        std::string content;
        try
          {
            content = read_input_file(file, most_bytes - n_bytes);
          }
        catch (const UnreadableFile &unreadable)
          {
            mistakes.add(where + "the parameter file \"" + file + "\" " +
                         unreadable.reason +
                         "; check its name and that you may read it");
            return;
          }
        n_bytes += content.size();
        std::istringstream stream(content);
        read_stream(stream, file);
      }

      void read_stream(std::istream &stream, const std::string &name)
      {
        const std::size_t outer_depth = depth();
        open_files.push_back({name, 0});
        std::string line;
        while (next_line(stream, line))
          parse_line(line, outer_depth);
        while (depth() > outer_depth)
          {
            mistakes.add(stack.back()->location.text() + ": subsection \"" +
                         stack.back()->name +
                         "\" is not closed; add the missing \"end\"");
            stack.pop_back();
          }
        open_files.pop_back();
      }

      ParameterSubsection result(const std::string &name)
      {
        mistakes.throw_if_any(name);
        return root;
      }

    private:
      std::size_t depth() const
      {
        return stack.size();
      }

      const FileLocation &location() const
      {
        return open_files.back();
      }

      /** Next line with its continuations, without comments. */
      bool next_line(std::istream &stream, std::string &line)
      {
        line.clear();
        std::string piece;
        bool        continued = false;
        while (std::getline(stream, piece))
          {
            ++open_files.back().line;
            const bool comment_only =
              !trim(piece).empty() && trim(piece)[0] == '#';
            piece = trim(piece.substr(0, piece.find('#')));
            // Comments may stand between the parts of a continued line.
            if (continued && comment_only)
              continue;
            continued = !piece.empty() && piece.back() == '\\';
            if (continued)
              piece.pop_back();
            line += piece;
            if (!continued)
              return true;
          }
        if (continued)
          mistakes.add(location().text() +
                       ": the file ends within a line continued by \"\\\"");
        return false;
      }

      void parse_line(const std::string &line, const std::size_t outer_depth)
      {
        if (line.empty())
          return;
        const auto [keyword, rest] = first_word(line);
        if (keyword == "subsection" && !rest.empty())
          open_subsection(single_blanks(rest));
        else if (keyword == "end" && rest.empty())
          close_subsection(outer_depth);
        else if (keyword == "set" && rest.find('=') != std::string::npos &&
                 rest[0] != '=')
          set_entry(single_blanks(rest.substr(0, rest.find('='))),
                    trim(rest.substr(rest.find('=') + 1)));
        else if (keyword == "include" && !rest.empty())
          include_file(rest);
        else
          mistakes.add(location().text() + ": line not understood: \"" + line +
                       "\"; expected one of: subsection NAME, "
                       "set NAME = VALUE, end, include FILE, # comment");
      }

      ParameterSubsection &current()
      {
        return stack.empty() ? root : *stack.back();
      }

      void open_subsection(const std::string &name)
      {
        ParameterSubsection &parent = current();
        ParameterSubsection *first  = parent.find_subsection(name);
        // A file may extend subsections of a file that it includes.
        if (first != nullptr && !stack.empty() &&
            first->location.file == location().file)
          {
            mistakes.add(location().text() + ": " + open_path() + name +
                         " is given a second time; the first is at " +
                         first->location.text() +
                         ". Give one of them another name, or make them one "
                         "subsection");
            first = nullptr;
          }
        if (first == nullptr)
          {
            parent.subsections.push_back({name, location(), {}, {}});
            first = &parent.subsections.back();
          }
        stack.push_back(first);
      }

      /** Path of the open subsections, e.g. `Supports/ground/`. */
      std::string open_path() const
      {
        std::string path;
        for (const ParameterSubsection *subsection : stack)
          path += subsection->name + "/";
        return path;
      }

      void close_subsection(const std::size_t outer_depth)
      {
        if (depth() == outer_depth)
          mistakes.add(location().text() +
                       ": \"end\" without a subsection to close; remove it");
        else
          stack.pop_back();
      }

      void set_entry(const std::string &name, const std::string &value)
      {
        const ParameterEntry *first = current().find_entry(name);
        if (first == nullptr)
          {
            current().entries.push_back({name, value, location()});
            return;
          }
        mistakes.add(location().text() + ": " + open_path() + name +
                     " is given a second time (value \"" + value +
                     "\"); the first is at " + first->location.text() +
                     " (value \"" + first->value + "\"); remove one of them");
      }

      void include_file(std::string file)
      {
        if (file.size() > 1 && file.front() == '"' && file.back() == '"')
          file = file.substr(1, file.size() - 2);
        if (file[0] != '/')
          file = directory_of(location().file) + file;
        for (const FileLocation &open : open_files)
          if (open.file == file)
            {
              mistakes.add(location().text() + ": \"" + file +
                           "\" includes itself; remove this line");
              return;
            }
        read_file(file);
      }

      ParameterSubsection                root;
      std::vector<ParameterSubsection *> stack;
      std::vector<FileLocation>          open_files;
      Mistakes                           mistakes;
      unsigned int                       n_files = 0;
      std::size_t                        n_bytes = 0;
    };
  } // namespace



  const ParameterEntry *
  ParameterSubsection::find_entry(const std::string &sought) const
  {
    return find_by_name(entries, sought);
  }



  ParameterEntry *ParameterSubsection::find_entry(const std::string &sought)
  {
    return find_by_name(entries, sought);
  }



  const ParameterSubsection *
  ParameterSubsection::find_subsection(const std::string &sought) const
  {
    return find_by_name(subsections, sought);
  }



  ParameterSubsection *
  ParameterSubsection::find_subsection(const std::string &sought)
  {
    return find_by_name(subsections, sought);
  }



  std::string values_text(const ParameterSubsection &subsection,
                          const std::string         &path)
  {
    std::string text;
    for (const ParameterEntry &entry : subsection.entries)
      text += path + entry.name + " = " + entry.value + '\n';
    for (const ParameterSubsection &inner : subsection.subsections)
      text += values_text(inner, path + inner.name + "/");
    return text;
  }

  ParameterSubsection read_parameter_file(const std::string &file)
  {
    Scanner scanner;
    scanner.read_file(file);
    ParameterSubsection root = scanner.result(file);
    root.location.file       = file;
    return root;
  }



  ParameterSubsection parse_parameter_text(const std::string &text,
                                           const std::string &name)
  {
    Scanner            scanner;
    std::istringstream stream(text);
    scanner.read_stream(stream, name);
    ParameterSubsection root = scanner.result(name);
    root.location.file       = name;
    return root;
  }



  void apply_override(ParameterSubsection            &root,
                      const std::string              &assignment,
                      const std::vector<std::string> &path_subsections)
  {
    const FileLocation       origin = {"command line", 0};
    const std::size_t        equals = assignment.find('=');
    const std::string        path   = trim(assignment.substr(0, equals));
    std::vector<std::string> names =
      dealii::Utilities::split_string_list(path, '/');
    if (names.size() > 1 &&
        std::find(path_subsections.begin(),
                  path_subsections.end(),
                  names.front()) != path_subsections.end())
      names = {names.front(), trim(path.substr(path.find('/') + 1))};
    if (equals == std::string::npos ||
        assignment.find_first_of("#\n") != std::string::npos || path.empty() ||
        path.back() == '/' ||
        std::find(names.begin(), names.end(), "") != names.end())
      throw InputError("command line: override \"" + assignment +
                       "\" not understood; expected "
                       "\"Subsection/Parameter=value\" on one line and "
                       "without #, e.g. --set \"Time/End time=0.1\"");

    ParameterSubsection *subsection = &root;
    for (std::size_t i = 0; i + 1 < names.size(); ++i)
      {
        if (subsection->find_subsection(names[i]) == nullptr)
          subsection->subsections.push_back({names[i], origin, {}, {}});
        subsection = subsection->find_subsection(names[i]);
      }
    const std::string value = trim(assignment.substr(equals + 1));
    if (ParameterEntry *entry = subsection->find_entry(names.back()))
      *entry = {names.back(), value, origin};
    else
      subsection->entries.push_back({names.back(), value, origin});
  }
} // namespace auxfem
