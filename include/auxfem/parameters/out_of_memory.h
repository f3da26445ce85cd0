#ifndef auxfem_parameters_out_of_memory_h
#define auxfem_parameters_out_of_memory_h

#include <string>

namespace auxfem
{
  /**
   * What the user is told when this rank got no more memory from the operating
   * system: which rank, what it had in use at most, what can be done.
   */
  std::string out_of_memory_text();
} // namespace auxfem

#endif
