#include <auxfem/output/checkpoint_files.h>

#include <boost/crc.hpp>
#include <gtest/gtest.h>
#include <support/text_file.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <support/messages.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace auxfem;

namespace
{
  namespace fs = std::filesystem;

  std::string checkpoint_folder(const std::string &name)
  {
    const fs::path folder =
      fs::path(AUXFEM_TEST_OUTPUT_DIRECTORY) / ("checkpoint_files_" + name);
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
  }

  /** Two sections, which also contain zero bytes and line ends. */
  CheckpointContent content_of(const std::string &bytes)
  {
    return {"1.2.3",
            4,
            {{"state", bytes}, {"rest", std::string("\0\r\n\xff", 4)}}};
  }

  std::string found_in(const std::string &folder)
  {
    return CheckpointFiles(folder).newest().content.sections.at(0).bytes;
  }

  void write_bytes(const std::string &file, const std::string &bytes)
  {
    std::ofstream(file, std::ios::binary) << bytes;
  }

  /** Changes a byte in the last section. */
  void damage(const std::string &file)
  {
    std::string bytes = testing_support::read_text(file);
    bytes.at(bytes.size() - 10) ^= 1;
    write_bytes(file, bytes);
  }

  std::string checkpoint_bytes(const std::uint64_t      number,
                               const CheckpointContent &content)
  {
    std::ostringstream stream;
    write_checkpoint(number, content, stream);
    return stream.str();
  }

  /** The head of a checkpoint in another @p version of the format. */
  std::string in_version(const std::uint64_t version, const std::string &bytes)
  {
    // 16 bytes of name; five more numbers and the text "1.2.3".
    const std::size_t end    = 16 + 5 * 8 + 5;
    std::string       result = bytes.substr(0, end);
    result.at(16)            = static_cast<char>(version);
    boost::crc_32_type crc;
    crc.process_bytes(result.data(), result.size());
    for (unsigned int i = 0; i < 8; ++i)
      result.push_back(
        static_cast<char>((std::uint64_t(crc.checksum()) >> (8 * i)) & 0xff));
    return result;
  }
} // namespace

TEST(CheckpointFormat, ReadsWrittenContent)
{
  const NumberedCheckpoint read =
    read_checkpoint(checkpoint_bytes(1ull << 40, content_of("abc")));
  EXPECT_EQ(read.number, 1ull << 40);
  EXPECT_EQ(read.content.program_version, "1.2.3");
  EXPECT_EQ(read.content.n_ranks, 4u);
  ASSERT_EQ(read.content.sections.size(), 2u);
  EXPECT_EQ(read.content.sections[0].name, "state");
  EXPECT_EQ(read.content.sections[0].bytes, "abc");
  EXPECT_EQ(read.content.sections[1].name, "rest");
  EXPECT_EQ(read.content.sections[1].bytes, std::string("\0\r\n\xff", 4));
}

TEST(CheckpointFormat, DetectsEveryChangedBit)
{
  const std::string whole = checkpoint_bytes(3, content_of("abc"));
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (unsigned int bit = 0; bit < 8; ++bit)
      {
        std::string bytes = whole;
        bytes[i] ^= static_cast<char>(1 << bit);
        EXPECT_THROW(read_checkpoint(bytes), DamagedCheckpoint)
          << "bit " << bit << " of byte " << i;
      }
}

TEST(CheckpointFormat, DetectsTruncationAtEveryLength)
{
  const std::string whole = checkpoint_bytes(3, content_of("abc"));
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_THROW(read_checkpoint(whole.substr(0, n)), DamagedCheckpoint) << n;
  EXPECT_THROW(read_checkpoint(whole + "x"), DamagedCheckpoint);
}

TEST(CheckpointFiles, AlternateBetweenFiles)
{
  const std::string folder = checkpoint_folder("turns");
  CheckpointFiles   files(folder);
  files.write(content_of("first"));
  EXPECT_TRUE(fs::exists(folder + "/checkpoint_a"));
  EXPECT_FALSE(fs::exists(folder + "/checkpoint_b"));
  files.write(content_of("second"));
  const std::string second =
    testing_support::read_text(folder + "/checkpoint_b");
  EXPECT_EQ(found_in(folder), "second");
  files.write(content_of("third"));
  EXPECT_EQ(testing_support::read_text(folder + "/checkpoint_b"), second);
  EXPECT_EQ(found_in(folder), "third");
  EXPECT_EQ(files.newest().warning, "");
  EXPECT_FALSE(fs::exists(folder + "/checkpoint_a.part"));
}

TEST(CheckpointFiles, DamagedNewestIsReplacedByOlder)
{
  const std::string folder = checkpoint_folder("damaged");
  CheckpointFiles   files(folder);
  files.write(content_of("first"));
  files.write(content_of("second"));
  damage(folder + "/checkpoint_b");
  EXPECT_EQ(found_in(folder), "first");
  expect_parts(files.newest().warning,
               {folder + "/checkpoint_b",
                "damaged (section 2 of 2)",
                "goes on from its other checkpoint"});

  // The next write replaces the damaged file.
  CheckpointFiles(folder).write(content_of("third"));
  EXPECT_EQ(found_in(folder), "third");
  EXPECT_EQ(files.newest().warning, "");
  damage(folder + "/checkpoint_b");
  EXPECT_EQ(found_in(folder), "first");
}

TEST(CheckpointFiles, NoUsableCheckpointIsAnError)
{
  const std::string folder = checkpoint_folder("none");
  CheckpointFiles   files(folder);
  const auto        message = [](const CheckpointFiles &files) {
    return input_error_of([&]() { files.newest(); });
  };
  expect_parts(message(files), {"no checkpoint in " + folder, "start from"});
  expect_parts(message(CheckpointFiles(folder + "/missing")),
               {"no checkpoint in " + folder + "/missing"});

  files.write(content_of("first"));
  files.write(content_of("second"));
  damage(folder + "/checkpoint_a");
  write_bytes(folder + "/checkpoint_b", "");
  expect_parts(message(files),
               {"checkpoint_a is damaged (section 2 of 2)",
                "checkpoint_b is damaged (its head)",
                "Start from t = 0"});
}

TEST(CheckpointFiles, UnreadableFileIsReplacedByOther)
{
  const std::string folder = checkpoint_folder("unreadable");
  CheckpointFiles   files(folder);
  files.write(content_of("first"));
  fs::create_directory(folder + "/checkpoint_b");
  EXPECT_EQ(found_in(folder), "first");
  expect_parts(files.newest().warning,
               {"checkpoint_b cannot be read: Is a directory"});
  EXPECT_THROW(files.write(content_of("second")), ComputationError);
  EXPECT_EQ(found_in(folder), "first");
}

TEST(CheckpointFiles, LaterFormatIsRejectedAndKept)
{
  const std::string folder = checkpoint_folder("later");
  CheckpointFiles   files(folder);
  files.write(content_of("first"));
  const std::string later =
    in_version(checkpoint_format_version + 1,
               testing_support::read_text(folder + "/checkpoint_a"));
  write_bytes(folder + "/checkpoint_b", later);
  const std::vector<std::string> parts = {"checkpoint_b",
                                          "version 3",
                                          "reads version 2"};
  expect_parts(input_error_of([&]() { files.newest(); }), parts);
  expect_parts(input_error_of(
                 [&]() { CheckpointFiles(folder).write(content_of("")); }),
               parts);
  EXPECT_EQ(testing_support::read_text(folder + "/checkpoint_b"), later);
}

TEST(CheckpointFiles, EarlierFormatIsReportedAndReplaced)
{
  const std::string folder = checkpoint_folder("earlier");
  CheckpointFiles(folder).write(content_of("first"));
  write_bytes(folder + "/checkpoint_a",
              in_version(checkpoint_format_version - 1,
                         testing_support::read_text(folder + "/checkpoint_a")));
  expect_parts(input_error_of([&]() { CheckpointFiles(folder).newest(); }),
               {"checkpoint_a is in version 1 of its format"});
  CheckpointFiles(folder).write(content_of("second"));
  EXPECT_EQ(found_in(folder), "second");
}

TEST(CheckpointFiles, MissingFolderIsAnError)
{
  CheckpointFiles files(checkpoint_folder("gone") + "/missing");
  EXPECT_THROW(files.write(content_of("")), ComputationError);
}

namespace
{
  /** Writes checkpoints forever; reports each to @p pipe. */
  [[noreturn]] void write_for_ever(const std::string &folder, const int pipe)
  {
    for (unsigned char i = 1;; ++i)
      {
        CheckpointFiles(folder).write(content_of(std::string(200000, i)));
        if (write(pipe, &i, 1) != 1)
          _exit(1);
      }
  }

  /** Last byte from @p pipe after the byte @p last. */
  unsigned char last_of(const int pipe, unsigned char last)
  {
    while (read(pipe, &last, 1) == 1)
      ;
    return last;
  }
} // namespace

TEST(CheckpointFiles, KilledProcessKeepsWrittenCheckpoints)
{
  std::mt19937                       generator(27);
  std::uniform_int_distribution<int> microseconds(0, 25000);
  for (unsigned int i = 0; i < 20; ++i)
    {
      const std::string folder = checkpoint_folder("killed");
      int               ends[2];
      ASSERT_EQ(pipe(ends), 0);
      const pid_t child = fork();
      if (child == 0)
        write_for_ever(folder, ends[1]);
      close(ends[1]);
      // A busy disk may need longer for the first checkpoint than the sleep.
      unsigned char first_written = 0;
      ASSERT_EQ(read(ends[0], &first_written, 1), 1);
      usleep(microseconds(generator));
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
      const unsigned char last = last_of(ends[0], first_written);
      close(ends[0]);

      const auto        found = CheckpointFiles(folder).newest();
      const std::string bytes = found.content.sections.at(0).bytes;
      EXPECT_EQ(found.warning, "");
      const unsigned char first = bytes.at(0);
      EXPECT_TRUE(first == last ||
                  first == static_cast<unsigned char>(last + 1))
        << int(first) << " after " << int(last);
      EXPECT_EQ(bytes, std::string(200000, bytes.at(0)));
    }
}
