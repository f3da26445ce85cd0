#ifndef auxfem_parameters_suggest_h
#define auxfem_parameters_suggest_h

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Those of @p known that a user may have meant by @p name, at most three, the
   * nearest first: by the number of letters inserted, deleted, replaced or
   * swapped with their neighbour, ignoring case. Names that differ in more than
   * a third of their letters are left out, unless one begins with the other.
   */
  std::vector<std::string> nearest_names(const std::string              &name,
                                         const std::vector<std::string> &known);

  /**
   * The end of a sentence about an unknown @p name: `; did you mean "a" or
   * "b"?` with nearest_names(), a full stop if there is none.
   */
  std::string did_you_mean(const std::string              &name,
                           const std::vector<std::string> &known);
} // namespace auxfem

#endif
