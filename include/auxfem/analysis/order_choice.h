#ifndef auxfem_analysis_order_choice_h
#define auxfem_analysis_order_choice_h

#include <auxfem/analysis/mesh_error.h>

namespace auxfem
{
  /**
   * Orders and numbers of elements, strut by strut, with which the estimated
   * errors of all struts add up to no more than `Discretization/Tolerance`, and
   * as few unknowns as possible; what comes nearest where none are enough. The
   * motion that asks for them is that of a search run: the scene with one order
   * for all struts and fewer steps, which @p recorder is told of. Where the
   * errors of that are large, a second one has what the first found.
   * Collective. Throws InputError for a probe whose joints do not exist.
   */
  ChosenElements choose_elements(const RunPlan &plan,
                                 MPI_Comm       communicator,
                                 Recorder      &recorder);
} // namespace auxfem

#endif
