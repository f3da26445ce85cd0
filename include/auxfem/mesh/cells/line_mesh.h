#ifndef auxfem_mesh_cells_line_mesh_h
#define auxfem_mesh_cells_line_mesh_h

#include <deal.II/base/point.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace auxfem
{
  /** Nodes, line elements and sets of a mesh file, with the file's numbers and
   * unit of length. */
  struct LineMesh
  {
    static constexpr std::size_t no_node = 0; ///< nodes are numbered from 1

    /** A line element, by the numbers of its nodes. */
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
    /** Sentences on parts of the file that the lattice does not take over. */
    std::vector<std::string> notes;
  };

  /** Error in a mesh file, with its line or byte. */
  struct MeshMistake
  {
    std::string text;
  };

  /**
   * Reads an Abaqus input file without parts and instances: nodes, beam and
   * truss elements, node and element sets. Elements are also in a set named by
   * their type. Set members at which no element ends are dropped; the notes
   * tell what is not taken over. Throws MeshMistake, e.g. `line 12: element 5
   * has node 9, ...`.
   */
  LineMesh read_abaqus(const std::string &content);

  /**
   * Reads a file in gmsh's format MSH 2 or 4.1, text or binary: lines of two
   * and three nodes, physical groups of points and curves. Groups without name
   * are called "group" and their number. There may be no lines. Throws
   * MeshMistake, e.g. `line 66: element 5 has node -1, ...`.
   */
  LineMesh read_msh(const std::string &content);
} // namespace auxfem

#endif
