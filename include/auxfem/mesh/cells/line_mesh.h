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

  /**
   * Nodes, beam and truss elements, node and element sets in @p content of an
   * input file of Abaqus without parts and instances. Elements are also in a
   * set named by their type. Nodes of sets at which no element ends are left
   * out; this and all else that is not taken over is in the notes. Throws
   * MeshMistake, e.g. `line 12: element 5 has node 9, ...`.
   */
  LineMesh read_abaqus(const std::string &content);

  /**
   * Lines of two and three nodes and physical groups of points and curves in
   * @p content of a file in gmsh's format MSH 2 or 4.1, as text or binary.
   * Groups without name are called "group" and their number. The lines may be
   * none. Throws MeshMistake, e.g. `line 66: element 5 has node -1, ...`.
   */
  LineMesh read_msh(const std::string &content);
} // namespace auxfem

#endif
