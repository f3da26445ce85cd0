#ifndef auxfem_struts_prony_fit_h
#define auxfem_struts_prony_fit_h

#include <map>
#include <vector>

namespace auxfem
{
  /** A measured modulus under harmonic strains. */
  struct MeasuredModulus
  {
    double frequency;     ///< angular (rad/s), > 0
    double storage, loss; ///< Pa, > 0
  };

  /** A Prony series fitted to measurements. */
  struct PronyFit
  {
    double                   instantaneous_modulus; ///< Pa
    std::map<double, double> parts; ///< of it, by relaxation time (s)
    /** Distance of the complex modulus from the measured one, over its size:
     * largest and root mean square. */
    double largest_error, rms_error;
    /** Angular frequency of the largest error (rad/s). */
    double worst_frequency;
  };

  /**
   * Fits a modulus that does not relax and the parts of Maxwell elements, all
   * >= 0, by least squares of relative errors. Half as many relaxation times
   * as frequencies cover these; parts that do not help are left out.
   */
  PronyFit fit_prony_series(const std::vector<MeasuredModulus> &measured);
} // namespace auxfem

#endif
