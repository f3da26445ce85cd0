#include <auxfem/time/time_scheme.h>

namespace auxfem
{
  TimeScheme::TimeScheme(const std::string &name) : scheme_name(name)
  {}

  double ImplicitScheme::amplification(const double /*angle*/) const
  {
    return 1;
  }
} // namespace auxfem
