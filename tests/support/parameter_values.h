#ifndef auxfem_tests_support_parameter_values_h
#define auxfem_tests_support_parameter_values_h

#include <auxfem/parameters/subsection_schema.h>

#include <string>

namespace auxfem
{
  /**
   * Values of @p parameters from lines as a user writes them in a file. Throws
   * InputError for what is not allowed.
   */
  inline ParameterValues values_from_text(const Parameters   &parameters,
                                          const std::string  &text,
                                          const SceneContext &context)
  {
    const ParameterSubsection root = parse_parameter_text(text, "test.prm");
    SubsectionSchema          schema;
    schema.parameters = parameters;
    Mistakes mistakes;
    check_subsection(root, schema, context, mistakes);
    mistakes.throw_if_any("test.prm");
    ParameterValues values(parameters, context);
    for (const ParameterEntry &entry : root.entries)
      values.set(entry.name, entry.value);
    return values;
  }
} // namespace auxfem

#endif
