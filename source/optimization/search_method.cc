#include <auxfem/optimization/search_method.h>
#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/registry.h>

namespace auxfem
{
  const std::vector<SearchMethod> &search_methods()
  {
    static const std::vector<SearchMethod> methods = {
      {"COBYLA", nlopt::LN_COBYLA, nlopt::LN_COBYLA},
      // With a single variable its quadratic model has too few points.
      {"BOBYQA", nlopt::LN_BOBYQA, nlopt::AUGLAG, false, 2},
      {"Subplex", nlopt::LN_SBPLX, nlopt::AUGLAG},
      {"DIRECT-L", nlopt::GN_DIRECT_L, nlopt::GN_ORIG_DIRECT_L, true},
      {"CRS", nlopt::GN_CRS2_LM, nlopt::GN_ISRES, true},
      {"MMA", nlopt::LD_MMA, nlopt::LD_MMA},
      {"SLSQP", nlopt::LD_SLSQP, nlopt::LD_SLSQP}};
    return methods;
  }

  namespace
  {
    const SearchMethod &method_called(const std::string &name)
    {
      const SearchMethod *method = find_by_name(search_methods(), name);
      if (method != nullptr)
        return *method;
      const std::vector<std::string> known = names_of(search_methods());
      throw InputError("Optimization/Method: \"" + name + "\" is no method" +
                       did_you_mean(name, known) + " Allowed: auto, " +
                       joined(known));
    }
  } // namespace

  std::vector<SearchMethod>
  chosen_methods(const OptimizationDefinition &optimization,
                 const bool                    has_constraints)
  {
    const std::size_t n = optimization.variables.size();
    if (optimization.methods.empty())
      return {method_called(has_constraints || n == 1 ? "COBYLA" : "BOBYQA")};
    std::vector<SearchMethod> methods;
    for (const std::string &name : optimization.methods)
      {
        methods.push_back(method_called(name));
        if (n < methods.back().least_variables)
          throw InputError("Optimization/Method = " + name +
                           ": this method needs at least " +
                           std::to_string(methods.back().least_variables) +
                           " design variables. Allowed with " +
                           std::to_string(n) + ": COBYLA, Subplex, DIRECT-L");
      }
    return methods;
  }

  nlopt::opt make_optimizer(const SearchMethod &method,
                            const unsigned int  n,
                            const SearchSteps  &steps,
                            const bool          has_constraints)
  {
    const auto in_unit_cube = [&](const nlopt::algorithm algorithm) {
      nlopt::opt optimizer(algorithm, n);
      optimizer.set_lower_bounds(0.);
      optimizer.set_upper_bounds(1.);
      if (!method.is_global)
        {
          optimizer.set_xtol_abs(steps.tolerance);
          optimizer.set_initial_step(steps.first);
        }
      return optimizer;
    };
    if (!has_constraints)
      return in_unit_cube(method.algorithm);
    nlopt::opt optimizer = in_unit_cube(method.with_constraints);
    if (method.with_constraints == nlopt::AUGLAG)
      optimizer.set_local_optimizer(in_unit_cube(method.algorithm));
    return optimizer;
  }
} // namespace auxfem
