#ifndef auxfem_output_checkpoint_format_h
#define auxfem_output_checkpoint_format_h

#include <auxfem/output/checkpoint_files.h>

#include <cstdint>
#include <ostream>
#include <stdexcept>

namespace auxfem
{
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
