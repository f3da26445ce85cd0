#ifndef auxfem_state_interruption_h
#define auxfem_state_interruption_h

#include <auxfem/parameters/errors.h>

#include <mpi.h>

#include <array>
#include <csignal>

namespace auxfem
{
  /**
   * A signal ends the run before its end time; all results so far are on disk.
   * Exit code 128 + signal.
   */
  class Interrupted : public ComputationError
  {
  public:
    explicit Interrupted(int signal);

    int signal() const
    {
      return number;
    }

  private:
    int number;
  };

  /**
   * Defers SIGTERM and SIGINT to pending_signal() during its lifetime. A second
   * signal of a kind ends the process at once; ignored signals stay ignored.
   * Objects within the lifetime of another one have no effect.
   */
  class DeferredSignals
  {
  public:
    DeferredSignals();
    ~DeferredSignals();

    DeferredSignals(const DeferredSignals &)            = delete;
    DeferredSignals &operator=(const DeferredSignals &) = delete;

  private:
    static constexpr std::array<int, 2> signals = {{SIGTERM, SIGINT}};

    const bool                                   is_outermost;
    std::array<struct sigaction, signals.size()> former;
  };

  /** Deferred signal of any rank; 0: none. Collective. */
  int pending_signal(MPI_Comm communicator);

  /** Throws Interrupted on all ranks if a signal is pending. Collective. */
  void end_if_interrupted(MPI_Comm communicator);
} // namespace auxfem

#endif
