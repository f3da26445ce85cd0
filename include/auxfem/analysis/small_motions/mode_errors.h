#ifndef auxfem_analysis_small_motions_mode_errors_h
#define auxfem_analysis_small_motions_mode_errors_h

#include <auxfem/analysis/small_motions/buckling_modes.h>
#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/mesh_choice.h>
#include <auxfem/analysis/small_motions/natural_modes.h>

namespace auxfem
{
  /**
   * Compares the modes that @p run has found with those of finer elements, and
   * enters the error of each: relative to its frequency or factor, of complex
   * and damped modes |change of s| over |s|. Collective.
   */
  ///@{
  MeshErrors estimate_errors(LatticeRun &run, NaturalModes &found);
  MeshErrors estimate_errors(LatticeRun &run, ComplexModes &found);
  MeshErrors estimate_errors(LatticeRun &run, BucklingModes &found);
  ///@}
} // namespace auxfem

#endif
