#ifndef auxfem_analysis_small_motions_root_count_h
#define auxfem_analysis_small_motions_root_count_h

#include <auxfem/analysis/small_motions/characteristic_equation.h>

#include <optional>

namespace auxfem
{
  /**
   * Part of the complex plane that is its own mirror image: inner < |s| <
   * outer, without what decays with more than a ratio of the critical damping,
   * where relaxations are and det A(s) has poles.
   */
  struct RootRegion
  {
    double inner, outer; ///< 1/s
    /** Largest ratio of damping. */
    static constexpr double ratio = 0.99;

    bool contains(std::complex<double> s) const;
  };

  /**
   * How many roots @p equation has in @p region, of two conjugate ones both, by
   * the argument of det A(s) along its border (Cauchy); none where a root lies
   * on it. Collective.
   */
  std::optional<unsigned int> n_roots(CharacteristicEquation &equation,
                                      const RootRegion       &region);
} // namespace auxfem

#endif
