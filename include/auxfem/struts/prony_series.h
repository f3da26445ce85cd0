#ifndef auxfem_struts_prony_series_h
#define auxfem_struts_prony_series_h

#include <auxfem/mathematics/maxwell_element.h>

#include <map>
#include <vector>

namespace auxfem
{
  /**
   * Prony series of a modulus over its instantaneous value: a spring in
   * parallel with Maxwell elements. The viscoelastic section law uses it.
   */
  struct PronySeries
  {
    /** Maxwell element of the modulus. */
    struct Term
    {
      double ratio; ///< stiffness over the instantaneous modulus
      double time;  ///< relaxation time (s)

      /** With unit stiffness: forces are the strain of its spring. */
      MaxwellElement element() const
      {
        return {1, time};
      }
    };

    double            long_time; ///< part that does not relax
    std::vector<Term> terms;     ///< by ascending time
  };

  /** Series of relaxing @p parts by relaxation time (s), at most 1 together. */
  PronySeries prony_series(const std::map<double, double> &parts);

  /**
   * Series of Young's modulus E = 9 K G / (3 K + G) with the elastic bulk
   * modulus
   * K and the @p shear series of G. The relaxation times T = -1/s belong to the
   * roots s of G(s) = -3 K, one below each rate of G; the residues of E there
   * are
   * the terms 27 K^2 T / G'(s). It has as many terms as @p shear, by descending
   * time.
   * @param poissons_ratio instantaneous, less than 1/2
   */
  PronySeries series_of_youngs_modulus(const PronySeries &shear,
                                       double             poissons_ratio);
} // namespace auxfem

#endif
