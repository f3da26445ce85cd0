#ifndef auxfem_tests_support_text_file_h
#define auxfem_tests_support_text_file_h

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace auxfem::testing_support
{
  inline std::string read_text(const std::filesystem::path &file)
  {
    std::ifstream     stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    if (!stream)
      throw std::runtime_error("Cannot read " + file.string());
    return text.str();
  }

  inline void write_text(const std::filesystem::path &file,
                         const std::string           &text)
  {
    std::ofstream stream(file);
    stream << text;
    stream.close();
    if (!stream)
      throw std::runtime_error("Cannot write " + file.string());
  }
} // namespace auxfem::testing_support

#endif
