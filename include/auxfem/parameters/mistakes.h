#ifndef auxfem_parameters_mistakes_h
#define auxfem_parameters_mistakes_h

#include <string>
#include <vector>

namespace auxfem
{
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
} // namespace auxfem

#endif
