#ifndef auxfem_parameters_describe_h
#define auxfem_parameters_describe_h

#include <auxfem/parameters/subsection_schema.h>

#include <string>
#include <vector>

namespace auxfem
{
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
