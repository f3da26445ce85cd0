#ifndef auxfem_parameters_rounded_text_h
#define auxfem_parameters_rounded_text_h

#include <string>

namespace auxfem
{
  /**
   * @p value with @p digits significant digits for messages: without an
   * exponent between 1e-4 and 1e6, where digits before the point are all
   * written, and without the sign of a zero.
   */
  std::string rounded_text(double value, unsigned int digits = 3);

  /** @p part of one in percent, e.g. `12 %`. */
  std::string percentage_text(double part, unsigned int digits = 2);
} // namespace auxfem

#endif
