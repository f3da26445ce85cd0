#include <auxfem/time/time_scheme.h>

namespace auxfem
{
  TimeScheme::TimeScheme(const std::string &name) : scheme_name(name)
  {}

  const std::string &TimeScheme::name() const
  {
    return scheme_name;
  }

  bool TimeScheme::is_dynamic() const
  {
    return true;
  }

  std::optional<std::string> TimeScheme::note_on_rigid_parts() const
  {
    return {};
  }

  bool ImplicitScheme::balances_means() const
  {
    return false;
  }

  double ImplicitScheme::high_frequency_damping() const
  {
    return 0;
  }

  bool ImplicitScheme::carries_on_alternating_errors() const
  {
    return false;
  }

  bool ImplicitScheme::keeps_massless_in_equilibrium() const
  {
    return false;
  }

  std::optional<double> ImplicitScheme::error_constant() const
  {
    return {};
  }

  double ImplicitScheme::amplification(const double /*angle*/) const
  {
    return 1;
  }

  double ImplicitScheme::missed_way(const double by_trapezoidal_rule) const
  {
    return by_trapezoidal_rule;
  }

  unsigned int ImplicitScheme::order() const
  {
    return 2;
  }

  const ButcherTableau *ImplicitScheme::stages() const
  {
    return nullptr;
  }

  bool ImplicitScheme::uses_algorithmic_acceleration() const
  {
    return false;
  }
} // namespace auxfem
