#ifndef auxfem_parameters_errors_h
#define auxfem_parameters_errors_h

#include <stdexcept>
#include <string>
#include <vector>

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

  /** Gathers the user's mistakes, to report them all at once. */
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
     * Throws InputError with all messages if there is any; of very many, the
     * first ones and a count, so that a screen holds them. @p file is named in
     * the heading.
     */
    void throw_if_any(const std::string &file) const;

  private:
    std::vector<std::string> messages;
  };

  /**
   * What the user is told when this rank got no more memory from the operating
   * system: which rank, what it had in use at most, what can be done.
   */
  std::string out_of_memory_text();
} // namespace auxfem

#endif
