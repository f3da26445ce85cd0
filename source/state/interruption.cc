#include <auxfem/state/interruption.h>

#include <cstring>
#include <string>

namespace auxfem
{
  namespace
  {
    /** The first deferred signal; 0: none. */
    volatile std::sig_atomic_t deferred_signal = 0;

    /** Number of DeferredSignals. */
    unsigned int n_objects = 0;

    void defer_signal(const int signal)
    {
      if (deferred_signal == 0)
        deferred_signal = signal;
    }
  } // namespace

  Interrupted::Interrupted(const int signal)
    : ComputationError("ended by signal " + std::to_string(signal) + " (" +
                       strsignal(signal) + ")")
    , number(signal)
  {}

  DeferredSignals::DeferredSignals() : is_outermost(n_objects++ == 0), former()
  {
    if (!is_outermost)
      return;
    deferred_signal         = 0;
    struct sigaction action = {};
    action.sa_handler       = defer_signal;
    // A second signal meets the default action; interrupted system calls
    // restart.
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (unsigned int i = 0; i < signals.size(); ++i)
      {
        sigaction(signals[i], nullptr, &former[i]);
        if (former[i].sa_handler != SIG_IGN)
          sigaction(signals[i], &action, nullptr);
      }
  }

  DeferredSignals::~DeferredSignals()
  {
    --n_objects;
    if (!is_outermost)
      return;
    for (unsigned int i = 0; i < signals.size(); ++i)
      sigaction(signals[i], &former[i], nullptr);
  }

  int pending_signal(const MPI_Comm communicator)
  {
    int signal = deferred_signal;
    MPI_Allreduce(MPI_IN_PLACE, &signal, 1, MPI_INT, MPI_MAX, communicator);
    return signal;
  }

  void end_if_interrupted(const MPI_Comm communicator)
  {
    if (const int signal = pending_signal(communicator); signal != 0)
      throw Interrupted(signal);
  }
} // namespace auxfem
