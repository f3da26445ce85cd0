#include <auxfem/output/checkpoint_files.h>
#include <auxfem/output/output_folder.h>
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
#include <zlib.h>

namespace auxfem
{
  namespace
  {
    /** One of the two files. */
    struct CheckpointSlot
    {
      std::string                       file;
      std::optional<NumberedCheckpoint> checkpoint;
      /** Defect of the file; empty if the checkpoint is usable. */
      std::string fault;
    };

    std::string system_error()
    {
      return std::error_code(errno, std::generic_category()).message();
    }

    [[noreturn]] void throw_write_error(const std::string &file)
    {
      throw ComputationError("Cannot write the checkpoint " + file + ": " +
                             system_error() + ".");
    }

    [[noreturn]] void throw_later_format(const std::string &file,
                                         const std::string &version)
    {
      throw InputError("The checkpoint " + file + " is in version " + version +
                       " of its format; this auxfem reads version " +
                       std::to_string(checkpoint_format_version) +
                       ". Continue with the auxfem that wrote it.");
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
      // Reading always fails at the end of the file; bad() shows a real error.
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
            throw_later_format(file, format.what());
          slot.fault =
            std::string("is in version ") + format.what() + " of its format";
        }
      return slot;
    }

    /** Reads the two files; the one with the newest checkpoint comes first. */
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

    /** Waits until all data of @p path are on disk. */
    void wait_for_disk(const std::string &path, const int flags)
    {
      const int descriptor = open(path.c_str(), flags);
      if (descriptor < 0)
        throw_write_error(path);
      const bool done = fsync(descriptor) == 0;
      // close() may overwrite errno.
      const int reason = errno;
      close(descriptor);
      errno = reason;
      if (!done)
        throw_write_error(path);
    }
  } // namespace

  CheckpointFiles::CheckpointFiles(const std::string &folder) : folder(folder)
  {}

  void CheckpointFiles::write(const CheckpointContent        &content,
                              const std::vector<std::string> &files)
  {
    if (!target)
      {
        const std::array<CheckpointSlot, 2> slots = read_slots(folder);
        target =
          WriteTarget{slots[0].checkpoint ? slots[0].checkpoint->number + 1 : 1,
                      slots[1].file,
                      slots[0].file};
      }
    for (const std::string &file : files)
      wait_for_disk(file, O_WRONLY);
    const std::string file = target->file, temporary = file + ".part";

    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    errno = 0;
    std::ofstream stream =
      open_output_file(temporary, std::ios::out | std::ios::binary);
    write_checkpoint(target->number, content, stream);
    stream.close();
    if (!stream)
      throw_write_error(temporary);
    wait_for_disk(temporary, O_WRONLY);
    if (std::rename(temporary.c_str(), file.c_str()) != 0)
      throw_write_error(file);
    // Otherwise a power failure may undo the renaming.
    wait_for_disk(folder, O_RDONLY | O_DIRECTORY);
    ++target->number;
    std::swap(target->file, target->other_file);
  }

  CheckpointFiles::LoadedCheckpoint CheckpointFiles::newest() const
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
      throw InputError(
        "There is no checkpoint in " + folder +
        " (checkpoint_a or checkpoint_b). Give the folder of a lattice "
        "simulation with checkpoints, or start from t = 0. Studies continue "
        "when they are run again.");
    throw InputError("No checkpoint in " + folder + " can be used: " + faults +
                     ". Start from t = 0.");
  }

  namespace
  {
    const std::string format_name = "auxfem restart\r\n";

    std::uint64_t crc_32(const std::string &bytes,
                         const std::size_t  begin,
                         const std::size_t  end)
    {
      return crc32_z(0,
                     reinterpret_cast<const Bytef *>(bytes.data()) + begin,
                     end - begin);
    }

    /** Writes a file in parts, each followed by its CRC. */
    class PartWriter
    {
    public:
      explicit PartWriter(std::ostream &stream) : stream(stream)
      {}

      void write(const char *const bytes, const std::size_t n)
      {
        stream.write(bytes, n);
        sum = crc32_z(sum, reinterpret_cast<const Bytef *>(bytes), n);
      }

      void write_number(const std::uint64_t number)
      {
        std::array<char, 8> digits;
        for (unsigned int i = 0; i < 8; ++i)
          digits[i] = static_cast<char>((number >> (8 * i)) & 0xff);
        write(digits.data(), digits.size());
      }

      void write_text(const std::string &text)
      {
        write_number(text.size());
        write(text.data(), text.size());
      }

      void end_part()
      {
        write_number(sum);
        sum = 0;
      }

    private:
      std::ostream &stream;
      std::uint64_t sum = 0; ///< CRC of the part so far
    };

    /** Reads a file sequentially and checks the CRC of each part. */
    class ByteReader
    {
    public:
      explicit ByteReader(const std::string &bytes) : bytes(bytes)
      {}

      /** Starts a part of the file, with its name for errors. */
      void begin_part(const std::string &part)
      {
        part_name  = part;
        part_begin = position;
      }

      std::string read(const std::uint64_t n)
      {
        // A sum could overflow with a damaged length.
        if (n > bytes.size() - position)
          throw DamagedCheckpoint(part_name);
        position += n;
        return bytes.substr(position - n, n);
      }

      std::uint64_t read_number()
      {
        const std::string digits = read(8);
        std::uint64_t     number = 0;
        for (unsigned int i = 0; i < 8; ++i)
          number |= std::uint64_t(static_cast<unsigned char>(digits[i]))
            << (8 * i);
        return number;
      }

      std::string read_text()
      {
        return read(read_number());
      }

      /** Compares the bytes since enter() with the CRC that follows. */
      void check_part()
      {
        const std::uint64_t expected = crc_32(bytes, part_begin, position);
        if (read_number() != expected)
          throw DamagedCheckpoint(part_name);
      }

      bool at_end() const
      {
        return position == bytes.size();
      }

    private:
      const std::string &bytes;
      std::size_t        position = 0, part_begin = 0;
      std::string        part_name;
    };
  } // namespace

  void write_checkpoint(const std::uint64_t      number,
                        const CheckpointContent &content,
                        std::ostream            &stream)
  {
    PartWriter writer(stream);
    writer.write(format_name.data(), format_name.size());
    writer.write_number(checkpoint_format_version);
    writer.write_number(number);
    writer.write_text(content.program_version);
    writer.write_number(content.n_ranks);
    writer.write_number(content.sections.size());
    writer.end_part();
    for (const CheckpointContent::Section &section : content.sections)
      {
        writer.write_text(section.name);
        writer.write_text(section.bytes);
        writer.end_part();
      }
  }

  NumberedCheckpoint read_checkpoint(const std::string &bytes)
  {
    ByteReader         reader(bytes);
    NumberedCheckpoint result;
    CheckpointContent &content = result.content;

    reader.begin_part("its head");
    if (reader.read(format_name.size()) != format_name)
      throw DamagedCheckpoint("its head");
    const std::uint64_t version = reader.read_number();
    result.number               = reader.read_number();
    content.program_version     = reader.read_text();
    content.n_ranks             = reader.read_number();
    const std::uint64_t n       = reader.read_number();
    reader.check_part();
    // The checksum comes first, because a damaged version number is no other
    // version. Later formats must keep this head.
    if (version != checkpoint_format_version)
      throw OtherCheckpointFormat(version);

    for (std::uint64_t i = 0; i < n; ++i)
      {
        reader.begin_part("section " + std::to_string(i + 1) + " of " +
                          std::to_string(n));
        CheckpointContent::Section section;
        section.name  = reader.read_text();
        section.bytes = reader.read_text();
        reader.check_part();
        content.sections.push_back(std::move(section));
      }
    if (!reader.at_end())
      throw DamagedCheckpoint("what follows its last section");
    return result;
  }
} // namespace auxfem
