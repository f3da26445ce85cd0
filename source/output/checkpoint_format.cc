#include <auxfem/output/checkpoint_format.h>

#include <zlib.h>

namespace auxfem
{
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

    void append_number(std::string &bytes, const std::uint64_t number)
    {
      for (unsigned int i = 0; i < 8; ++i)
        bytes.push_back(static_cast<char>((number >> (8 * i)) & 0xff));
    }

    void append_text(std::string &bytes, const std::string &text)
    {
      append_number(bytes, text.size());
      bytes += text;
    }

    /** Takes a file apart from its first byte on. */
    class ByteReader
    {
    public:
      explicit ByteReader(const std::string &bytes) : bytes(bytes)
      {}

      /** @p part of the file is damaged if what is next ends too early. */
      void enter(const std::string &part)
      {
        part_name  = part;
        part_begin = position;
      }

      std::string take(const std::uint64_t n)
      {
        // No sum of them, which a damaged length would let overflow.
        if (n > bytes.size() - position)
          throw DamagedCheckpoint(part_name);
        position += n;
        return bytes.substr(position - n, n);
      }

      std::uint64_t take_number()
      {
        const std::string digits = take(8);
        std::uint64_t     number = 0;
        for (unsigned int i = 0; i < 8; ++i)
          number |= std::uint64_t(static_cast<unsigned char>(digits[i]))
            << (8 * i);
        return number;
      }

      std::string take_text()
      {
        return take(take_number());
      }

      /** Compares what was read since enter() with its CRC, which is next. */
      void check_part()
      {
        const std::uint64_t expected = crc_32(bytes, part_begin, position);
        if (take_number() != expected)
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

  std::string checkpoint_bytes(const NumberedCheckpoint &checkpoint)
  {
    const CheckpointContent &content = checkpoint.content;

    std::string bytes = format_name;
    append_number(bytes, checkpoint_format_version);
    append_number(bytes, checkpoint.number);
    append_text(bytes, content.program_version);
    append_number(bytes, content.n_ranks);
    append_number(bytes, content.sections.size());
    append_number(bytes, crc_32(bytes, 0, bytes.size()));
    for (const CheckpointContent::Section &section : content.sections)
      {
        const std::size_t begin = bytes.size();
        append_text(bytes, section.name);
        append_text(bytes, section.bytes);
        append_number(bytes, crc_32(bytes, begin, bytes.size()));
      }
    return bytes;
  }

  NumberedCheckpoint read_checkpoint(const std::string &bytes)
  {
    ByteReader         reader(bytes);
    NumberedCheckpoint result;
    CheckpointContent &content = result.content;

    reader.enter("its head");
    if (reader.take(format_name.size()) != format_name)
      throw DamagedCheckpoint("its head");
    const std::uint64_t version = reader.take_number();
    result.number               = reader.take_number();
    content.program_version     = reader.take_text();
    content.n_ranks             = reader.take_number();
    const std::uint64_t n       = reader.take_number();
    reader.check_part();
    // After the checksum: a damaged version is no later version. Later formats
    // have to keep this head.
    if (version != checkpoint_format_version)
      throw LaterCheckpointFormat(version);

    for (std::uint64_t i = 0; i < n; ++i)
      {
        reader.enter("section " + std::to_string(i + 1) + " of " +
                     std::to_string(n));
        CheckpointContent::Section section;
        section.name  = reader.take_text();
        section.bytes = reader.take_text();
        reader.check_part();
        content.sections.push_back(section);
      }
    if (!reader.at_end())
      throw DamagedCheckpoint("what follows its last section");
    return result;
  }
} // namespace auxfem
