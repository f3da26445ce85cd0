#include <auxfem/mesh/cells/cell_table.h>
#include <auxfem/mesh/cells/gmsh_reader.h>
#include <auxfem/mesh/cells/line_mesh.h>
#include <auxfem/mesh/cells/translations.h>
#include <auxfem/mesh/merge_joints.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/strut_geometry.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/parameters/parameter_file.h>

#include <algorithm>
#include <cctype>
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
      "a gmsh mesh .msh (2 or 4.1, text or binary), an Abaqus input file (.inp), "
      ".vtk, .unv or .mesh, or a gmsh script (.geo), whose curves are meshed. "
      "Lines of two nodes become straight struts, lines of three nodes circular "
      "arcs through the middle node. Physical groups, element and node sets "
      "become sets of struts and joints; a group without name is called "
      "\"group\" and its number.",
      true};

    const Boolean run_script{
      "Run gmsh script",
      false,
      "Whether gmsh may run the script (.geo). A script can run any command with "
      "your permissions: read it first."};

    const Quantity time_limit{
      "Gmsh time limit",
      "30 s",
      "s",
      Range::positive(),
      "Time after which gmsh and all processes of a script are ended."};

    const Quantity length_unit{"Length unit",
                               "1 m",
                               "m",
                               Range::positive(),
                               "Length of one unit of the file."};

    /** Converts a mesh to a unit cell. */
    class MeshToCell
    {
    public:
      MeshToCell(const LineMesh        &mesh,
                 const std::string     &file,
                 const ParameterValues &values)
        : mesh(mesh)
        , unit(values[length_unit])
        , merged(values[merge_distance()])
        , is_planar(values.context.dimension == 2)
        , where(values.context.path + "/" + file_entry.name + ": in " + file +
                ", ")
        , tolerance(sqrt_round_off * size())
      {}

      UnitCell build()
      {
        add_joints();
        for (const LineMesh::Line &line : mesh.lines)
          add_strut(line);
        add_joint_sets();
        cell.notes = mesh.notes;
        merge();
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

      dealii::Point<3> position(const std::size_t node) const
      {
        return unit * mesh.positions.at(node);
      }

      /** Position of a node (m); in the plane z must be zero up to the
       * round-off of a rotation in space. */
      dealii::Point<3> checked_position(const std::size_t node) const
      {
        const dealii::Point<3> p = position(node);
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

      /** Merges joints; the notes also have the file's numbers. */
      void merge()
      {
        std::vector<std::size_t> nodes;
        for (const auto &[node, joint] : joint_of_node)
          nodes.push_back(node);
        merge_joints(merged,
                     {[&nodes](const unsigned int joint) {
                        return "joint " + std::to_string(joint) + " (node " +
                          std::to_string(nodes[joint]) + ")";
                      },
                      [this](const unsigned int strut) {
                        return "element " + std::to_string(tag_of_strut[strut]);
                      }},
                     is_planar ? 2 : 3,
                     cell);
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
            tag_of_strut.push_back(line.tag);
          }
        auto &sets = cell.struts[known.first->second].sets;
        for (const std::string &set : line.sets)
          {
            refuse_name_of_all(set);
            sets.push_back(set);
          }
      }

      /** Makes @p strut an arc if @p line is curved. Refuses lines that cannot be
       * a strut. */
      void set_shape(const LineMesh::Line &line, UnitStrut &strut) const
      {
        const dealii::Point<3>     start = checked_position(line.first);
        const dealii::Tensor<1, 3> chord =
          checked_position(line.second) - start;
        if (line.middle == LineMesh::no_node && chord.norm() < merged)
          return;
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

      void refuse_name_of_all(const std::string &set) const
      {
        if (set == "all")
          throw InputError(where +
                           "a group is named \"all\", which is the name of the "
                           "set of all joints or struts.\nChoose another name "
                           "for the group.");
      }

      void add_joint_sets()
      {
        for (const auto &[name, nodes] : mesh.node_sets)
          for (const std::size_t node : nodes)
            {
              refuse_name_of_all(name);
              const auto joint = joint_of_node.find(node);
              if (joint == joint_of_node.end())
                throw InputError(where + "the physical group \"" + name +
                                 "\" has node " + std::to_string(node) +
                                 ", at which no line ends. Joints are the "
                                 "ends of lines: remove the point from the "
                                 "group or end a line there.");
              cell.joint_sets[name].push_back(joint->second);
            }
      }

      const LineMesh &mesh;
      const double    unit;
      /** Length below which merge_joints() removes a strut (m). */
      const double                        merged;
      const bool                          is_planar;
      const std::string                   where;
      const double                        tolerance;
      UnitCell                            cell;
      std::map<std::size_t, unsigned int> joint_of_node;
      std::vector<std::size_t>            tag_of_strut;
      std::map<std::tuple<std::size_t, std::size_t, std::size_t>, unsigned int>
        strut_of_nodes;
    };

    /** Beginning of a file in gmsh's format, which may have any name. */
    const std::string msh_begin = "$MeshFormat";

    std::string ending_of(const std::string &file)
    {
      std::string ending = std::filesystem::path(file).extension().string();
      for (char &letter : ending)
        letter = std::tolower(static_cast<unsigned char>(letter));
      return ending;
    }

    [[noreturn]] void refuse_file(const ParameterValues &values,
                                  const std::string     &reason)
    {
      throw InputError(values.context.path + "/" + file_entry.name + ": " +
                       reason);
    }

    void refuse_script(const std::string &file, const ParameterValues &values)
    {
      refuse_file(values,
                  file +
                    " is a script of gmsh, which may run any command on this "
                    "machine and write any file; it is not run.\nMesh it "
                    "yourself (gmsh -1 " +
                    file +
                    ") and give the .msh file, or, if you know what is in it, "
                    "write Lattice/" +
                    run_script.name + " = true.");
    }

    /** Reads the mesh by its format, which the @p ending of @p file names. */
    LineMesh read_mesh(const std::string     &file,
                       const std::string     &ending,
                       const ParameterValues &values)
    {
      // The file is read once, so that checks and reader see the same content.
      const std::string content   = read_input_file(file);
      const bool        is_script = ending == ".geo";
      if (ending == ".msh" ||
          content.compare(0, msh_begin.size(), msh_begin) == 0)
        return read_msh(content);
      if (ending == ".inp")
        return read_abaqus(content);
      if (gmsh_can_read(ending))
        return read_with_gmsh(content, ending, values[time_limit]);
      if (!is_script)
        refuse_file(
          values,
          file + " does not begin with " + msh_begin +
            " and has none of the endings of other mesh files: .inp, .vtk, "
            ".unv, .mesh, or .geo for scripts of gmsh.\nSave the mesh in "
            "gmsh's format .msh, version 2.2 or 4.1.");
      if (!values[run_script])
        refuse_script(file, values);
      return run_gmsh_script(file, values[time_limit]);
    }

    /** As read_mesh(), but throws InputError with advice. */
    LineMesh read_lines(const std::string &file, const ParameterValues &values)
    {
      const std::string ending = ending_of(file);
      LineMesh          mesh;
      try
        {
          mesh = read_mesh(file, ending, values);
        }
      catch (const UnreadableFile &unreadable)
        {
          refuse_file(values,
                      "cannot read the mesh file " + file + ": it " +
                        unreadable.reason +
                        ".\nGive the name of a mesh file; a relative name "
                        "starts from the folder of the parameter file (" +
                        values.context.directory + ").");
        }
      catch (const MeshMistake &mistake)
        {
          refuse_file(values,
                      (gmsh_can_read(ending) || ending == ".geo"
                         ? "gmsh cannot read " + file
                         : ending == ".inp"
                         ? "cannot read " + file
                         : "the mesh file " + file + " is damaged") +
                        ":\n  " + mistake.text + "\nCorrect the file" +
                        (ending == ".inp" ? "."
                                          : ", or write it anew with gmsh."));
        }
      if (mesh.lines.empty())
        refuse_file(
          values,
          file +
            " has no line elements, from which struts are made.\nMesh the "
            "curves of the lattice (gmsh -1) and save them: in a model with "
            "physical groups, gmsh saves only elements that are in a group.");
      return mesh;
    }

    std::unique_ptr<Cell> make_mesh_file(ParameterValues &values)
    {
      const std::string file =
        (std::filesystem::path(values.context.directory) / values[file_entry])
          .string();
      values.set(file_entry.name,
                 absolute_file(values[file_entry], values.context));
      values.files.push_back(values[file_entry]);
      const LineMesh mesh = read_lines(file, values);
      UnitCell       cell = MeshToCell(mesh, file, values).build();
      set_translations(values, cell);
      return std::make_unique<PrebuiltCell>(cell);
    }
  } // namespace

  RegistryEntry<Cell> mesh_file_cell_entry()
  {
    Parameters parameters = {file_entry,
                             length_unit,
                             merge_distance(),
                             run_script,
                             time_limit};
    for (const Parameter &vector : translation_parameters())
      parameters.push_back(vector);
    return {"mesh file",
            "Frame, or with vectors a cell, from the line elements of a mesh "
            "file.",
            parameters,
            make_mesh_file};
  }
} // namespace auxfem
