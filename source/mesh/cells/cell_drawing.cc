#include <auxfem/mesh/cells/cell_drawing.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>

namespace auxfem
{
  unsigned int CellDrawing::joint(const dealii::Point<3> &position)
  {
    const auto found =
      std::find_if(cell.joints.begin(),
                   cell.joints.end(),
                   [&](const dealii::Point<3> &known) {
                     return known.distance(position) <= tolerance;
                   });
    if (found != cell.joints.end())
      return found - cell.joints.begin();
    cell.joints.push_back(position);
    return cell.joints.size() - 1;
  }

  void CellDrawing::strut(const unsigned int a,
                          const unsigned int b,
                          const std::string &set,
                          const double       sagitta)
  {
    const auto is_same = [&](const UnitStrut &strut) {
      return (strut.first == a && strut.second == b &&
              strut.sagitta == sagitta) ||
        (strut.first == b && strut.second == a && strut.sagitta == -sagitta);
    };
    if (std::none_of(cell.struts.begin(), cell.struts.end(), is_same))
      cell.struts.push_back({a, b, sagitta, {set}});
  }

  void CellDrawing::strut_across(const unsigned int        a,
                                 const unsigned int        b,
                                 const std::array<int, 3> &shift,
                                 const std::string        &set)
  {
    cell.struts_across.push_back({set, {{a, b, shift}}});
  }

  UnitCell CellDrawing::repeated(const dealii::Tensor<1, 3> &period) const
  {
    UnitCell result = cell;
    for (unsigned int d = 0; d < 3; ++d)
      result.vectors[d][d] = period[d];
    if (period[2] == 0)
      result.no_vector_reasons[2] = "It is planar and has no Layer distance.";
    return result;
  }

  const Quantity &equal_strut_length()
  {
    static const Quantity parameter{"Strut length",
                                    "10 mm",
                                    "m",
                                    Range::positive(),
                                    "Length L of all struts."};
    return parameter;
  }

  void require_space(const std::string &name, const SceneContext &context)
  {
    if (context.dimension != 3)
      throw InputError(context.path + ": the cell '" + name +
                       "' does not lie in a plane. Set Dimension = 3 at the "
                       "top of the file, or choose a planar cell.");
  }
} // namespace auxfem
