#include <auxfem/parameters/input_file.h>

#include <array>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace auxfem
{
  namespace
  {
    [[noreturn]] void fail(const std::string &action, const int error)
    {
      throw UnreadableFile{"cannot be " + action + " (" +
                           std::generic_category().message(error) + ")"};
    }

    /** A file open for reading, closed with the object. */
    class InputDescriptor
    {
    public:
      explicit InputDescriptor(const std::string &file)
        // Without O_NONBLOCK a FIFO blocks until somebody writes.
        : number(
            ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC))
      {
        if (number < 0)
          fail("opened", errno);
      }

      ~InputDescriptor()
      {
        close(number);
      }

      InputDescriptor(const InputDescriptor &)            = delete;
      InputDescriptor &operator=(const InputDescriptor &) = delete;

      void require_regular_file() const
      {
        struct stat status = {};
        if (fstat(number, &status) != 0)
          fail("read", errno);
        if (S_ISDIR(status.st_mode))
          fail("opened", EISDIR);
        if (!S_ISREG(status.st_mode))
          throw UnreadableFile{
            "cannot be opened (it is a pipe, socket or device)"};
      }

      std::size_t read_some(char *const buffer, const std::size_t size) const
      {
        ssize_t n = -1;
        do
          n = read(number, buffer, size);
        while (n < 0 && errno == EINTR);
        if (n < 0)
          fail("read", errno);
        return n;
      }

    private:
      const int number;
    };
  } // namespace

  std::string read_input_file(const std::string &file,
                              const std::size_t  most_bytes)
  {
    const InputDescriptor input(file);
    input.require_regular_file();
    std::string             content;
    std::array<char, 65536> buffer;
    while (const std::size_t n = input.read_some(buffer.data(), buffer.size()))
      {
        // The size that the system tells of a file need not be true.
        if (content.size() + n > most_bytes)
          throw UnreadableFile{"has more than " + std::to_string(most_bytes) +
                               " bytes"};
        content.append(buffer.data(), n);
      }
    return content;
  }
} // namespace auxfem
