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
   * Opens @p file for writing in @p mode, unless it is a link, a device or a
   * pipe, so that output never leaves its folder. On failure the stream has
   * failed and errno is set.
   */
  std::ofstream open_output_file(const std::string &file,
                                 std::ios::openmode mode = std::ios::out);

  /** Makes the folder @p path within an output folder; a link is an error. */
  std::error_code make_output_subfolder(const std::string &path);

  /** Message of an errno, with an explanation for links. */
  std::string output_error_text(int error);

  /**
   * Runs @p action on rank 0 of @p communicator only. If it throws, all ranks
   * throw the same (InputError, Interrupted, otherwise ComputationError), so
   * that none waits forever; std::bad_alloc is thrown on rank 0 only.
   * Collective.
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
    message = broadcast_text(0, message, communicator);
    if (outcome == input_error)
      throw InputError(message);
    throw ComputationError(message);
  }

  /** Times before the start of a run (s). */
  struct StartTimes
  {
    double program = 0; ///< wall time of loading the program and its libraries
    double mpi     = 0; ///< wall time of MPI_Init
    double cpu     = 0; ///< processor time of both
  };

  /** Names of files and series that are written to a folder. */
  struct FolderContents
  {
    std::vector<std::string> files;
    /** Series `NAME`: `NAME.pvd` and numbered files in the folder `NAME`. */
    std::vector<std::string> series;

    /** All files but those in folders. */
    std::vector<std::string> names() const;
  };

  /** Rules on existing files in the output folder of a run. */
  struct FileRules
  {
    /** Files that the run reads; they are never replaced. */
    std::vector<std::string> input_files;
    /** Whether files that auxfem has not written may be replaced. */
    bool replaces_files_of_others = false;
    /**
     * Results of other kinds of runs, which are removed too if auxfem has
     * written them and the run does not read them.
     */
    std::vector<std::string> results_of_other_kinds = {};
  };

  /** Options for the output folder of a run. */
  struct FolderOptions
  {
    FileRules  rules = {}; ///< for files in the folder before the run
    StartTimes start = {}; ///< start times of this rank, for the summary
    /** Checkpoint from which the run continues, if any. */
    std::optional<CheckpointData> checkpoint = {};
  };

  /** Treatment of results of an earlier run in the folder. */
  enum class FormerResults
  {
    removed,
    continued
  };

  /**
   * A folder for results, locked by this process while the object lives. The
   * file `.auxfem-files` lists the files that auxfem has written, so that the
   * next run replaces only those. Used on one rank.
   */
  class OutputFolder
  {
  public:
    /**
     * Makes the folder @p path if needed. Removes files that auxfem has written
     * and that @p contents would replace or the rules name. Throws InputError,
     * before anything is removed, if
     * - the folder cannot be made or written to,
     * - another process writes into it,
     * - a file or folder to be written is a link,
     * - a file that the run reads would be replaced,
     * - a file that auxfem has not written would be replaced, unless the rules
     *   allow it.
     */
    OutputFolder(const std::string    &path,
                 const FolderContents &contents,
                 const FileRules      &rules,
                 FormerResults         former_results = FormerResults::removed);

    /** Registers the series @p name as written by auxfem. */
    void claim_series(const std::string &name);

    /**
     * Throws InputError on the folder because of @p what, with the errno @p
     * reason.
     */
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

    /** Names of files in the folder that @p contents would replace. */
    std::vector<std::string>
         existing_results(const FolderContents &contents) const;
    bool is_own(const std::string &name) const;
    bool is_one_of(const std::string              &name,
                   const std::vector<std::string> &files) const;

    void refuse_input(const std::vector<std::string> &names,
                      const std::vector<std::string> &input_files) const;
    void refuse_files_of_others(const std::vector<std::string> &names) const;
    void remove(const FolderContents           &contents,
                const std::vector<std::string> &names);
    void remove_results_of_other_kinds(const FileRules &rules);

    const std::string path;
    /**
     * File with the lock, which the system releases at the end of the process.
     */
    Descriptor list;
    /** Names of files, and of folders with a slash at their end. */
    std::set<std::string> own_names;
  };

  /** @p rules that also protect all files that @p scene was read from. */
  FileRules with_inputs_of(const Scene &scene, FileRules rules);

  /**
   * Output folder of a run with original.prm (the user's file), parameters.prm
   * (all values) and the log. Used on one rank.
   */
  class RunFolder
  {
  public:
    /**
     * Makes the folder of @p scene and removes the results of an earlier run,
     * unless the run continues them and the log. Input files are kept. Throws
     * InputError if the folder cannot be used, see OutputFolder.
     * @param further contents besides those of a simulation
     */
    RunFolder(const Scene          &scene,
              const FileRules      &rules,
              const FolderContents &further        = {},
              FormerResults         former_results = FormerResults::removed);

    /** Registers the series @p name as written by the run. */
    void claim_series(const std::string &name);

    /** Stream to log.txt with printable characters only. */
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
   * Replaces @p file by @p text atomically, so that a reader finds the old or
   * the new text. Throws ComputationError if writing fails.
   */
  void replace_file(const std::string &file, const std::string &text);
} // namespace auxfem

#endif
