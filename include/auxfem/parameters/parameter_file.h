#ifndef auxfem_parameters_parameter_file_h
#define auxfem_parameters_parameter_file_h

#include <cstddef>
#include <string>
#include <vector>

namespace auxfem
{
  /** Reason why a file cannot be read, to follow its name in a message. */
  struct UnreadableFile
  {
    std::string reason;
  };

  /** Largest table or mesh file that is read (bytes), half of a large memory:
   * more is taken for a mistake. */
  constexpr std::size_t largest_input_file = std::size_t(16) << 30;

  /**
   * Content of @p file. Throws UnreadableFile if it is no regular file (a FIFO
   * would block, a device need not end), cannot be opened, or has more than
   * @p most_bytes.
   */
  std::string read_input_file(const std::string &file,
                              std::size_t most_bytes = largest_input_file);

  /** Where the user wrote something. */
  struct FileLocation
  {
    /** Name of the file, or `command line`. */
    std::string file;
    /** Line number from 1; 0 if there are no lines. */
    unsigned int line = 0;

    /** `lattice.prm:12` or `command line`. */
    std::string text() const
    {
      return line == 0 ? file : file + ":" + std::to_string(line);
    }
  };

  /** `set NAME = VALUE` as found; nothing is known yet about what it means. */
  struct ParameterEntry
  {
    std::string  name;
    std::string  value;
    FileLocation location;
  };

  /** `subsection NAME ... end` as found. Parts of equal name are one. */
  struct ParameterSubsection
  {
    std::string                      name;
    FileLocation                     location;
    std::vector<ParameterEntry>      entries;
    std::vector<ParameterSubsection> subsections;

    /** The entry of that name, or nullptr. */
    const ParameterEntry *find_entry(const std::string &name) const;
    ParameterEntry       *find_entry(const std::string &name);

    /** The subsection of that name, or nullptr. */
    const ParameterSubsection *find_subsection(const std::string &name) const;
    ParameterSubsection       *find_subsection(const std::string &name);
  };

  /** All values in @p subsection and those below it, one line each, as `@p path
   * NAME = VALUE`, subsections as parts of the path. */
  std::string values_text(const ParameterSubsection &subsection,
                          const std::string         &path);

  /**
   * Reads the parameter file @p file (deal.II's .prm syntax: `subsection NAME`,
   * `set NAME = VALUE`, `end`, `include FILE` relative to the including file,
   * comments from `#`, a line continued by a `\` at its end). Throws InputError
   * with all mistakes: a file that cannot be opened, a line not understood, an
   * entry given twice, a missing or superfluous `end`.
   */
  ParameterSubsection read_parameter_file(const std::string &file);

  /** As read_parameter_file(), for text in memory that is called @p name. */
  ParameterSubsection parse_parameter_text(const std::string &text,
                                           const std::string &name);

  /**
   * Sets one entry from the command line, written `Subsection/Parameter=value`,
   * replacing the one in @p root or making a new one. Throws InputError if
   * @p assignment is not of that form.
   */
  void apply_override(ParameterSubsection &root, const std::string &assignment);
} // namespace auxfem

#endif
