#ifndef auxfem_output_output_folder_h
#define auxfem_output_output_folder_h

#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/state/interruption.h>

#include <deal.II/base/mpi.h>

#include <fstream>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace auxfem
{
  /**
   * Opens @p file to be written in @p mode, unless it is a link, a device or a
   * pipe: output never ends up outside of its folder. The stream has failed if
   * that is not possible, and errno says why.
   */
  std::ofstream open_output_file(const std::string &file,
                                 std::ios::openmode mode = std::ios::out);

  /** Makes the folder @p path in an output folder; a link is an error. */
  std::error_code make_output_subfolder(const std::string &path);

  /** Message of an errno; for a link in words that help. */
  std::string output_error_text(int error);

  /**
   * Runs @p action on rank 0 of @p communicator only; if it throws, all ranks
   * throw the same (InputError, Interrupted, or ComputationError for all else),
   * so that none waits for another for ever; but std::bad_alloc is thrown on
   * rank 0 only. Collective.
   */
  template <typename Action>
  void on_first_rank(const MPI_Comm communicator, const Action &action)
  {
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
      {
        action();
        return;
      }

    enum Outcome : int
    {
      done,
      input_error,
      interrupted,
      computation_error
    };
    int         outcome = done;
    int         signal  = 0;
    std::string message;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          action();
        }
      catch (const InputError &error)
        {
          outcome = input_error;
          message = error.what();
        }
      catch (const Interrupted &interruption)
        {
          outcome = interrupted;
          signal  = interruption.signal();
        }
      catch (const std::bad_alloc &)
        {
          // main() ends the other ranks.
          throw;
        }
      catch (const std::exception &error)
        {
          outcome = computation_error;
          message = error.what();
        }

    outcome = dealii::Utilities::MPI::broadcast(communicator, outcome);
    if (outcome == done)
      return;
    if (outcome == interrupted)
      throw Interrupted(
        dealii::Utilities::MPI::broadcast(communicator, signal));
    message = text_of_rank(0, message, communicator);
    if (outcome == input_error)
      throw InputError(message);
    throw ComputationError(message);
  }

  /** What the operating system and MPI took before the run could begin (s). */
  struct StartTimes
  {
    double program = 0; ///< wall time of loading the program and its libraries
    double mpi     = 0; ///< wall time of MPI_Init
    double cpu     = 0; ///< processor time of both
  };

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
    std::optional<CheckpointData> checkpoint = {};
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

  /** @p rules that spare all files @p scene was read from, too. */
  FileRules with_inputs_of(const Scene &scene, FileRules rules);

  /**
   * The folder of a run, with original.prm, the file as the user gave it,
   * parameters.prm, all values used, and the log. To be used on one rank.
   */
  class RunFolder
  {
  public:
    /**
     * Makes the folder that @p scene names, whose files are spared, and removes
     * the results of an earlier run in it, unless they are continued: then the
     * log is. Throws InputError that says why the folder cannot be used, see
     * OutputFolder.
     * @param further that the run writes, besides those of a simulation.
     */
    RunFolder(const Scene          &scene,
              const FileRules      &rules,
              const FolderContents &further        = {},
              FormerResults         former_results = FormerResults::removed);

    /** Notes that the run writes the series @p name. */
    void claim_series(const std::string &name);

    /** log.txt, which is read on terminals. */
    std::ostream &log()
    {
      return log_stream;
    }

  private:
    void write(const std::string &name, const std::string &text) const;

    OutputFolder      folder;
    const std::string path;
    std::ofstream     log_file;
    PrintableBuffer   log_buffer{log_file.rdbuf()};
    std::ostream      log_stream{&log_buffer};
  };

  /**
   * Replaces @p file by @p text in one move, so that a reader finds the old or
   * the new text. Throws ComputationError if it cannot be written.
   */
  void replace_file(const std::string &file, const std::string &text);
} // namespace auxfem

#endif
