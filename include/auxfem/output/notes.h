#ifndef auxfem_output_notes_h
#define auxfem_output_notes_h

#include <auxfem/equations/equations.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * What the user should know of a scene that is allowed, but may not be what
   * was meant: of the time scheme with rigid parts, functions of time
   * (time_function_notes()), sections too thick for their struts and, with
   * contact, struts that overlap at rest. A text each, for the screen and
   * summary.json.
   */
  std::vector<std::string> notes_on(const Equations &equations);
} // namespace auxfem

#endif
