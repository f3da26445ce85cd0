#ifndef auxfem_output_notes_h
#define auxfem_output_notes_h

#include <auxfem/equations/equations.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Notes on a valid scene that may be unintended: time scheme with rigid
   * parts, functions of time (time_function_notes()), sections too thick for
   * their struts, and struts that overlap at rest with contact. Texts for the
   * screen and summary.json.
   */
  std::vector<std::string> notes_on(const Equations &equations);
} // namespace auxfem

#endif
