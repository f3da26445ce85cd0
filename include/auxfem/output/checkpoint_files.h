#ifndef auxfem_output_checkpoint_files_h
#define auxfem_output_checkpoint_files_h

#include <cstdint>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace auxfem
{
  /** What a checkpoint file holds. */
  struct CheckpointContent
  {
    struct Section
    {
      std::string name;
      std::string bytes;
    };

    /** Of the auxfem that took it. */
    std::string program_version;
    /** Of the run that took it. */
    unsigned int         n_ranks = 1;
    std::vector<Section> sections;
  };

  /**
   * The last two checkpoints of a run, checkpoint_a and checkpoint_b in its
   * folder. They are written in turn, so that one is left if the other gets
   * lost. One file holds what all ranks have to keep: what moves into place in
   * one go cannot be of different steps on different ranks. What is there is
   * looked at before the first is written. To be used on one rank.
   *
   * A file is: 16 bytes that name the format, its version, which checkpoint of
   * the run it is, the version of auxfem, the number of ranks, the number of
   * sections; each section with its name, its bytes and the CRC-32 (ISO 3309)
   * of both; nothing after them. Integers have 8 bytes, the lowest first; texts
   * have their length before them. The head has a CRC-32, too.
   */
  class CheckpointFiles
  {
  public:
    explicit CheckpointFiles(const std::string &folder);

    /**
     * Puts @p content in the place of the older checkpoint, or of one that
     * cannot be read. When it returns, the disk has it and what was written to
     * @p files before: neither the end of the process nor a power cut loses it,
     * and either before leaves both checkpoints as they were. Throws
     * ComputationError if it cannot be written, and InputError rather than
     * replace what only a later auxfem can read.
     */
    void write(const CheckpointContent        &content,
               const std::vector<std::string> &files = {});

    struct Found
    {
      CheckpointContent content;
      /** What is wrong with the file that is not used; empty if nothing is. */
      std::string warning;
    };

    /**
     * The newest checkpoint that is undamaged. Throws InputError if there is
     * none, or if one of the two is in a later version of the format.
     */
    Found newest() const;

  private:
    /** Where the next one goes. */
    struct Next
    {
      std::uint64_t number;
      std::string   file, other_file;
    };

    const std::string   folder;
    std::optional<Next> next; ///< from the first write() on
  };

  /** A checkpoint among those of its run. */
  struct NumberedCheckpoint
  {
    std::uint64_t     number; ///< the larger, the newer
    CheckpointContent content;
  };

  /** Says what part of a checkpoint file is damaged, e.g. `its head`. */
  class DamagedCheckpoint : public std::runtime_error
  {
  public:
    explicit DamagedCheckpoint(const std::string &part)
      : std::runtime_error(part)
    {}
  };

  /** A checkpoint file is whole, but in another version of the format. */
  class OtherCheckpointFormat : public std::runtime_error
  {
  public:
    explicit OtherCheckpointFormat(const std::uint64_t version)
      : std::runtime_error(std::to_string(version))
      , version(version)
    {}

    const std::uint64_t version;
  };

  /** The version of the format that is written, the only one that is read. */
  inline constexpr std::uint64_t checkpoint_format_version = 2;

  /** Writes a file as CheckpointFiles describes it, section after section: none
   * is held twice.
   * @param number the larger, the newer */
  void write_checkpoint(std::uint64_t            number,
                        const CheckpointContent &content,
                        std::ostream            &stream);

  /**
   * What write_checkpoint() was given. Throws DamagedCheckpoint and
   * OtherCheckpointFormat.
   */
  NumberedCheckpoint read_checkpoint(const std::string &bytes);
} // namespace auxfem

#endif
