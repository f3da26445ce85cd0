#ifndef auxfem_parameters_describe_h
#define auxfem_parameters_describe_h

#include <auxfem/parameters/subsection_schema.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * At most three names of @p known that @p name may be a misspelling of, the
   * nearest first. Distance is the number of letters inserted, deleted,
   * replaced or swapped, ignoring case. Names that differ in more than a third
   * of their letters are left out, unless one begins with the other.
   */
  std::vector<std::string> nearest_names(const std::string              &name,
                                         const std::vector<std::string> &known);

  /**
   * End of a sentence about an unknown @p name: `; did you mean "a" or "b"?`
   * with nearest_names(), or a full stop if there are none.
   */
  std::string did_you_mean(const std::string              &name,
                           const std::vector<std::string> &known);

  /**
   * All parameters with default, unit, range and sentence, as a commented
   * parameter file.
   */
  std::string describe_parameters(const std::vector<SubsectionSchema> &schemas);

  /** As describe_parameters(), as the Markdown page doc/user/parameters.md. */
  std::string
  describe_parameters_markdown(const std::vector<SubsectionSchema> &schemas);

  /**
   * As describe_parameters(), as JSON: a list of subsections with name, form,
   * meaning, parameters and the variants of their choice.
   */
  std::string
  describe_parameters_json(const std::vector<SubsectionSchema> &schemas);

  /**
   * The @p values of a subsection in .prm syntax, each with its sentence and,
   * where it differs, the default.
   */
  std::string listing_of(const SubsectionSchema             &schema,
                         const std::vector<ParameterValues> &values);

  /** As listing_of(), without sentences and without values that are defaults;
   * empty if nothing is left. */
  std::string changes_in(const SubsectionSchema             &schema,
                         const std::vector<ParameterValues> &values);
} // namespace auxfem

#endif
