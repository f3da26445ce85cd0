#ifndef auxfem_analysis_guess_ahead_h
#define auxfem_analysis_guess_ahead_h

#include <auxfem/equations/evaluation.h>
#include <auxfem/model/lattice_model.h>
#include <auxfem/time/time_scheme.h>

namespace auxfem
{
  /**
   * Moves the guess for the end of @p step, which @p scheme has predicted to be
   * its start, on by unchanged accelerations, if the step is short for the
   * motion: velocities change by a small part of themselves. Else a guess ahead
   * would be further off. Collective.
   */
  void guess_ahead(const ImplicitScheme &scheme,
                   const Evaluation     &step,
                   const LatticeModel   &model);

  /**
   * Moves the guess for the end of a @p step without inertia, which @p scheme
   * has predicted to be its start, on by as much as the step before has moved
   * it, if that is known: what is linear does so while loads go on as they did.
   */
  void go_on_as_before(const ImplicitScheme &scheme, const Evaluation &step);
} // namespace auxfem

#endif
