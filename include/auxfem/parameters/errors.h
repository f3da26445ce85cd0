#ifndef auxfem_parameters_errors_h
#define auxfem_parameters_errors_h

#include <stdexcept>
#include <string>

namespace auxfem
{
  /**
   * A mistake in what the user gave: a parameter file, a table, a command line,
   * a structure that cannot stand. The message is complete (where, what was
   * found, what is allowed, what to do) and is shown as it is. Exit code 1.
   */
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::string &message)
      : std::runtime_error(message)
    {}
  };

  /**
   * A computation that could not be completed (no convergence at the smallest
   * step, non-finite numbers, a singular tangent). Everything computed until
   * then is on disk when it reaches main(). Exit code 2.
   */
  class ComputationError : public std::runtime_error
  {
  public:
    explicit ComputationError(const std::string &message)
      : std::runtime_error(message)
    {}
  };
} // namespace auxfem

#endif
