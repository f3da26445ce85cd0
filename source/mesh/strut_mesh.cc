#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/strut_mesh.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <new>

namespace auxfem
{
  namespace
  {
    /** Units of partitioning: unit cells if each rank gets many of them,
     * otherwise struts. */
    struct Pieces
    {
      Pieces(const Lattice &lattice, const unsigned int n_ranks)
      {
        const bool in_cells = lattice.n_cells * noticeable_fraction >= n_ranks;
        weights.resize(in_cells ? lattice.n_cells : lattice.struts.size());
        for (unsigned int s = 0; s < lattice.struts.size(); ++s)
          {
            piece_of_strut.push_back(in_cells ? lattice.struts[s].cell : s);
            ++weights[piece_of_strut.back()];
          }
      }

      /** Fills @p graph with pieces that meet at a joint. */
      void find_neighbours(const Lattice           &lattice,
                           dealii::SparsityPattern &graph) const
      {
        const IndexLists struts_at(
          lattice.joints.size(),
          [&lattice](const auto &add) {
            for (unsigned int s = 0; s < lattice.struts.size(); ++s)
              for (const unsigned int joint : lattice.struts[s].joints)
                add(joint, s);
          });
        dealii::DynamicSparsityPattern entries(weights.size(), weights.size());
        std::vector<unsigned int>      pieces;
        for (unsigned int joint = 0; joint < lattice.joints.size(); ++joint)
          {
            pieces.clear();
            for (const unsigned int s : struts_at[joint])
              if (std::find(pieces.begin(), pieces.end(), piece_of_strut[s]) ==
                  pieces.end())
                pieces.push_back(piece_of_strut[s]);
            if (pieces.size() > 1)
              for (const unsigned int a : pieces)
                for (const unsigned int b : pieces)
                  entries.add(a, b);
          }
        graph.copy_from(entries);
      }

      std::vector<unsigned int> piece_of_strut;
      std::vector<unsigned int> weights; ///< number of struts, by piece
    };
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

    const Pieces            pieces(lattice, n_ranks);
    dealii::SparsityPattern graph;
    pieces.find_neighbours(lattice, graph);
    std::vector<unsigned int> rank_of_piece(pieces.weights.size());
    try
      {
        dealii::SparsityTools::partition(
          graph,
          pieces.weights,
          n_ranks,
          rank_of_piece,
          dealii::SparsityTools::Partitioner::metis);
      }
    catch (const dealii::SparsityTools::ExcMETISError &)
      {
        // With a valid graph METIS fails only if memory runs out.
        throw std::bad_alloc();
      }
    for (unsigned int s = 0; s < n_struts; ++s)
      ranks[s] = rank_of_piece[pieces.piece_of_strut[s]];
    return ranks;
  }

  StrutPartition::StrutPartition(const Lattice             &lattice,
                                 std::vector<StrutDivision> divisions,
                                 const MPI_Comm             communicator)
    : divisions(std::move(divisions))
    , ranks(
        partition_struts(lattice,
                         dealii::Utilities::MPI::n_mpi_processes(communicator)))
  {
    AssertDimension(this->divisions.size(), lattice.struts.size());
  }

  StrutMesh::StrutMesh(const std::vector<StrutDivision> &divisions,
                       const std::vector<unsigned int>  &struts)
    : divisions(divisions)
  {
    // In Triangulation<1, 3> the time to find separate chains would grow with
    // the square of their number.
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
    // Rounding restores the digits that a vertex loses to the strut number.
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
