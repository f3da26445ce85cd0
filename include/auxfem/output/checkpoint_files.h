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
  /** Content of a checkpoint file. */
  struct CheckpointContent
  {
    struct Section
    {
      std::string name;
      std::string bytes;
    };

    /** Version of auxfem that wrote the checkpoint. */
    std::string program_version;
    /** Number of ranks of the run that wrote it. */
    unsigned int         n_ranks = 1;
    std::vector<Section> sections;
  };

  /**
   * The last two checkpoints of a run, checkpoint_a and checkpoint_b in its
   * folder. They are written alternately, so that one survives the loss of the
   * other. One file holds the data of all ranks, so that all belong to the same
   * step. Used on one rank.
   *
   * File format: 16 bytes with the name of the format, its version, the number
   * of the checkpoint, the version of auxfem, the numbers of ranks and of
   * sections, and a CRC-32 (ISO 3309). Each section follows with name, bytes
   * and CRC-32. Integers have 8 bytes, little-endian; texts follow their
   * length.
   */
  class CheckpointFiles
  {
  public:
    explicit CheckpointFiles(const std::string &folder);

    /**
     * Replaces the older or an unreadable checkpoint by @p content. On return,
     * it and all data in @p files are on disk and survive a power failure; an
     * earlier failure leaves both checkpoints unchanged. Throws
     * ComputationError if writing fails, and InputError instead of replacing a
     * file that only a later auxfem can read.
     */
    void write(const CheckpointContent        &content,
               const std::vector<std::string> &files = {});

    struct LoadedCheckpoint
    {
      CheckpointContent content;
      /** Defect of the file that is not used; empty if there is none. */
      std::string warning;
    };

    /**
     * Loads the newest undamaged checkpoint. Throws InputError if there is
     * none, or if one of the two has a later format version.
     */
    LoadedCheckpoint newest() const;

  private:
    /** Target of the next write(). */
    struct WriteTarget
    {
      std::uint64_t number;
      std::string   file, other_file;
    };

    const std::string          folder;
    std::optional<WriteTarget> target; ///< from the first write() on
  };

  /** A checkpoint with its number within the run. */
  struct NumberedCheckpoint
  {
    std::uint64_t     number; ///< the larger, the newer
    CheckpointContent content;
  };

  /** Error with the damaged part of a checkpoint file, e.g. `its head`. */
  class DamagedCheckpoint : public std::runtime_error
  {
  public:
    explicit DamagedCheckpoint(const std::string &part)
      : std::runtime_error(part)
    {}
  };

  /** Error for an intact checkpoint file with another format version. */
  class OtherCheckpointFormat : public std::runtime_error
  {
  public:
    explicit OtherCheckpointFormat(const std::uint64_t version)
      : std::runtime_error(std::to_string(version))
      , version(version)
    {}

    const std::uint64_t version;
  };

  /** Format version; auxfem reads only this one. */
  inline constexpr std::uint64_t checkpoint_format_version = 2;

  /**
   * Writes a file in the format of CheckpointFiles, section by section, so that
   * no section is copied.
   * @param number increases from checkpoint to checkpoint
   */
  void write_checkpoint(std::uint64_t            number,
                        const CheckpointContent &content,
                        std::ostream            &stream);

  /**
   * Reads a file of write_checkpoint(). Throws DamagedCheckpoint and
   * OtherCheckpointFormat.
   */
  NumberedCheckpoint read_checkpoint(const std::string &bytes);
} // namespace auxfem

#endif
