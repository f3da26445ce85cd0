#ifndef auxfem_optimization_search_method_h
#define auxfem_optimization_search_method_h

#include <auxfem/scene/optimization_definition.h>

#include <string>
#include <vector>

#include <nlopt.hpp>

namespace auxfem
{
  /** A method of the library NLopt. */
  struct SearchMethod
  {
    std::string      name; ///< in Optimization/Method
    nlopt::algorithm algorithm;
    /** Method for problems with constraints; AUGLAG: the augmented Lagrangian
     * around `algorithm`. */
    nlopt::algorithm with_constraints;
    bool             is_global       = false;
    unsigned int     least_variables = 1;
  };

  /** All methods. */
  const std::vector<SearchMethod> &search_methods();

  /**
   * Methods of a search, in their order. Throws InputError for an unknown name
   * and for a method that needs more variables.
   * @param has_constraints whether results are limited
   */
  std::vector<SearchMethod>
  chosen_methods(const OptimizationDefinition &optimization,
                 bool                          has_constraints);

  /** When and how local methods begin and end, as parts of the ranges. */
  struct SearchSteps
  {
    double first, tolerance;
  };

  /** NLopt's object for @p method in the unit cube of @p n variables. */
  nlopt::opt make_optimizer(const SearchMethod &method,
                            unsigned int        n,
                            const SearchSteps  &steps,
                            bool                has_constraints);
} // namespace auxfem

#endif
