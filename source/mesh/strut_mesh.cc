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

  StrutMesh::StrutMesh(const Lattice     &lattice,
                       const unsigned int refinements,
                       const MPI_Comm     communicator)
    : mesh(communicator,
           Triangulation::none,
           /*allow_artificial_cells=*/false,
           Triangulation::partition_custom_signal)
    , refinements(refinements)
    , ranks(
        partition_struts(lattice,
                         dealii::Utilities::MPI::n_mpi_processes(communicator)))
  {
    const auto assign_ranks = [this]() {
      for (const auto &cell : mesh.active_cell_iterators())
        cell->set_subdomain_id(ranks[cell->material_id()]);
    };
    mesh.signals.create.connect(assign_ranks);
    mesh.signals.post_refinement.connect(assign_ranks);

    // Not a mesh in space: in Triangulation<1, 3> deal.II searches all cells
    // for the next chain once for each of them.
    std::vector<dealii::Point<1>>    vertices;
    std::vector<dealii::CellData<1>> cells;
    vertices.reserve(2 * lattice.struts.size());
    cells.reserve(lattice.struts.size());
    for (unsigned int strut = 0; strut < lattice.struts.size(); ++strut)
      {
        if (lattice.struts[strut].is_rigid())
          continue;
        dealii::CellData<1> cell;
        cell.vertices    = {static_cast<unsigned int>(vertices.size()),
                            static_cast<unsigned int>(vertices.size() + 1)};
        cell.material_id = strut;
        cells.push_back(cell);
        vertices.emplace_back(strut);
        vertices.emplace_back(strut + 1.);
      }
    if (cells.empty())
      return;
    mesh.create_triangulation(vertices, cells, dealii::SubCellData());
    mesh.refine_global(refinements);
  }

  const StrutMesh::Triangulation &StrutMesh::triangulation() const
  {
    return mesh;
  }

  unsigned int StrutMesh::n_cells() const
  {
    return mesh.n_active_cells();
  }

  unsigned int StrutMesh::n_cells_of_strut() const
  {
    return 1u << refinements;
  }

  unsigned int StrutMesh::rank(const unsigned int strut) const
  {
    return ranks[strut];
  }

  StrutMesh::Interval
  StrutMesh::interval(const Triangulation::cell_iterator &cell)
  {
    // Vertices are whole numbers and halves of halves between them: exact.
    const unsigned int strut = cell->material_id();
    return {strut, cell->vertex(0)[0] - strut, cell->vertex(1)[0] - strut};
  }
} // namespace auxfem
