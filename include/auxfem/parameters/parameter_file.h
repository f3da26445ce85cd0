#ifndef auxfem_parameters_parameter_file_h
#define auxfem_parameters_parameter_file_h

#include <cstddef>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Reason why a file cannot be read; a message states it after the file name.
   */
  struct UnreadableFile
  {
    std::string reason;
  };

  /**
   * Largest table or mesh file that is read (bytes). Larger files are assumed
   * to be a mistake.
   */
  constexpr std::size_t largest_input_file = std::size_t(16) << 30;

  /**
   * Content of @p file. Throws UnreadableFile if the file cannot be opened, has
   * more than @p most_bytes, or is not a regular file: a FIFO would block, a
   * device need not end.
   */
  std::string read_input_file(const std::string &file,
                              std::size_t most_bytes = largest_input_file);

  /** Position in the user's input. */
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

  /** `set NAME = VALUE` as written, not yet checked. */
  struct ParameterEntry
  {
    std::string  name;
    std::string  value;
    FileLocation location;
  };

  /**
   * `subsection NAME ... end` as written; subsections of equal name are merged.
   */
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

  /**
   * All values in @p subsection and below, one line each as `PATH NAME =
   * VALUE`, where subsections are parts of the path.
   */
  std::string values_text(const ParameterSubsection &subsection,
                          const std::string         &path);

  /**
   * Reads the parameter file @p file in deal.II's .prm syntax: `subsection
   * NAME`, `set NAME = VALUE`, `end`, `include FILE` relative to the including
   * file, comments from `#`, lines continued by a final `\`. Throws InputError
   * that lists all mistakes: unreadable files, invalid lines, repeated entries,
   * unbalanced `end`.
   */
  ParameterSubsection read_parameter_file(const std::string &file);

  /**
   * As read_parameter_file(), for text in memory; @p name stands for the file
   * name.
   */
  ParameterSubsection parse_parameter_text(const std::string &text,
                                           const std::string &name);

  /**
   * Sets one entry from the command line, `Subsection/Parameter=value`:
   * replaces that in @p root or adds it. Throws InputError if @p assignment has
   * another form.
   * @param path_subsections names of subsections whose entries are paths, see
   *   SubsectionSchema::Form::path_entries
   */
  void apply_override(ParameterSubsection            &root,
                      const std::string              &assignment,
                      const std::vector<std::string> &path_subsections = {});
} // namespace auxfem

#endif
