#ifndef auxfem_parameters_inheritance_h
#define auxfem_parameters_inheritance_h

#include <auxfem/parameters/parameter_file.h>
#include <auxfem/parameters/subsection_schema.h>

namespace auxfem
{
  /**
   * Adds to named groups the values that they inherit from the group named by
   * their parameter @p base, which may inherit itself. Values given count;
   * those of another choice of the schema are not inherited. Unknown names and
   * circles are added to @p mistakes.
   */
  void inherit_values(const SubsectionSchema &schema,
                      const Parameter        &base,
                      ParameterSubsection    &root,
                      Mistakes               &mistakes);
} // namespace auxfem

#endif
