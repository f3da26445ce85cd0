#ifndef auxfem_parameters_errors_h
#define auxfem_parameters_errors_h

#include <stdexcept>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * A mistake in the user's input: parameter file, table, command line or an
   * unsupported structure. The message is complete (place, problem, allowed
   * values, remedy) and shown unchanged. Exit code 1.
   */
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::string &message)
      : std::runtime_error(message)
    {}
  };

  /**
   * A computation that failed: no convergence at the smallest step, non-finite
   * numbers, a singular tangent. Results computed before are on disk when it
   * reaches main(). Exit code 2.
   */
  class ComputationError : public std::runtime_error
  {
  public:
    explicit ComputationError(const std::string &message)
      : std::runtime_error(message)
    {}
  };

  /** Collects the user's mistakes to report them together. */
  class Mistakes
  {
  public:
    /** Adds one complete message. */
    void add(const std::string &message);

    bool empty() const
    {
      return messages.empty();
    }

    /**
     * Throws InputError with all messages if there are any. The heading names
     * @p file. A long list is cut to the first messages and a count, so that it
     * fits on a screen.
     */
    void throw_if_any(const std::string &file) const;

  private:
    std::vector<std::string> messages;
  };

  /**
   * Message for a failed memory allocation: rank, peak memory in use, remedies.
   */
  std::string out_of_memory_text();
} // namespace auxfem

#endif
