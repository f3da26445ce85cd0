#include <auxfem/mesh/arc.h>
#include <auxfem/mesh/cells/entries.h>
#include <auxfem/mesh/cells/gmsh_reader.h>
#include <auxfem/mesh/position_text.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>

namespace auxfem
{
  namespace
  {
    const Text file_entry{
      "File",
      "",
      "File with line elements, relative to the folder of the parameter file: "
      "any mesh gmsh reads, or a geometry (.geo), whose curves are then meshed. "
      "Lines of two nodes become straight struts, lines of three nodes circular "
      "arcs through their middle node; physical groups become sets of struts "
      "and joints, those without name under \"group\" and their number.",
      true};

    const Quantity length_unit{"Length unit",
                               "1 m",
                               "m",
                               Range::positive(),
                               "Length that the number 1 stands for in the "
                               "file."};

    /**
     * Lengths below this part of the mesh's size are round-off, as they are for
     * gmsh's own geometry.
     */
    constexpr double relative_length_tolerance = 1e-8;

    /** Makes a unit cell of a mesh. */
    class MeshToCell
    {
    public:
      MeshToCell(const LineMesh     &mesh,
                 const std::string  &file,
                 const SceneContext &context)
        : mesh(mesh)
        , is_planar(context.dimension == 2)
        , where(context.path + "/" + file_entry.name + ": in " + file + ", ")
        , tolerance(relative_length_tolerance * size())
      {}

      UnitCell build()
      {
        add_joints();
        for (const LineMesh::Line &line : mesh.lines)
          add_strut(line);
        add_joint_sets();
        cell.why_no_period.fill("A mesh file has no neighbour cells.");
        return std::move(cell);
      }

    private:
      /** Largest extent of the lines (m). */
      double size() const
      {
        const dealii::Point<3> start  = position(mesh.lines.front().first);
        dealii::Point<3>       lowest = start, highest = start;
        for (const LineMesh::Line &line : mesh.lines)
          for (const std::size_t node : {line.first, line.second})
            for (unsigned int d = 0; d < 3; ++d)
              {
                lowest[d]  = std::min(lowest[d], position(node)[d]);
                highest[d] = std::max(highest[d], position(node)[d]);
              }
        const dealii::Tensor<1, 3> extent = highest - lowest;
        return std::max({extent[0], extent[1], extent[2]});
      }

      const dealii::Point<3> &position(const std::size_t node) const
      {
        return mesh.positions.at(node);
      }

      /**
       * In the plane without the round-off of a rotation in space, if it has
       * any.
       */
      dealii::Point<3> checked_position(const std::size_t node) const
      {
        const dealii::Point<3> &p = position(node);
        if (!is_planar)
          return p;
        if (std::abs(p[2]) > tolerance)
          throw InputError(where + "node " + std::to_string(node) +
                           " lies at " + position_text(p, 3) +
                           ".\nIn a planar scene all nodes of lines must have "
                           "z = 0. Set Dimension = 3 at the top of the "
                           "parameter file for a frame in space.");
        return {p[0], p[1], 0.};
      }

      void add_joints()
      {
        for (const LineMesh::Line &line : mesh.lines)
          for (const std::size_t node : {line.first, line.second})
            joint_of_node[node] = invalid_index;
        for (auto &[node, joint] : joint_of_node)
          {
            joint = cell.joints.size();
            cell.joints.push_back(checked_position(node));
          }
      }

      void add_strut(const LineMesh::Line &line)
      {
        // Version 2 of gmsh's format repeats a line for every group it is in.
        const auto [low, high] = std::minmax(line.first, line.second);
        const auto known =
          strut_of_nodes.emplace(std::make_tuple(low, high, line.middle),
                                 cell.struts.size());
        if (known.second)
          {
            cell.struts.push_back(
              {joint_of_node.at(line.first), joint_of_node.at(line.second)});
            set_shape(line, cell.struts.back());
          }
        const auto groups = mesh.groups_of_curve.find(line.curve);
        auto      &sets   = cell.struts[known.first->second].sets;
        if (groups != mesh.groups_of_curve.end())
          sets.insert(sets.end(), groups->second.begin(), groups->second.end());
      }

      /**
       * Makes @p strut an arc where @p line is one. Also refuses lines of which
       * no strut can be made.
       */
      void set_shape(const LineMesh::Line &line, UnitStrut &strut) const
      {
        const dealii::Point<3>     start = checked_position(line.first);
        const dealii::Tensor<1, 3> chord =
          checked_position(line.second) - start;
        if (chord.norm() <= tolerance)
          throw InputError(
            text_of(line) +
            " has zero length: its ends lie at the same position. "
            "Remove it, or divide a ring into two or more "
            "arcs.");
        if (line.middle == LineMesh::no_node)
          return;
        if (joint_of_node.count(line.middle) > 0)
          throw InputError(text_of(line) + " has node " +
                           std::to_string(line.middle) +
                           " in its middle, at which another line ends. "
                           "Struts meet at their ends only: divide the line "
                           "there.");

        const auto arc =
          arc_through(chord, checked_position(line.middle) - start);
        if (!arc)
          throw InputError(text_of(line) + " turns back: its middle node " +
                           std::to_string(line.middle) +
                           " does not lie between its ends, and no arc leads "
                           "through it. Move that node.");
        if (std::abs(arc->sagitta) <= tolerance)
          return;
        strut.sagitta = arc->sagitta;
        strut.normal  = arc->normal;
      }

      std::string text_of(const LineMesh::Line &line) const
      {
        return where + "line element " + std::to_string(line.tag) +
          " (from node " + std::to_string(line.first) + " to node " +
          std::to_string(line.second) + ")";
      }

      void add_joint_sets()
      {
        for (const auto &[name, nodes] : mesh.point_groups)
          for (const std::size_t node : nodes)
            {
              const auto joint = joint_of_node.find(node);
              if (joint == joint_of_node.end())
                throw InputError(where + "the physical group \"" + name +
                                 "\" has node " + std::to_string(node) +
                                 ", at which no line ends. Joints are the "
                                 "ends of lines: take the point out of the "
                                 "group or end a line there.");
              cell.joint_sets[name].push_back(joint->second);
            }
      }

      const LineMesh                     &mesh;
      const bool                          is_planar;
      const std::string                   where;
      const double                        tolerance;
      UnitCell                            cell;
      std::map<std::size_t, unsigned int> joint_of_node;
      std::map<std::tuple<std::size_t, std::size_t, std::size_t>, unsigned int>
        strut_of_nodes;
    };

    std::unique_ptr<Cell> make_mesh_file(ParameterValues &values)
    {
      const std::string file =
        (std::filesystem::path(values.context.directory) / values[file_entry])
          .string();
      values.set(file_entry.name,
                 absolute_file(values[file_entry], values.context));
      values.files.push_back(values[file_entry]);
      const LineMesh mesh =
        read_with_gmsh(file,
                       values[length_unit],
                       values.context.path + "/" + file_entry.name + ": ",
                       values.context.directory);
      return std::make_unique<GivenCell>(
        MeshToCell(mesh, file, values.context).build());
    }
  } // namespace

  RegistryEntry<Cell> mesh_file_cell_entry()
  {
    return {"mesh file",
            "Frame from the line elements of a file that gmsh reads.",
            {file_entry, length_unit},
            make_mesh_file};
  }
} // namespace auxfem
