#include <auxfem/mesh/strut_mesh.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

namespace auxfem
{
  using Mesh = dealii::parallel::shared::Triangulation<1, 3>;

  namespace
  {
    void collect_places(const Mesh::cell_iterator     &cell,
                        const StrutMesh::Place        &place,
                        std::vector<StrutMesh::Place> &places)
    {
      if (cell->is_active())
        {
          places[cell->active_cell_index()] = place;
          return;
        }
      const double middle = (place.begin + place.end) / 2;
      collect_places(cell->child(0),
                     {place.strut, place.begin, middle},
                     places);
      collect_places(cell->child(1), {place.strut, middle, place.end}, places);
    }
  } // namespace

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
    dealii::SparsityTools::partition(pattern,
                                     n_ranks,
                                     ranks,
                                     dealii::SparsityTools::Partitioner::metis);
    return ranks;
  }

  StrutMesh::StrutMesh(const Lattice     &lattice,
                       const unsigned int refinements,
                       const MPI_Comm     communicator)
    : mesh(communicator,
           Mesh::none,
           /*allow_artificial_cells=*/false,
           Mesh::partition_custom_signal)
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

    std::vector<dealii::Point<3>>    vertices;
    std::vector<dealii::CellData<1>> cells;
    vertices.reserve(2 * lattice.struts.size());
    cells.reserve(lattice.struts.size());
    for (unsigned int number = 0; number < lattice.struts.size(); ++number)
      {
        const Strut &strut = lattice.struts[number];
        if (strut.is_rigid())
          continue;
        dealii::CellData<1> cell;
        cell.vertices    = {static_cast<unsigned int>(vertices.size()),
                            static_cast<unsigned int>(vertices.size() + 1)};
        cell.material_id = number;
        cells.push_back(cell);
        for (const unsigned int joint : strut.joints)
          vertices.push_back(lattice.joints[joint]);
      }
    if (cells.empty())
      return;
    mesh.create_triangulation(vertices, cells, dealii::SubCellData());
    mesh.refine_global(refinements);

    places.resize(mesh.n_active_cells());
    for (const auto &cell : mesh.cell_iterators_on_level(0))
      collect_places(cell, {cell->material_id(), 0., 1.}, places);
  }

  const Mesh &StrutMesh::triangulation() const
  {
    return mesh;
  }

  unsigned int StrutMesh::n_cells() const
  {
    return places.size();
  }

  unsigned int StrutMesh::rank(const unsigned int strut) const
  {
    return ranks[strut];
  }

  const StrutMesh::Place &
  StrutMesh::place(const unsigned int active_cell_index) const
  {
    return places[active_cell_index];
  }
} // namespace auxfem
