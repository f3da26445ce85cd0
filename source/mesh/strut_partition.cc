#include <auxfem/mesh/index_lists.h>
#include <auxfem/mesh/strut_partition.h>
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
    /**
     * What is given to the ranks as a whole: unit cells, if each rank gets so
     * many that they can be shared evenly; else struts.
     */
    struct Pieces
    {
      Pieces(const Lattice &lattice, const unsigned int n_ranks)
      {
        const bool in_cells = lattice.n_cells * noticeable_part >= n_ranks;
        weights.resize(in_cells ? lattice.n_cells : lattice.struts.size());
        for (unsigned int s = 0; s < lattice.struts.size(); ++s)
          {
            of_strut.push_back(in_cells ? lattice.struts[s].cell : s);
            ++weights[of_strut.back()];
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
              if (std::find(pieces.begin(), pieces.end(), of_strut[s]) ==
                  pieces.end())
                pieces.push_back(of_strut[s]);
            if (pieces.size() > 1)
              for (const unsigned int a : pieces)
                for (const unsigned int b : pieces)
                  entries.add(a, b);
          }
        graph.copy_from(entries);
      }

      std::vector<unsigned int> of_strut;
      std::vector<unsigned int> weights; ///< numbers of struts
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
        // With a graph that is right, METIS fails for want of memory only.
        throw std::bad_alloc();
      }
    for (unsigned int s = 0; s < n_struts; ++s)
      ranks[s] = rank_of_piece[pieces.of_strut[s]];
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
} // namespace auxfem
