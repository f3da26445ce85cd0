#ifndef auxfem_output_output_folder_h
#define auxfem_output_output_folder_h

#include <auxfem/output/start_times.h>
#include <auxfem/time/records.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace auxfem
{
  /** What is written into a folder, by name. */
  struct FolderContents
  {
    std::vector<std::string> files;
    /** Series `NAME`: `NAME.pvd` and numbered files in the folder `NAME`. */
    std::vector<std::string> series;

    /** All files but those in folders. */
    std::vector<std::string> names() const;
  };

  /** Which files a run spares in the folder of its results. */
  struct FileRules
  {
    /** Files that the run reads: never replaced. */
    std::vector<std::string> input_files;
    /** Files that auxfem has not written are replaced as well. */
    bool replaces_files_of_others = false;
    /** Results of other kinds of runs, which go with those that are replaced,
     * where auxfem has written them and the run does not read them. */
    std::vector<std::string> results_of_other_kinds = {};
  };

  /** How a run treats the folder of results that the scene names. */
  struct FolderOptions
  {
    FileRules  rules = {}; ///< for files that lie in the folder before the run
    StartTimes start = {}; ///< of this rank, for the summary
    /** A checkpoint from which the run continues, instead of starting. */
    std::optional<Records> checkpoint = {};
  };

  /** What becomes of results that auxfem has left in a folder. */
  enum class FormerResults
  {
    removed,
    continued
  };

  /**
   * A folder for results, which belongs to this process while the object lives:
   * a second one is refused. What auxfem has written into it is listed in a
   * file, `.auxfem-files`, so that the next run replaces that and nothing else.
   * To be used on one rank.
   */
  class OutputFolder
  {
  public:
    /**
     * Makes the folder @p path if there is none, and removes what auxfem has
     * written into it earlier and @p contents would write again, or what else
     * the rules name. Throws InputError, before anything is removed, if
     * - the folder cannot be made or written to,
     * - another process writes into it,
     * - a file or folder to be written is a link,
     * - a file that the run reads would be replaced,
     * - other files that auxfem has not written would be, unless the
     *   rules allow it.
     */
    OutputFolder(const std::string    &path,
                 const FolderContents &contents,
                 const FileRules      &rules,
                 FormerResults         former_results = FormerResults::removed);

    /** Notes that auxfem writes the series @p name. */
    void claim_series(const std::string &name);

    /** Refuses the folder because of @p what, for the @p reason of an errno. */
    [[noreturn]] void refuse(const std::string &what, int reason) const;

  private:
    /** An open file; closed with the object. */
    struct Descriptor
    {
      Descriptor() = default;
      ~Descriptor();
      Descriptor(const Descriptor &)            = delete;
      Descriptor &operator=(const Descriptor &) = delete;

      int number = -1;
    };

    std::string file(const std::string &name) const
    {
      return path + "/" + name;
    }

    void make_folder() const;
    void refuse_links(const FolderContents &contents,
                      FormerResults         former_results) const;
    void lock();
    void read_list();
    void write_list();

    /** Files in the folder, by name, that @p contents would replace. */
    std::vector<std::string> former(const FolderContents &contents) const;
    bool                     is_own(const std::string &name) const;
    bool                     is_one_of(const std::string              &name,
                                       const std::vector<std::string> &files) const;

    void refuse_input(const std::vector<std::string> &names,
                      const std::vector<std::string> &input_files) const;
    void refuse_files_of_others(const std::vector<std::string> &names) const;
    void remove(const FolderContents           &contents,
                const std::vector<std::string> &names);
    void remove_results_of_other_kinds(const FileRules &rules);

    const std::string path;
    /** Holds the lock, which the system releases at the end of the process. */
    Descriptor list;
    /** Names of files, and of folders with a slash at their end. */
    std::set<std::string> own;
  };
} // namespace auxfem

#endif
