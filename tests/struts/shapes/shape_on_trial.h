#ifndef auxfem_tests_struts_shapes_shape_on_trial_h
#define auxfem_tests_struts_shapes_shape_on_trial_h

#include <auxfem/struts/shapes/cross_section.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace auxfem::testing_support
{
  using Entries = std::vector<std::pair<std::string, std::string>>;

  /** The section that a user gets in `Sections/s` with these entries. */
  inline CrossSection shape(const std::string &name, const Entries &entries)
  {
    const auto  &entry = find_entry(cross_section_registry(), name);
    SceneContext context;
    context.path = "Sections/s";
    ParameterValues values(entry.parameters, context);
    for (const auto &[parameter, text] : entries)
      values.set(parameter, text);
    return *entry.make(values);
  }

  /** Whether @p value is @p published to its @p digits significant digits, but
   * for the chords of fillets. */
  inline bool
  agrees(const double value, const double published, const int digits)
  {
    const double unit =
      std::pow(10., std::floor(std::log10(published)) + 1 - digits);
    return std::abs(value - published) <= 0.51 * unit;
  }
} // namespace auxfem::testing_support

#endif
