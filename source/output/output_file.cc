#include <auxfem/output/output_file.h>

#include <cerrno>
#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

namespace auxfem
{
  std::ofstream open_output_file(const std::string       &file,
                                 const std::ios::openmode mode)
  {
    const bool    may_be_new = (mode & std::ios::in) == 0;
    std::ofstream stream;
    const int     descriptor = ::open(file.c_str(),
                                  O_WRONLY | O_NOFOLLOW | O_NONBLOCK |
                                    O_CLOEXEC | (may_be_new ? O_CREAT : 0),
                                  0666);
    if (descriptor < 0)
      {
        stream.setstate(std::ios::failbit);
        return stream;
      }
    // By its name, the file could have become a link in the meantime.
    stream.open("/proc/self/fd/" + std::to_string(descriptor), mode);
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    return stream;
  }

  std::error_code make_output_subfolder(const std::string &path)
  {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (!error &&
        std::filesystem::is_symlink(
          std::filesystem::symlink_status(path, error)))
      error = {ELOOP, std::generic_category()};
    return error;
  }

  std::string output_error_text(const int error)
  {
    return error == ELOOP ? "it is a link, and output never goes through links"
                          : std::generic_category().message(error);
  }
} // namespace auxfem
