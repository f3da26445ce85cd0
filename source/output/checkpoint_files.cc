#include <auxfem/output/checkpoint_files.h>
#include <auxfem/output/checkpoint_format.h>
#include <auxfem/output/output_file.h>
#include <auxfem/parameters/errors.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace auxfem
{
  namespace
  {
    /** One of the two files. */
    struct CheckpointSlot
    {
      std::string                       file;
      std::optional<NumberedCheckpoint> checkpoint;
      /** Why there is no checkpoint although there is a file. */
      std::string fault;
    };

    std::string system_error()
    {
      return std::error_code(errno, std::generic_category()).message();
    }

    [[noreturn]] void cannot_write(const std::string &file)
    {
      throw ComputationError("Cannot write the checkpoint " + file + ": " +
                             system_error() + ".");
    }

    [[noreturn]] void refuse_later_format(const std::string &file,
                                          const std::string &version)
    {
      throw InputError("The checkpoint " + file + " is in version " + version +
                       " of its format; this auxfem reads version " +
                       std::to_string(checkpoint_format_version) +
                       ". Go on with the auxfem that left it.");
    }

    CheckpointSlot read_slot(const std::string &file)
    {
      CheckpointSlot slot;
      slot.file = file;
      errno     = 0;
      std::ifstream stream(file, std::ios::binary);
      if (!stream && (errno == ENOENT || errno == ENOTDIR))
        return slot;
      std::string     bytes;
      std::error_code ignored;
      if (const auto size = std::filesystem::file_size(file, ignored); !ignored)
        bytes.reserve(size);
      std::array<char, 65536> block;
      // Fails at the end of the file, too; bad() if it cannot be read to there.
      while (stream.read(block.data(), block.size()) || stream.gcount() > 0)
        bytes.append(block.data(), stream.gcount());
      if (!stream.is_open() || stream.bad())
        {
          slot.fault = "cannot be read: " + system_error();
          return slot;
        }
      try
        {
          slot.checkpoint = read_checkpoint(bytes);
        }
      catch (const DamagedCheckpoint &damage)
        {
          slot.fault = std::string("is damaged (") + damage.what() + ")";
        }
      catch (const OtherCheckpointFormat &format)
        {
          if (format.version > checkpoint_format_version)
            refuse_later_format(file, format.what());
          slot.fault =
            std::string("is in version ") + format.what() + " of its format";
        }
      return slot;
    }

    /** The two files, the one with the newest checkpoint first. */
    std::array<CheckpointSlot, 2> read_slots(const std::string &folder)
    {
      std::array<CheckpointSlot, 2> slots = {
        {read_slot(folder + "/checkpoint_b"),
         read_slot(folder + "/checkpoint_a")}};
      const auto number = [](const CheckpointSlot &slot) {
        return slot.checkpoint ? slot.checkpoint->number : 0;
      };
      if (number(slots[1]) > number(slots[0]))
        std::swap(slots[0], slots[1]);
      return slots;
    }

    /** Waits until the disk has what was written to @p path. */
    void wait_for_disk(const std::string &path, const int flags)
    {
      const int descriptor = open(path.c_str(), flags);
      if (descriptor < 0)
        cannot_write(path);
      const bool done = fsync(descriptor) == 0;
      // Closing may change why fsync has failed.
      const int reason = errno;
      close(descriptor);
      errno = reason;
      if (!done)
        cannot_write(path);
    }
  } // namespace

  CheckpointFiles::CheckpointFiles(const std::string &folder) : folder(folder)
  {}

  void CheckpointFiles::write(const CheckpointContent        &content,
                              const std::vector<std::string> &files)
  {
    if (!next)
      {
        const std::array<CheckpointSlot, 2> slots = read_slots(folder);
        next = Next{slots[0].checkpoint ? slots[0].checkpoint->number + 1 : 1,
                    slots[1].file,
                    slots[0].file};
      }
    for (const std::string &file : files)
      wait_for_disk(file, O_WRONLY);
    const std::string file = next->file, temporary = file + ".part";

    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    errno = 0;
    std::ofstream stream =
      open_output_file(temporary, std::ios::out | std::ios::binary);
    write_checkpoint(next->number, content, stream);
    stream.close();
    if (!stream)
      cannot_write(temporary);
    wait_for_disk(temporary, O_WRONLY);
    if (std::rename(temporary.c_str(), file.c_str()) != 0)
      cannot_write(file);
    // Without it a power cut may undo the renaming.
    wait_for_disk(folder, O_RDONLY | O_DIRECTORY);
    ++next->number;
    std::swap(next->file, next->other_file);
  }

  CheckpointFiles::Found CheckpointFiles::newest() const
  {
    std::array<CheckpointSlot, 2> slots = read_slots(folder);

    std::string faults;
    for (const CheckpointSlot &slot : slots)
      if (!slot.fault.empty())
        faults += (faults.empty() ? "" : ", ") + slot.file + " " + slot.fault;
    if (slots[0].checkpoint)
      return {std::move(slots[0].checkpoint->content),
              faults.empty()
                ? ""
                : "The run goes on from its other checkpoint: " + faults + "."};
    if (faults.empty())
      throw InputError("There is no checkpoint in " + folder +
                       " (checkpoint_a or checkpoint_b). Give the folder of a "
                       "simulation of a lattice that has left one, or start "
                       "from t = 0; studies go on when they are run again.");
    throw InputError("No checkpoint in " + folder + " can be used: " + faults +
                     ". Start from t = 0.");
  }
} // namespace auxfem
