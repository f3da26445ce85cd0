#ifndef auxfem_state_interruption_h
#define auxfem_state_interruption_h

#include <auxfem/parameters/errors.h>

#include <mpi.h>

#include <array>
#include <csignal>

namespace auxfem
{
  /**
   * A signal has asked the run to end before its end time. Everything computed
   * until then is on disk when it reaches main(). Exit code 128 + signal.
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
   * While an object lives, SIGTERM and SIGINT are noted for noted_signal() and
   * do not end the process; but the second one of a
   * kind does, at once. A signal that the process ignores stays ignored. One
   * object at a time.
   */
  class SignalsWaitForStep
  {
  public:
    SignalsWaitForStep();
    ~SignalsWaitForStep();

    SignalsWaitForStep(const SignalsWaitForStep &)            = delete;
    SignalsWaitForStep &operator=(const SignalsWaitForStep &) = delete;

  private:
    static constexpr std::array<int, 2> signals = {{SIGTERM, SIGINT}};

    std::array<struct sigaction, signals.size()> former;
  };

  /** A signal that one of the ranks has noted; 0: none. Collective. */
  int noted_signal(MPI_Comm communicator);

  /** Throws Interrupted on all ranks if there is one. Collective. */
  void end_if_interrupted(MPI_Comm communicator);
} // namespace auxfem

#endif
