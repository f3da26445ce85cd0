#ifndef auxfem_parameters_describe_h
#define auxfem_parameters_describe_h

#include <auxfem/parameters/subsection_schema.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Those of @p known that a user may have meant by @p name, at most three, the
   * nearest first: by the number of letters inserted, deleted, replaced or
   * swapped with their neighbour, ignoring case. Names that differ in more than
   * a third of their letters are left out, unless one begins with the other.
   */
  std::vector<std::string> nearest_names(const std::string              &name,
                                         const std::vector<std::string> &known);

  /**
   * The end of a sentence about an unknown @p name: `; did you mean "a" or
   * "b"?` with nearest_names(), a full stop if there is none.
   */
  std::string did_you_mean(const std::string              &name,
                           const std::vector<std::string> &known);

  /**
   * Every parameter with default, unit, range and sentence, as a commented
   * parameter file.
   */
  std::string describe_parameters(const std::vector<SubsectionSchema> &schemas);

  /** The same as the Markdown page doc/user/parameters.md. */
  std::string
  describe_parameters_markdown(const std::vector<SubsectionSchema> &schemas);

  /**
   * The same as JSON for other programs: a list of subsections, each with name,
   * form, meaning and parameters, and the variants of its choice with theirs.
   */
  std::string
  describe_parameters_json(const std::vector<SubsectionSchema> &schemas);

  /**
   * The subsection of @p schema with the @p values used, in .prm syntax, each
   * with its sentence; a default other than the value stands beside it.
   */
  std::string listing_of(const SubsectionSchema             &schema,
                         const std::vector<ParameterValues> &values);
} // namespace auxfem

#endif
