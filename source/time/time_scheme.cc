#include <auxfem/time/time_scheme.h>

namespace auxfem
{
  TimeScheme::TimeScheme(const std::string &name) : scheme_name(name)
  {}
} // namespace auxfem
