#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter_values.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>

namespace auxfem
{
  std::string absolute_file(const std::string  &file,
                            const SceneContext &context)
  {
    namespace fs = std::filesystem;
    return (fs::absolute(context.directory) / file).lexically_normal().string();
  }

  using dealii::Tensor;

  namespace
  {
    [[noreturn]] void refuse_in_plane(const ParameterValues &values,
                                      const Parameter       &parameter,
                                      const std::string     &remedy)
    {
      values.refuse(parameter,
                    "this has a meaning in space only, but here "
                    "Dimension = 2. " +
                      remedy + ", or set Dimension = 3");
    }
  } // namespace



  ParameterValues::ParameterValues(const Parameters   &parameters,
                                   const SceneContext &context,
                                   const FileLocation &location)
    : parameters(parameters)
    , context(context)
    , location(location)
  {
    for (const Parameter &parameter : parameters)
      texts[parameter.name] = parameter.default_value;
    number_texts = texts;
  }



  void ParameterValues::set(const std::string &name, const std::string &text)
  {
    const auto parameter =
      std::find_if(parameters.begin(),
                   parameters.end(),
                   [&name](const Parameter &one) { return one.name == name; });
    texts.at(name) = dealii::Utilities::trim(text);
    number_texts.at(name) =
      parameter->with_constants(texts.at(name), context.constants);
  }



  void ParameterValues::refuse(const Parameter   &parameter,
                               const std::string &reason) const
  {
    throw InputError((context.path.empty() ? "" : context.path + "/") +
                     parameter.name + " = " + text(parameter) + ": " + reason);
  }



  void ParameterValues::refuse(const std::string &reason) const
  {
    throw InputError(context.path + ": " + reason);
  }



  void require_space(const ParameterValues &values,
                     const Parameter       &parameter,
                     const std::string     &remedy)
  {
    if (values.context.dimension == 2 && !values.is_default(parameter))
      refuse_in_plane(values, parameter, remedy);
  }



  Tensor<1, 3> vector_of(const ParameterValues &values,
                         const QuantityList    &parameter)
  {
    const std::vector<double> numbers = values[parameter];
    Tensor<1, 3>              vector;
    std::copy(numbers.begin(), numbers.end(), vector.begin_raw());
    if (values.context.dimension == 2 && vector[2] != 0)
      refuse_in_plane(values, parameter, "Give the components x and y alone");
    return vector;
  }



  Tensor<1, 3> unit_vector_of(const ParameterValues &values,
                              const QuantityList    &parameter)
  {
    const std::vector<double> numbers = values[parameter];
    Tensor<1, 3>              vector;
    std::copy(numbers.begin(), numbers.end(), vector.begin_raw());
    if (!(vector.norm() > 0))
      values.refuse(parameter,
                    "the zero vector has no direction. Give numbers that are "
                    "not all zero, e.g. set " +
                      parameter.name +
                      (numbers.size() == 2 ? " = 0 1" : " = 0 0 1"));
    return vector / vector.norm();
  }



  Tensor<1, 3> moments_of_inertia_of(const ParameterValues &values,
                                     const QuantityList    &parameter)
  {
    const std::vector<double> moments = values[parameter];
    if (moments.size() == 2)
      values.refuse(parameter,
                    "there are two numbers. Give one, the same about "
                    "every axis, or three, about x, y and z");
    if (values.context.dimension == 2)
      return Tensor<1, 3>({0, 0, moments.back()});
    return Tensor<1, 3>(
      {moments.front(), moments[moments.size() / 2], moments.back()});
  }
} // namespace auxfem
