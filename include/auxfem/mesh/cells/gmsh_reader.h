#ifndef auxfem_mesh_cells_gmsh_reader_h
#define auxfem_mesh_cells_gmsh_reader_h

#include <deal.II/base/point.h>

#include <map>
#include <string>
#include <vector>

namespace auxfem
{
  /** What a file that gmsh reads has to say about a lattice. */
  struct LineMesh
  {
    static constexpr std::size_t no_node = 0; ///< gmsh numbers nodes from 1

    /** A line element by the tags of its nodes. */
    struct Line
    {
      std::size_t tag;
      std::size_t first, second;
      std::size_t middle; ///< no_node for a line of two nodes
      int         curve;  ///< the gmsh entity it belongs to

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &tag &first &second &middle &curve;
      }
    };

    std::map<std::size_t, dealii::Point<3>>         positions; ///< of nodes (m)
    std::vector<Line>                               lines;     ///< by tag
    std::map<int, std::vector<std::string>>         groups_of_curve;
    std::map<std::string, std::vector<std::size_t>> point_groups;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &positions &lines &groups_of_curve &point_groups;
    }
  };

  /**
   * Reads @p file with the gmsh library, in a process of its own: gmsh crashes
   * on damaged files.
   * @param unit length of the number 1 in the file (m).
   * @param where begins messages.
   * @param directory that relative names start from, for messages.
   * Throws InputError for what cannot be read, and for a mesh without lines of
   * two or three nodes.
   */
  LineMesh read_with_gmsh(const std::string &file,
                          double             unit,
                          const std::string &where,
                          const std::string &directory);
} // namespace auxfem

#endif
