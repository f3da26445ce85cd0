#include <auxfem/time/schemes/time_scheme.h>

#include <algorithm>

namespace auxfem
{
  TimeScheme::TimeScheme(const std::string &name) : scheme_name(name)
  {}

  const std::vector<TimeSchemeEntry> &time_scheme_registry()
  {
    static const std::vector<TimeSchemeEntry> registry = {
      newmark_entry(),
      hht_entry(),
      generalized_alpha_entry(),
      energy_momentum_entry(),
      esdirk_entry(),
      static_entry(),
      central_difference_entry(),
      as_printed_entry(),
      arkode_entry()};
    return registry;
  }

  bool TimeSchemeEntry::serves(const Model model) const
  {
    return std::find(models.begin(), models.end(), model) != models.end();
  }

  const TimeSchemeEntry &time_scheme_entry(const std::string &name)
  {
    return find_entry(time_scheme_registry(), name);
  }

  std::shared_ptr<const TimeScheme> default_time_scheme()
  {
    const TimeSchemeEntry &entry = time_scheme_registry().front();
    ParameterValues        values(entry.parameters);
    return entry.make(values);
  }
} // namespace auxfem
