#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene_space.h>

#include <algorithm>

namespace auxfem
{
  using dealii::Tensor;

  void refuse_in_plane(dealii::ParameterHandler &prm,
                       const std::string        &name,
                       const SceneContext       &context,
                       const std::string        &remedy)
  {
    throw InputError(context.path + "/" + name + " = " + prm.get(name) +
                     ": this has a meaning in space only, but here "
                     "Dimension = 2. " +
                     remedy + ", or set Dimension = 3");
  }



  Tensor<1, 3> read_vector(dealii::ParameterHandler &prm,
                           const QuantityList       &entry,
                           const SceneContext       &context)
  {
    const std::vector<double> numbers = get(prm, entry);
    Tensor<1, 3>              vector;
    std::copy(numbers.begin(), numbers.end(), vector.begin_raw());
    if (context.dimension == 2 && vector[2] != 0)
      refuse_in_plane(prm,
                      entry.name,
                      context,
                      "Give the components x and y alone");
    return vector;
  }



  Tensor<1, 3> read_unit_vector(dealii::ParameterHandler &prm,
                                const QuantityList       &entry,
                                const SceneContext       &context)
  {
    const std::vector<double> numbers = get(prm, entry);
    const Tensor<1, 3>        vector({numbers[0], numbers[1], numbers[2]});
    if (!(vector.norm() > 0))
      throw InputError(context.path + "/" + entry.name + " = " +
                       prm.get(entry.name) +
                       ": the zero vector has no direction. Give three numbers "
                       "that are not all zero, e.g. set " +
                       entry.name + " = 0 0 1");
    return vector / vector.norm();
  }



  Tensor<1, 3> read_moments_of_inertia(dealii::ParameterHandler &prm,
                                       const QuantityList       &entry,
                                       const SceneContext       &context)
  {
    const std::vector<double> moments = get(prm, entry);
    if (moments.size() == 2)
      throw InputError(context.path + "/" + entry.name + " = " +
                       prm.get(entry.name) +
                       ": there are two numbers. Give one, the same about "
                       "every axis, or three, about x, y and z");
    if (context.dimension == 2)
      return Tensor<1, 3>({0, 0, moments.back()});
    return Tensor<1, 3>(
      {moments.front(), moments[moments.size() / 2], moments.back()});
  }
} // namespace auxfem
