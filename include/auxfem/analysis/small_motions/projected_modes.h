#ifndef auxfem_analysis_small_motions_projected_modes_h
#define auxfem_analysis_small_motions_projected_modes_h

#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/analysis/small_motions/natural_modes.h>

namespace auxfem
{
  /** A solution of V^T A(s) V y = 0, with the shapes of modes as columns of V.
   */
  struct ProjectedMode
  {
    std::complex<double> s; ///< 1/s; of two conjugate ones that above
    /** y, of unit length. */
    std::vector<std::complex<double>> parts;
  };

  /**
   * Those that swing among the motions that @p modes make with damping, by rising
   * |s|: all at once, each root of det(V^T A(s) V) repelled by the others
   * (Aberth 1973), so that none is found twice. What does not converge is left
   * out. Collective.
   */
  std::vector<ProjectedMode>
  projected_modes(DynamicStiffness               &stiffness,
                  const UnknownLayout            &layout,
                  const std::vector<NaturalMode> &modes);
} // namespace auxfem

#endif
