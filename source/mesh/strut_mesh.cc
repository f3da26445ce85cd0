#include <auxfem/mesh/strut_mesh.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <new>

namespace auxfem
{
  std::vector<unsigned int> partition_struts(const Lattice     &lattice,
                                             const unsigned int n_ranks)
  {
    const unsigned int        n_struts = lattice.struts.size();
    std::vector<unsigned int> ranks(n_struts, 0);
    if (n_ranks == 1)
      return ranks;
    if (n_ranks > n_struts)
      throw InputError(
        "auxfem was started on " + std::to_string(n_ranks) +
        " MPI ranks, but the lattice has only " + std::to_string(n_struts) +
        (n_struts == 1 ? " strut" : " struts") +
        " to share among them. Use at most " + std::to_string(n_struts) +
        (n_struts == 1 ? " rank." : " ranks."));

    std::vector<std::vector<unsigned int>> struts_at(lattice.joints.size());
    for (unsigned int s = 0; s < n_struts; ++s)
      for (const unsigned int joint : lattice.struts[s].joints)
        struts_at[joint].push_back(s);

    dealii::DynamicSparsityPattern graph(n_struts, n_struts);
    for (const auto &meeting : struts_at)
      for (const unsigned int a : meeting)
        for (const unsigned int b : meeting)
          graph.add(a, b);
    dealii::SparsityPattern pattern;
    pattern.copy_from(graph);
    try
      {
        dealii::SparsityTools::partition(
          pattern,
          n_ranks,
          ranks,
          dealii::SparsityTools::Partitioner::metis);
      }
    catch (const dealii::SparsityTools::ExcMETISError &)
      {
        // With a graph that is right, METIS fails for want of memory only.
        throw std::bad_alloc();
      }
    return ranks;
  }

  StrutMesh::StrutMesh(const Lattice             &lattice,
                       std::vector<StrutDivision> divisions,
                       const MPI_Comm             communicator)
    : mesh(communicator,
           Triangulation::none,
           /*allow_artificial_cells=*/false,
           Triangulation::partition_custom_signal)
    , of_struts(std::move(divisions))
    , ranks(
        partition_struts(lattice,
                         dealii::Utilities::MPI::n_mpi_processes(communicator)))
  {
    AssertDimension(of_struts.size(), lattice.struts.size());
    mesh.signals.create.connect([this]() {
      for (const auto &cell : mesh.active_cell_iterators())
        cell->set_subdomain_id(ranks[cell->material_id()]);
    });

    // Not a mesh in space: in Triangulation<1, 3> deal.II searches all cells
    // for the next chain once for each of them.
    std::vector<dealii::Point<1>>    vertices;
    std::vector<dealii::CellData<1>> cells;
    for (unsigned int strut = 0; strut < lattice.struts.size(); ++strut)
      {
        if (lattice.struts[strut].is_rigid())
          continue;
        const unsigned int n = of_struts[strut].n_elements;
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
    if (cells.empty())
      return;
    mesh.create_triangulation(vertices, cells, dealii::SubCellData());
  }

  unsigned int StrutMesh::n_cells() const
  {
    return mesh.n_active_cells();
  }

  StrutMesh::Interval
  StrutMesh::interval(const Triangulation::cell_iterator &cell) const
  {
    // The number of the strut takes digits of the vertices' places.
    const unsigned int strut  = cell->material_id();
    const double       n      = of_struts[strut].n_elements;
    const double       number = std::round((cell->vertex(0)[0] - strut) * n);
    return {strut, number / n, (number + 1) / n};
  }
} // namespace auxfem
