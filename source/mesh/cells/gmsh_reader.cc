#include <auxfem/mesh/cells/gmsh_reader.h>
#include <auxfem/mesh/cells/msh_format.h>
#include <auxfem/mesh/cells/separate_process.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/utilities.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>

#include <gmsh.h>

namespace auxfem
{
  namespace
  {
    std::string cannot_read(const std::string &where,
                            const std::string &file,
                            const std::string &messages)
    {
      return where + "gmsh cannot read " + file + ":" + messages +
        "\nCorrect the file, or write it anew with gmsh.";
    }

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
      MeshReader(const std::string &file,
                 const double       unit,
                 const std::string &where)
        : file(file)
        , where(where)
        , unit(unit)
      {}

      LineMesh read() const
      {
        try
          {
            open();
            LineMesh mesh;
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
        throw InputError(cannot_read(where, file, messages));
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

      void read_nodes(LineMesh &mesh) const
      {
        std::vector<std::size_t> nodes;
        std::vector<double>      x, unused;
        gmsh::model::mesh::getNodes(nodes, x, unused);
        for (std::size_t i = 0; i < nodes.size(); ++i)
          mesh.positions[nodes[i]] = {unit * x[3 * i],
                                      unit * x[3 * i + 1],
                                      unit * x[3 * i + 2]};
      }

      void read_lines(LineMesh &mesh) const
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
                  [](const LineMesh::Line &a, const LineMesh::Line &b) {
                    return a.tag < b.tag;
                  });
      }

      void add_lines(const int                       type,
                     const std::vector<std::size_t> &elements,
                     const std::vector<std::size_t> &nodes,
                     const int                       curve,
                     std::vector<LineMesh::Line>    &lines) const
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
          lines.push_back(
            {elements[i],
             nodes[n_nodes * i],
             nodes[n_nodes * i + 1],
             n_nodes == 3 ? nodes[n_nodes * i + 2] : LineMesh::no_node,
             curve});
      }

      void read_groups(LineMesh &mesh) const
      {
        gmsh::vectorpair groups;
        gmsh::model::getPhysicalGroups(groups);
        for (const auto &[dimension, tag] : groups)
          if (dimension == 0)
            add_point_group(tag, mesh);
          else if (dimension == 1)
            add_curve_group(tag, mesh);
      }

      void add_point_group(const int tag, LineMesh &mesh) const
      {
        std::vector<std::size_t> nodes;
        std::vector<double>      coordinates;
        gmsh::model::mesh::getNodesForPhysicalGroup(0, tag, nodes, coordinates);
        auto &group = mesh.point_groups[name_of_group(0, tag)];
        group.insert(group.end(), nodes.begin(), nodes.end());
      }

      void add_curve_group(const int tag, LineMesh &mesh) const
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

    constexpr char is_mesh = 'm', is_message = 'e';

    /** A packed LineMesh or a message, told apart by the first letter. */
    std::string answer_of_gmsh(const std::string &file,
                               const double       unit,
                               const std::string &where)
    {
      try
        {
          const std::vector<char> mesh =
            dealii::Utilities::pack(MeshReader(file, unit, where).read(),
                                    /*allow_compression=*/false);
          return is_mesh + std::string(mesh.begin(), mesh.end());
        }
      catch (const InputError &error)
        {
          return is_message + std::string(error.what());
        }
      catch (const std::exception &error)
        {
          return is_message +
            cannot_read(where, file, "\n  " + std::string(error.what()));
        }
    }
  } // namespace

  LineMesh read_with_gmsh(const std::string &file,
                          const double       unit,
                          const std::string &where,
                          const std::string &directory)
  {
    // gmsh takes a file that does not exist as the name of a new model.
    const std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file))
      throw InputError(where + "cannot read the mesh file " + file +
                       ".\nGive the name of a file that gmsh reads; a relative "
                       "name starts from the folder of the parameter file (" +
                       directory + ").");
    const std::string mistake = mistake_in_mesh_file(file);
    if (!mistake.empty())
      throw InputError(where + "the mesh file " + file + " is damaged:\n  " +
                       mistake +
                       "\nCorrect the file, or write it anew with gmsh.");
    std::string answer;
    try
      {
        answer = run_in_separate_process(
          [&]() { return answer_of_gmsh(file, unit, where); });
      }
    catch (const CrashedProcess &crash)
      {
        throw InputError(
          cannot_read(where,
                      file,
                      "\n  its reader crashes (" + crash.how +
                        "), as it does on damaged or truncated files."));
      }
    if (answer.empty() || answer[0] != is_mesh)
      throw InputError(answer.substr(std::min<std::size_t>(1, answer.size())));
    return dealii::Utilities::unpack<LineMesh>(
      std::vector<char>(answer.begin() + 1, answer.end()),
      /*allow_compression=*/false);
  }
} // namespace auxfem
