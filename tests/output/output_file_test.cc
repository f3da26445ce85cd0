#include <auxfem/output/output_folder.h>

#include <gtest/gtest.h>
#include <support/text_file.h>

#include <cerrno>
#include <filesystem>

#include <sys/stat.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  namespace fs = std::filesystem;

  class OutputFileTest : public testing::Test
  {
  protected:
    OutputFileTest()
      : folder(std::string(AUXFEM_TEST_OUTPUT_DIRECTORY "/output_file_") +
               testing::UnitTest::GetInstance()->current_test_info()->name())
    {
      fs::remove_all(folder);
      fs::create_directories(folder + "/elsewhere");
    }

    const std::string folder;
  };
} // namespace

TEST_F(OutputFileTest, IsTruncatedOrUpdated)
{
  const std::string file = folder + "/file";
  open_output_file(file) << "first text";
  EXPECT_EQ(read_text(file), "first text");
  open_output_file(file, std::ios::in | std::ios::out) << "FIRST";
  EXPECT_EQ(read_text(file), "FIRST text");
  open_output_file(file, std::ios::app) << " more";
  EXPECT_EQ(read_text(file), "FIRST text more");
  open_output_file(file) << "second";
  EXPECT_EQ(read_text(file), "second");
  EXPECT_FALSE(
    open_output_file(folder + "/none", std::ios::in | std::ios::out));
}

TEST_F(OutputFileTest, IsNoLinkPipeOrFolder)
{
  const std::string victim = folder + "/elsewhere/victim";
  write_text(victim, "mine");
  fs::create_symlink(victim, folder + "/link");
  fs::create_symlink("elsewhere/none", folder + "/dangling");
  ASSERT_EQ(mkfifo((folder + "/pipe").c_str(), 0600), 0);
  for (const std::string name : {"link", "dangling", "pipe", "elsewhere"})
    for (const auto mode :
         {std::ios::out, std::ios::app, std::ios::in | std::ios::out})
      EXPECT_FALSE(open_output_file(folder + "/" + name, mode)) << name;
  EXPECT_EQ(read_text(victim), "mine");
  EXPECT_FALSE(fs::exists(folder + "/elsewhere/none"));
}

TEST_F(OutputFileTest, SubfolderIsNoLink)
{
  fs::create_directory_symlink("elsewhere", folder + "/link");
  EXPECT_EQ(make_output_subfolder(folder + "/link").value(), ELOOP);
  EXPECT_FALSE(make_output_subfolder(folder + "/new"));
  EXPECT_FALSE(make_output_subfolder(folder + "/new"));
  EXPECT_TRUE(fs::is_directory(folder + "/new"));
}
