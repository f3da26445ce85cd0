#ifndef auxfem_analysis_small_motions_root_count_h
#define auxfem_analysis_small_motions_root_count_h

#include <auxfem/analysis/small_motions/characteristic_equation.h>

#include <optional>

namespace auxfem
{
  /** Part of the complex plane that is its own mirror image, inner < |s| <
   * outer. */
  struct RootRegion
  {
    double inner, outer; ///< 1/s

    /** What has more, over the critical damping, relaxes. */
    static constexpr double ratio = 0.99;
    enum class Kind
    {
      swings_or_grows,
      relaxes
    };
    Kind kind = Kind::swings_or_grows;

    /** Least and largest argument above the real axis (rad). */
    ///@{
    double least_angle() const;
    double largest_angle() const;
    ///@}

    bool contains(std::complex<double> s) const;
  };

  /**
   * How many roots @p equation has in @p region, of two conjugate ones both, by
   * the argument of D(s) along its border (Cauchy); none where a root lies
   * on it. Collective.
   */
  std::optional<unsigned int> n_roots(CharacteristicEquation &equation,
                                      const RootRegion       &region);
} // namespace auxfem

#endif
