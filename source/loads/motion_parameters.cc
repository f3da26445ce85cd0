#include <auxfem/loads/motion_parameters.h>

#include <deal.II/base/utilities.h>

namespace auxfem
{
  TimeFunction read_time_function(ParameterValues      &values,
                                  const TimeExpression &parameter)
  {
    const std::string text = values[parameter];
    if (const auto table = table_text(text))
      {
        // A comma may be part of the name, or stand before a column.
        const std::string file = absolute_file(table->file, values.context);
        values.files.push_back(file);
        values.files.push_back(
          dealii::Utilities::trim(file.substr(0, file.rfind(','))));
        values.set(parameter.name, table->prefix + " " + file);
      }
    return TimeFunction(text, parameter.name, values.context);
  }
} // namespace auxfem
