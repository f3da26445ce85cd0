#include <auxfem/mesh/cells/separate_process.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace auxfem
{
  namespace
  {
    void leave()
    {
      _exit(1);
    }

    void write_all(const int pipe, const std::string &text)
    {
      for (std::size_t done = 0; done < text.size();)
        {
          const ssize_t n = write(pipe, text.data() + done, text.size() - done);
          if (n < 0 && errno != EINTR)
            leave();
          done += n < 0 ? 0 : n;
        }
    }

    std::string read_all(const int pipe)
    {
      std::string             text;
      std::array<char, 65536> buffer;
      while (true)
        {
          const ssize_t n = read(pipe, buffer.data(), buffer.size());
          if (n > 0)
            text.append(buffer.data(), n);
          else if (n == 0 || errno != EINTR)
            return text;
        }
    }

    /** Nothing of the copy's end is to be seen or done by what the original has
     * prepared for its own. */
    void prepare_to_crash()
    {
      for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGILL})
        std::signal(signal, SIG_DFL);
      const rlimit no_core = {0, 0};
      setrlimit(RLIMIT_CORE, &no_core);
      // Registered last, called first.
      std::atexit(leave);
      const int nowhere = open("/dev/null", O_RDWR);
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        dup2(nowhere, stream);
    }

    std::string how_ended(const int status)
    {
      if (WIFSIGNALED(status))
        return strsignal(WTERMSIG(status));
      return "exit code " + std::to_string(WEXITSTATUS(status));
    }
  } // namespace

  std::string
  run_in_separate_process(const std::function<std::string()> &action)
  {
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
      throw std::bad_alloc();
    const pid_t child = fork();
    if (child == 0)
      {
        close(ends[0]);
        prepare_to_crash();
        write_all(ends[1], action());
        _exit(0);
      }
    close(ends[1]);
    if (child < 0)
      {
        close(ends[0]);
        throw std::bad_alloc();
      }
    const std::string text = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
      ;
    if (status != 0)
      throw CrashedProcess{how_ended(status)};
    return text;
  }
} // namespace auxfem
