#include <auxfem/mesh/strut_mesh.h>

namespace auxfem
{
  StrutMesh::StrutMesh(const std::vector<StrutDivision> &divisions,
                       const std::vector<unsigned int>  &struts)
    : divisions(divisions)
  {
    // Not a mesh in space: in Triangulation<1, 3> deal.II searches all cells
    // for the next chain once for each of them.
    std::vector<dealii::Point<1>>    vertices;
    std::vector<dealii::CellData<1>> cells;
    for (const unsigned int strut : struts)
      {
        const unsigned int n = divisions[strut].n_elements;
        vertices.emplace_back(strut);
        for (unsigned int i = 1; i <= n; ++i)
          {
            dealii::CellData<1> cell;
            cell.vertices    = {static_cast<unsigned int>(vertices.size() - 1),
                                static_cast<unsigned int>(vertices.size())};
            cell.material_id = strut;
            cells.push_back(cell);
            vertices.emplace_back(strut + double(i) / n);
          }
      }
    if (!cells.empty())
      mesh.create_triangulation(vertices, cells, dealii::SubCellData());
  }

  StrutInterval
  StrutMesh::interval(const dealii::Triangulation<1>::cell_iterator &cell) const
  {
    // The number of the strut takes digits of the vertices' places.
    const unsigned int strut  = cell->material_id();
    const double       n      = divisions[strut].n_elements;
    const double       number = std::round((cell->vertex(0)[0] - strut) * n);
    return {strut, number / n, (number + 1) / n};
  }

  std::vector<StrutInterval> StrutMesh::intervals() const
  {
    std::vector<StrutInterval> result;
    if (mesh.n_levels() == 0)
      return result;
    for (const auto &cell : mesh.active_cell_iterators())
      result.push_back(interval(cell));
    return result;
  }
} // namespace auxfem
