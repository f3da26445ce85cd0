#include <auxfem/mesh/cells/gmsh_reader.h>
#include <auxfem/mesh/cells/line_mesh.h>
#include <auxfem/parameters/parameter_file.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>

#include <fcntl.h>
#include <gmsh.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace auxfem
{
  namespace
  {
    using Clock = std::chrono::steady_clock;

    void exit_child()
    {
      _exit(1);
    }

    void write_all(const int pipe, const std::string &text)
    {
      for (std::size_t done = 0; done < text.size();)
        {
          const ssize_t n = write(pipe, text.data() + done, text.size() - done);
          if (n < 0 && errno != EINTR)
            exit_child();
          done += n < 0 ? 0 : n;
        }
    }

    /** Time left of @p seconds since @p start, for poll() (ms); -1 if there is
     * no limit. */
    int remaining_milliseconds(const Clock::time_point start,
                               const double            seconds)
    {
      if (!std::isfinite(seconds))
        return -1;
      const std::chrono::duration<double> passed  = Clock::now() - start;
      constexpr double                    longest = 1e6;
      return static_cast<int>(
        std::clamp(std::ceil(1000 * (seconds - passed.count())), 0., longest));
    }

    /** Appends to @p text until the other end closes; false if it does not
     * within @p seconds. */
    bool read_all(const int pipe, const double seconds, std::string &text)
    {
      const Clock::time_point start = Clock::now();
      std::array<char, 65536> buffer;
      while (true)
        {
          pollfd    waiting = {pipe, POLLIN, 0};
          const int timeout = remaining_milliseconds(start, seconds);
          const int ready   = poll(&waiting, 1, timeout);
          if (ready == 0 && remaining_milliseconds(start, seconds) == 0)
            return false;
          if (ready <= 0)
            continue;
          const ssize_t n = read(pipe, buffer.data(), buffer.size());
          if (n > 0)
            text.append(buffer.data(), n);
          else if (n == 0 || errno != EINTR)
            return true;
        }
    }

    void kill_process_group(int)
    {
      kill(0, SIGKILL);
    }

    /** Makes this process and its children end when @p parent ends. */
    void end_with_parent(const pid_t parent)
    {
      setpgid(0, 0);
      std::signal(SIGTERM, kill_process_group);
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      // The parent may have ended before prctl().
      if (getppid() != parent)
        exit_child();
    }

    /** Address space of this process (bytes). */
    rlim_t address_space()
    {
      rlim_t pages = 0;
      std::ifstream("/proc/self/statm") >> pages;
      return pages * sysconf(_SC_PAGESIZE);
    }

    void set_limits(const ProcessLimits &limits)
    {
      const rlimit no_core = {0, 0};
      setrlimit(RLIMIT_CORE, &no_core);
      if (std::isfinite(limits.seconds))
        {
          const rlim_t seconds = std::ceil(limits.seconds);
          const rlimit cpu     = {seconds, seconds + 1};
          setrlimit(RLIMIT_CPU, &cpu);
        }
      if (limits.memory > 0)
        {
          const rlim_t bytes = address_space() + limits.memory;
          const rlimit space = {bytes, bytes};
          setrlimit(RLIMIT_AS, &space);
        }
    }

    /** Removes signal and exit handlers of the original process and silences
     * the copy. */
    void prepare_to_crash()
    {
      for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGILL})
        std::signal(signal, SIG_DFL);
      // Registered last, this handler runs first and skips the others.
      std::atexit(exit_child);
      const int nowhere = open("/dev/null", O_RDWR);
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        dup2(nowhere, stream);
    }

    std::string timeout_text(const double seconds)
    {
      std::ostringstream text;
      text << "no end after " << seconds << " s";
      return text.str();
    }

    CrashedProcess crash_report(const int status, const double seconds)
    {
      if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return {timeout_text(seconds), true};
      if (WIFSIGNALED(status))
        return {strsignal(WTERMSIG(status))};
      return {"exit code " + std::to_string(WEXITSTATUS(status))};
    }
  } // namespace

  std::string
  run_in_separate_process(const std::function<std::string()> &action,
                          const ProcessLimits                &limits)
  {
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
      throw std::bad_alloc();
    const pid_t parent = getpid();
    const pid_t child  = fork();
    if (child == 0)
      {
        close(ends[0]);
        end_with_parent(parent);
        prepare_to_crash();
        set_limits(limits);
        write_all(ends[1], action());
        _exit(0);
      }
    close(ends[1]);
    if (child < 0)
      {
        close(ends[0]);
        throw std::bad_alloc();
      }
    // The child does the same; the group must exist in both before it is used.
    setpgid(child, child);
    std::string text;
    const bool  is_in_time = read_all(ends[0], limits.seconds, text);
    close(ends[0]);
    int status = 0;
    if (!is_in_time)
      kill(-child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
      ;
    // Ends children that the process did not wait for.
    kill(-child, SIGKILL);
    if (!is_in_time)
      throw CrashedProcess{timeout_text(limits.seconds), true};
    if (status != 0)
      throw crash_report(status, limits.seconds);
    return text;
  }

  namespace
  {
    namespace fs = std::filesystem;

    /** Memory limit of gmsh for a mesh of curves (bytes). */
    constexpr std::size_t memory_limit = std::size_t(4) << 30;

    /** Beginnings of files in formats that gmsh recognizes by their ending. */
    const std::map<std::string, std::string> beginnings = {
      {".vtk", "# vtk DataFile"},
      {".unv", "    -1"},
      {".mesh", "MeshVersionFormatted"}};

    /** A temporary folder with access for this user only; removed with the
     * object. */
    class PrivateFolder
    {
    public:
      PrivateFolder()
        : path((fs::temp_directory_path() / "auxfem_XXXXXX").string())
      {
        if (mkdtemp(path.data()) == nullptr)
          throw MeshMistake{"cannot make the temporary folder " + path +
                            " for its mesh"};
      }

      ~PrivateFolder()
      {
        std::error_code ignored;
        fs::remove_all(path, ignored);
      }

      PrivateFolder(const PrivateFolder &)            = delete;
      PrivateFolder &operator=(const PrivateFolder &) = delete;

      std::string file(const std::string &name) const
      {
        return path + "/" + name;
      }

    private:
      std::string path;
    };

    /** Initialized gmsh library that writes messages to a log only. */
    class GmshSession
    {
    public:
      GmshSession()
      {
        // The user's own gmsh settings are not read: a scene must give the same
        // lattice everywhere.
        gmsh::initialize(0, nullptr, false);
        gmsh::option::setNumber("General.Terminal", 0);
        // By default gmsh leaves its parser by an exception.
        gmsh::option::setNumber("General.AbortOnError", 0);
        gmsh::logger::start();
      }

      ~GmshSession()
      {
        gmsh::logger::stop();
        gmsh::finalize();
      }

      GmshSession(const GmshSession &)            = delete;
      GmshSession &operator=(const GmshSession &) = delete;

      /** The first three of gmsh's error messages; empty if there are none. */
      std::string errors() const
      {
        const std::string        mark = "Error: ";
        std::vector<std::string> log;
        gmsh::logger::get(log);
        std::string  text;
        unsigned int n_shown = 0;
        for (const auto &message : log)
          if (message.compare(0, mark.size(), mark) == 0 && n_shown++ < 3)
            text += (text.empty() ? "" : "\n  ") + message.substr(mark.size());
        return text;
      }
    };

    /** Meshes the curves of @p file into @p result; returns gmsh's errors. */
    std::string mesh_curves(const std::string &file, const std::string &result)
    {
      try
        {
          const GmshSession session;
          gmsh::open(file);
          std::vector<std::size_t> nodes;
          std::vector<double>      coordinates, unused;
          gmsh::model::mesh::getNodes(nodes, coordinates, unused);
          // After errors of the parser, meshing would only add further ones.
          if (nodes.empty() && session.errors().empty())
            gmsh::model::mesh::generate(1);
          gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
          // Text would lose the last digit of coordinates.
          gmsh::option::setNumber("Mesh.Binary", 1);
          // Lines outside of all groups are struts, too.
          gmsh::option::setNumber("Mesh.SaveAll", 1);
          gmsh::write(result);
          return session.errors();
        }
      catch (const std::bad_alloc &)
        {
          return "gmsh needs more memory than the " +
            std::to_string(memory_limit >> 30) + " GB that it may use";
        }
      catch (const std::exception &error)
        {
          return error.what();
        }
      catch (const std::string &message)
        {
          return message;
        }
    }

    LineMesh mesh_of_curves(const std::string   &file,
                            const PrivateFolder &folder,
                            const double         seconds)
    {
      const std::string result = folder.file("result.msh");
      std::string       errors;
      try
        {
          errors =
            run_in_separate_process([&]() { return mesh_curves(file, result); },
                                    {seconds, memory_limit});
        }
      catch (const CrashedProcess &crash)
        {
          errors = "gmsh has failed: " + crash.reason +
            (crash.is_out_of_time ? ", the Gmsh time limit" : "");
        }
      if (!errors.empty())
        throw MeshMistake{errors};
      try
        {
          return read_msh(read_input_file(result));
        }
      catch (const UnreadableFile &unreadable)
        {
          throw MeshMistake{"its mesh " + unreadable.reason};
        }
    }
  } // namespace

  LineMesh run_gmsh_script(const std::string &file, const double seconds)
  {
    return mesh_of_curves(file, PrivateFolder(), seconds);
  }

  bool gmsh_can_read(const std::string &ending)
  {
    return beginnings.count(ending) > 0;
  }

  LineMesh read_with_gmsh(const std::string &content,
                          const std::string &ending,
                          const double       seconds)
  {
    const std::string &beginning = beginnings.at(ending);
    if (content.compare(0, beginning.size(), beginning) != 0)
      throw MeshMistake{"the file does not begin with \"" + beginning + "\""};
    // gmsh would run a script FILE.opt beside the file: it gets a copy in an
    // empty folder.
    const PrivateFolder folder;
    const std::string   copy = folder.file("mesh" + ending);
    std::ofstream(copy, std::ios::binary) << content;
    return mesh_of_curves(copy, folder, seconds);
  }
} // namespace auxfem
