#include <auxfem/mesh/arc.h>
#include <auxfem/mesh/cells/entries.h>
#include <auxfem/mesh/place_text.h>
#include <auxfem/parameters/declare.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <tuple>

#include <gmsh.h>

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

    void declare_mesh_file(dealii::ParameterHandler &prm)
    {
      declare(prm, file_entry);
      declare(prm, length_unit);
    }

    /**
     * Lengths below this part of the mesh's size are round-off, as they are for
     * gmsh's own geometry.
     */
    constexpr double relative_tolerance = 1e-8;

    constexpr std::size_t no_node = 0; ///< gmsh numbers nodes from 1

    /** A line element by the tags of its nodes. */
    struct Line
    {
      std::size_t tag;
      std::size_t first, second;
      std::size_t middle; ///< no_node for a line of two nodes
      int         curve;  ///< the gmsh entity it belongs to
    };

    /** What a file has to say about a lattice. */
    struct Mesh
    {
      std::map<std::size_t, dealii::Point<3>>         places; ///< of nodes (m)
      std::vector<Line>                               lines;  ///< by tag
      std::map<int, std::vector<std::string>>         groups_of_curve;
      std::map<std::string, std::vector<std::size_t>> point_groups;
    };

    /** The gmsh library between its two calls, mute, its messages kept. */
    class GmshSession
    {
    public:
      GmshSession()
      {
        // Without the user's own gmsh settings: a scene must give the same
        // lattice everywhere.
        gmsh::initialize(0, nullptr, false);
        gmsh::option::setNumber("General.Terminal", 0);
        // The exception that gmsh would throw leaves its parser in the middle
        // of the file, and the next file is then read wrongly.
        gmsh::option::setNumber("General.AbortOnError", 0);
        gmsh::logger::start();
      }

      ~GmshSession()
      {
        gmsh::logger::stop();
        gmsh::finalize();
      }

      GmshSession(const GmshSession &)            = delete;
      GmshSession &operator=(const GmshSession &) = delete;

      /** The first of gmsh's error messages, one a line; empty if none. */
      std::string errors() const
      {
        const std::string        mark = "Error: ";
        std::vector<std::string> log;
        gmsh::logger::get(log);
        std::string  text;
        unsigned int n_shown = 0;
        for (const auto &message : log)
          if (message.compare(0, mark.size(), mark) == 0 && n_shown++ < 3)
            text += "\n  " + printable(message.substr(mark.size()));
        return text;
      }

    private:
      /** gmsh cites what it cannot read, which need not be text. */
      static std::string printable(std::string text)
      {
        for (char &letter : text)
          if (!std::isprint(static_cast<unsigned char>(letter)))
            letter = '?';
        return text;
      }
    };

    /** Reads the mesh of one file. */
    class MeshReader
    {
    public:
      MeshReader(const std::string  &file,
                 const double        unit,
                 const SceneContext &context)
        : file(file)
        , where(context.path + "/" + file_entry.name + ": ")
        , unit(unit)
      {
        // gmsh takes a file that does not exist as the name of a new model.
        const std::ifstream stream(file);
        if (!stream || std::filesystem::is_directory(file))
          throw InputError(where + "cannot read the mesh file " + file +
                           ".\nGive the name of a file that gmsh reads; a "
                           "relative name starts from the folder of the "
                           "parameter file (" +
                           context.directory + ").");
      }

      Mesh read()
      {
        try
          {
            open();
            Mesh mesh;
            read_nodes(mesh);
            read_lines(mesh);
            read_groups(mesh);
            return mesh;
          }
        catch (const std::string &message)
          {
            refuse("\n  " + message);
          }
      }

    private:
      [[noreturn]] void refuse(const std::string &messages) const
      {
        throw InputError(where + "gmsh cannot read " + file + ":" + messages +
                         "\nCorrect the file, or write it anew with gmsh.");
      }

      void open() const
      {
        gmsh::open(file);
        std::vector<std::size_t> nodes;
        std::vector<double>      coordinates, unused;
        gmsh::model::mesh::getNodes(nodes, coordinates, unused);
        // Where the parser failed, meshing would only add further errors.
        if (nodes.empty() && session.errors().empty())
          gmsh::model::mesh::generate(1);
        if (!session.errors().empty())
          refuse(session.errors());
      }

      void read_nodes(Mesh &mesh) const
      {
        std::vector<std::size_t> nodes;
        std::vector<double>      x, unused;
        gmsh::model::mesh::getNodes(nodes, x, unused);
        for (std::size_t i = 0; i < nodes.size(); ++i)
          mesh.places[nodes[i]] = {unit * x[3 * i],
                                   unit * x[3 * i + 1],
                                   unit * x[3 * i + 2]};
      }

      void read_lines(Mesh &mesh) const
      {
        gmsh::vectorpair curves;
        gmsh::model::getEntities(curves, 1);
        for (const auto &curve : curves)
          {
            std::vector<int>                      types;
            std::vector<std::vector<std::size_t>> elements, nodes;
            gmsh::model::mesh::getElements(types,
                                           elements,
                                           nodes,
                                           1,
                                           curve.second);
            for (std::size_t i = 0; i < types.size(); ++i)
              add_lines(types[i],
                        elements[i],
                        nodes[i],
                        curve.second,
                        mesh.lines);
          }
        if (mesh.lines.empty())
          throw InputError(
            where + file +
            " has no line elements, of which the struts are made.\nMesh the "
            "curves of the lattice (gmsh -1) and save them: of a model with "
            "physical groups, gmsh saves only what is in one of them.");
        std::sort(mesh.lines.begin(),
                  mesh.lines.end(),
                  [](const Line &a, const Line &b) { return a.tag < b.tag; });
      }

      void add_lines(const int                       type,
                     const std::vector<std::size_t> &elements,
                     const std::vector<std::size_t> &nodes,
                     const int                       curve,
                     std::vector<Line>              &lines) const
      {
        const int         line_of_2_nodes = 1, line_of_3_nodes = 8;
        const std::size_t n_nodes = nodes.size() / elements.size();
        if (type != line_of_2_nodes && type != line_of_3_nodes)
          throw InputError(
            where + file + " has line elements of " + std::to_string(n_nodes) +
            " nodes, for example element " + std::to_string(elements[0]) +
            ".\nAllowed are 2 nodes (straight struts) and 3 nodes (arcs): set "
            "Mesh.ElementOrder in gmsh to 1 or 2.");
        for (std::size_t i = 0; i < elements.size(); ++i)
          lines.push_back({elements[i],
                           nodes[n_nodes * i],
                           nodes[n_nodes * i + 1],
                           n_nodes == 3 ? nodes[n_nodes * i + 2] : no_node,
                           curve});
      }

      void read_groups(Mesh &mesh) const
      {
        gmsh::vectorpair groups;
        gmsh::model::getPhysicalGroups(groups);
        for (const auto &[dimension, tag] : groups)
          if (dimension == 0)
            add_point_group(tag, mesh);
          else if (dimension == 1)
            add_curve_group(tag, mesh);
      }

      void add_point_group(const int tag, Mesh &mesh) const
      {
        std::vector<std::size_t> nodes;
        std::vector<double>      coordinates;
        gmsh::model::mesh::getNodesForPhysicalGroup(0, tag, nodes, coordinates);
        auto &group = mesh.point_groups[name_of_group(0, tag)];
        group.insert(group.end(), nodes.begin(), nodes.end());
      }

      void add_curve_group(const int tag, Mesh &mesh) const
      {
        const std::string name = name_of_group(1, tag);
        std::vector<int>  curves;
        gmsh::model::getEntitiesForPhysicalGroup(1, tag, curves);
        for (const int curve : curves)
          mesh.groups_of_curve[std::abs(curve)].push_back(name);
      }

      std::string name_of_group(const int dimension, const int tag) const
      {
        std::string name;
        gmsh::model::getPhysicalName(dimension, tag, name);
        if (name == "all")
          throw InputError(where + file +
                           " has a physical group named \"all\", which is the "
                           "name of the set of all joints or struts.\nChoose "
                           "another name for the group.");
        return name.empty() ? "group " + std::to_string(tag) : name;
      }

      GmshSession       session;
      const std::string file;
      const std::string where;
      const double      unit;
    };

    /** Makes a unit cell of a mesh. */
    class MeshToCell
    {
    public:
      MeshToCell(const Mesh         &mesh,
                 const std::string  &file,
                 const SceneContext &context)
        : mesh(mesh)
        , is_planar(context.dimension == 2)
        , where(context.path + "/" + file_entry.name + ": in " + file + ", ")
        , tolerance(relative_tolerance * size())
      {}

      UnitCell build()
      {
        add_joints();
        for (const Line &line : mesh.lines)
          add_strut(line);
        add_joint_sets();
        cell.why_no_period.fill("A mesh file has no neighbour cells.");
        return std::move(cell);
      }

    private:
      /** Largest extent of the lines (m). */
      double size() const
      {
        const dealii::Point<3> start  = place(mesh.lines.front().first);
        dealii::Point<3>       lowest = start, highest = start;
        for (const Line &line : mesh.lines)
          for (const std::size_t node : {line.first, line.second})
            for (unsigned int d = 0; d < 3; ++d)
              {
                lowest[d]  = std::min(lowest[d], place(node)[d]);
                highest[d] = std::max(highest[d], place(node)[d]);
              }
        const dealii::Tensor<1, 3> extent = highest - lowest;
        return std::max({extent[0], extent[1], extent[2]});
      }

      const dealii::Point<3> &place(const std::size_t node) const
      {
        return mesh.places.at(node);
      }

      /**
       * In the plane without the round-off of a rotation in space, if it has
       * any.
       */
      dealii::Point<3> checked_place(const std::size_t node) const
      {
        const dealii::Point<3> &p = place(node);
        if (!is_planar)
          return p;
        if (std::abs(p[2]) > tolerance)
          throw InputError(where + "node " + std::to_string(node) +
                           " lies at " + place_text(p, 3) +
                           ".\nIn a planar scene all nodes of lines must have "
                           "z = 0. Set Dimension = 3 at the top of the "
                           "parameter file for a frame in space.");
        return {p[0], p[1], 0.};
      }

      void add_joints()
      {
        for (const Line &line : mesh.lines)
          for (const std::size_t node : {line.first, line.second})
            joint_of_node[node] = invalid_index;
        for (auto &[node, joint] : joint_of_node)
          {
            joint = cell.joints.size();
            cell.joints.push_back(checked_place(node));
          }
      }

      void add_strut(const Line &line)
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
      void set_shape(const Line &line, UnitStrut &strut) const
      {
        const dealii::Point<3>     start = checked_place(line.first);
        const dealii::Tensor<1, 3> chord = checked_place(line.second) - start;
        if (chord.norm() <= tolerance)
          throw InputError(text_of(line) +
                           " has zero length: its ends lie at the same place. "
                           "Remove it, or divide a ring into two or more "
                           "arcs.");
        if (line.middle == no_node)
          return;
        if (joint_of_node.count(line.middle) > 0)
          throw InputError(text_of(line) + " has node " +
                           std::to_string(line.middle) +
                           " in its middle, at which another line ends. "
                           "Struts meet at their ends only: divide the line "
                           "there.");

        const auto arc = arc_through(chord, checked_place(line.middle) - start);
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

      std::string text_of(const Line &line) const
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

      const Mesh                         &mesh;
      const bool                          is_planar;
      const std::string                   where;
      const double                        tolerance;
      UnitCell                            cell;
      std::map<std::size_t, unsigned int> joint_of_node;
      std::map<std::tuple<std::size_t, std::size_t, std::size_t>, unsigned int>
        strut_of_nodes;
    };

    std::unique_ptr<Cell> make_mesh_file(dealii::ParameterHandler &prm,
                                         const SceneContext       &context)
    {
      const std::string file =
        (std::filesystem::path(context.directory) / get(prm, file_entry))
          .string();
      prm.set(file_entry.name, absolute_file(get(prm, file_entry), context));
      const Mesh mesh = MeshReader(file, get(prm, length_unit), context).read();
      return std::make_unique<GivenCell>(
        MeshToCell(mesh, file, context).build());
    }
  } // namespace

  RegistryEntry<Cell> mesh_file_cell_entry()
  {
    return {"mesh file",
            "Frame from the line elements of a file that gmsh reads.",
            &declare_mesh_file,
            &make_mesh_file};
  }
} // namespace auxfem
