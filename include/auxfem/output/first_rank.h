#ifndef auxfem_output_first_rank_h
#define auxfem_output_first_rank_h

#include <auxfem/algebra/shared_work.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/time/interruption.h>

#include <deal.II/base/mpi.h>

#include <new>
#include <string>

namespace auxfem
{
  /**
   * Runs @p action on rank 0 of @p communicator only; if it throws, all ranks
   * throw the same (InputError, Interrupted, or ComputationError for all else),
   * so that none waits for another for ever; but std::bad_alloc is thrown on
   * rank 0 only. Collective.
   */
  template <typename Action>
  void on_first_rank(const MPI_Comm communicator, const Action &action)
  {
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
      {
        action();
        return;
      }

    enum Outcome : int
    {
      done,
      input_error,
      interrupted,
      computation_error
    };
    int         outcome = done;
    int         signal  = 0;
    std::string message;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          action();
        }
      catch (const InputError &error)
        {
          outcome = input_error;
          message = error.what();
        }
      catch (const Interrupted &interruption)
        {
          outcome = interrupted;
          signal  = interruption.signal();
        }
      catch (const std::bad_alloc &)
        {
          // main() ends the other ranks.
          throw;
        }
      catch (const std::exception &error)
        {
          outcome = computation_error;
          message = error.what();
        }

    outcome = dealii::Utilities::MPI::broadcast(communicator, outcome);
    if (outcome == done)
      return;
    if (outcome == interrupted)
      throw Interrupted(
        dealii::Utilities::MPI::broadcast(communicator, signal));
    message = text_of_rank(0, message, communicator);
    if (outcome == input_error)
      throw InputError(message);
    throw ComputationError(message);
  }
} // namespace auxfem

#endif
