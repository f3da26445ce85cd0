#include <auxfem/mesh/set_definition.h>

namespace auxfem
{
  SubsectionSchema sets_schema()
  {
    return {"Sets",
            SubsectionSchema::Form::free_entries,
            "Sets of joints or struts: \"joints: \" or \"struts: \" followed "
            "by set names joined by +, by numbers, by \"nearest: x, y\" (in "
            "space \"nearest: x, y, z\") or by a condition in x, y and z (m), "
            "e.g. joints: y > ymax - 1e-6."};
  }



  SetDefinition read_set(ParameterValues &values)
  {
    return {values.name(), text_of_free_entry(values), values.context.path};
  }
} // namespace auxfem
