#ifndef auxfem_analysis_small_motions_mode_errors_h
#define auxfem_analysis_small_motions_mode_errors_h

#include <auxfem/analysis/small_motions/buckling_modes.h>
#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/mesh_error_estimate.h>
#include <auxfem/analysis/small_motions/natural_modes.h>

namespace auxfem
{
  /**
   * Compares the modes of @p run with those of finer elements and stores the
   * error of each: relative to its frequency or factor; |change of s| over |s|
   * for complex and damped modes. Collective.
   */
  ///@{
  MeshErrors estimate_errors(LatticeRun &run, NaturalModes &found);
  MeshErrors estimate_errors(LatticeRun &run, ComplexModes &found);
  MeshErrors estimate_errors(LatticeRun &run, BucklingModes &found);
  ///@}
} // namespace auxfem

#endif
