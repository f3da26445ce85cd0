#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/text.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

#include <sys/resource.h>

namespace auxfem
{
  void Mistakes::add(const std::string &message)
  {
    messages.push_back(with_short_lines(message));
  }



  void Mistakes::throw_if_any(const std::string &file) const
  {
    // Mistakes of two or three lines each then fill a screen.
    constexpr std::size_t n_shown = 10;
    if (messages.empty())
      return;
    if (messages.size() == 1)
      throw InputError(messages.front());
    std::string text =
      file + " has " + std::to_string(messages.size()) + " mistakes:";
    for (std::size_t i = 0; i < std::min(n_shown, messages.size()); ++i)
      text += "\n" + messages[i];
    if (messages.size() > n_shown)
      text += "\n... and " + std::to_string(messages.size() - n_shown) +
        " more, shown once these are corrected";
    throw InputError(text);
  }

  std::string out_of_memory_text()
  {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const unsigned long mebibytes =
      usage.ru_maxrss >> 10; // ru_maxrss is in KiB
    return "out of memory on rank " +
      std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) +
      " of " +
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)) +
      ", which has had up to " + std::to_string(mebibytes) +
      " MiB in use.\nTake fewer cells, a lower Discretization/Order or fewer Global "
      "refinements; or provide more memory (see `ulimit -v` and the limits of the "
      "batch system), more ranks on more machines, or another Solver/Type.";
  }
} // namespace auxfem
