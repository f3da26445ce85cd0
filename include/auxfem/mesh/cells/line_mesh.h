#ifndef auxfem_mesh_cells_line_mesh_h
#define auxfem_mesh_cells_line_mesh_h

#include <deal.II/base/point.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace auxfem
{
  /** Nodes, line elements and sets of a mesh file, in the file's own numbers
   * and unit of length. */
  struct LineMesh
  {
    static constexpr std::size_t no_node = 0; ///< nodes are numbered from 1

    /** A line element by the numbers of its nodes. */
    struct Line
    {
      std::size_t              tag;
      std::size_t              first, second;
      std::size_t              middle; ///< no_node for a line of two nodes
      std::vector<std::string> sets = {};
    };

    std::map<std::size_t, dealii::Point<3>> positions; ///< of nodes
    std::vector<Line>                       lines;     ///< in ascending order
    std::map<std::string, std::vector<std::size_t>> node_sets;
    /** Sentences on what the file has and the lattice has not. */
    std::vector<std::string> notes;
  };

  /** A mistake in a mesh file, with its line or byte. */
  struct MeshMistake
  {
    std::string text;
  };
} // namespace auxfem

#endif
