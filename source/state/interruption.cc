#include <auxfem/state/interruption.h>

#include <cstring>
#include <string>

namespace auxfem
{
  namespace
  {
    /** The first one noted; 0: none. */
    volatile std::sig_atomic_t noted = 0;

    void note(const int signal)
    {
      if (noted == 0)
        noted = signal;
    }
  } // namespace

  Interrupted::Interrupted(const int signal)
    : ComputationError("ended by signal " + std::to_string(signal) + " (" +
                       strsignal(signal) + ")")
    , number(signal)
  {}

  SignalsWaitForStep::SignalsWaitForStep()
  {
    noted                   = 0;
    struct sigaction action = {};
    action.sa_handler       = note;
    // The second one finds the default action; calls of libraries go on.
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (unsigned int i = 0; i < signals.size(); ++i)
      {
        sigaction(signals[i], nullptr, &former[i]);
        if (former[i].sa_handler != SIG_IGN)
          sigaction(signals[i], &action, nullptr);
      }
  }

  SignalsWaitForStep::~SignalsWaitForStep()
  {
    for (unsigned int i = 0; i < signals.size(); ++i)
      sigaction(signals[i], &former[i], nullptr);
  }

  int noted_signal(const MPI_Comm communicator)
  {
    int signal = noted;
    MPI_Allreduce(MPI_IN_PLACE, &signal, 1, MPI_INT, MPI_MAX, communicator);
    return signal;
  }

  void end_if_interrupted(const MPI_Comm communicator)
  {
    if (const int signal = noted_signal(communicator); signal != 0)
      throw Interrupted(signal);
  }
} // namespace auxfem
