#ifndef auxfem_analysis_small_motions_complex_shape_h
#define auxfem_analysis_small_motions_complex_shape_h

#include <auxfem/algebra/unknown_layout.h>

#include <complex>
#include <vector>

namespace auxfem
{
  /** @name Complex values of owned rows: real parts, then imaginary ones. All of
   * these are collective. */
  ///@{

  /** x.y, without conjugation. */
  std::complex<double> product(const UnknownLayout       &layout,
                               const std::vector<double> &x,
                               const std::vector<double> &y);

  /** Square root of the sum of the squared magnitudes. */
  double size(const UnknownLayout &layout, const std::vector<double> &x);

  /** Whether two shapes are one but for a complex factor. */
  bool are_parallel(const UnknownLayout       &layout,
                    const std::vector<double> &x,
                    const std::vector<double> &y);

  /** Makes the real part of @p shape as large as can be; its length is kept. */
  void turn_phase(const UnknownLayout &layout, std::vector<double> &shape);
  ///@}
} // namespace auxfem

#endif
