#include <auxfem/output/checkpoint_format.h>

#include <array>
#include <utility>

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

    /** Writes a file part by part, each with its CRC behind it. */
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

    reader.enter("its head");
    if (reader.take(format_name.size()) != format_name)
      throw DamagedCheckpoint("its head");
    const std::uint64_t version = reader.take_number();
    result.number               = reader.take_number();
    content.program_version     = reader.take_text();
    content.n_ranks             = reader.take_number();
    const std::uint64_t n       = reader.take_number();
    reader.check_part();
    // After the checksum: a damaged version is no other version. Later formats
    // have to keep this head.
    if (version != checkpoint_format_version)
      throw OtherCheckpointFormat(version);

    for (std::uint64_t i = 0; i < n; ++i)
      {
        reader.enter("section " + std::to_string(i + 1) + " of " +
                     std::to_string(n));
        CheckpointContent::Section section;
        section.name  = reader.take_text();
        section.bytes = reader.take_text();
        reader.check_part();
        content.sections.push_back(std::move(section));
      }
    if (!reader.at_end())
      throw DamagedCheckpoint("what follows its last section");
    return result;
  }
} // namespace auxfem
