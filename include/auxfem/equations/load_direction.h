#ifndef auxfem_equations_load_direction_h
#define auxfem_equations_load_direction_h

#include <auxfem/equations/equations.h>

namespace auxfem
{
  /**
   * Loads in free rows (N, N m) and motions of supports in prescribed ones, of
   * local unknowns, by which both grow with the load factor at evaluation.to.
   */
  Vector load_direction(const Equations  &equations,
                        const Evaluation &evaluation);
} // namespace auxfem

#endif
