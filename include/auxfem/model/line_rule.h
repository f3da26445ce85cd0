#ifndef auxfem_model_line_rule_h
#define auxfem_model_line_rule_h

#include <vector>

namespace auxfem
{
  /** Shape functions of an element of polynomial order p, p not fixed when
   * compiled. */
  struct LineRule
  {
    explicit LineRule(unsigned int order);

    /** Integrals of the shape functions over [-1, 1]. */
    std::vector<double> integrals;
    /** Their nodes in [-1, 1]. */
    std::vector<double> nodes;
  };
} // namespace auxfem

#endif
