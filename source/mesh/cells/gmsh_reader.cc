#include <auxfem/mesh/cells/gmsh_reader.h>
#include <auxfem/mesh/cells/msh_format.h>
#include <auxfem/mesh/cells/separate_process.h>
#include <auxfem/parameters/input_file.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>

#include <gmsh.h>

namespace auxfem
{
  namespace
  {
    namespace fs = std::filesystem;

    /** Memory that gmsh may take for a mesh of curves (bytes). */
    constexpr std::size_t most_memory = std::size_t(4) << 30;

    /** Formats that gmsh tells by the ending, and how such files begin. */
    const std::map<std::string, std::string> beginnings = {
      {".vtk", "# vtk DataFile"},
      {".unv", "    -1"},
      {".mesh", "MeshVersionFormatted"}};

    /** A new folder that nobody else may use; removed with the object. */
    class PrivateFolder
    {
    public:
      PrivateFolder()
        : path((fs::temp_directory_path() / "auxfem_XXXXXX").string())
      {
        if (mkdtemp(path.data()) == nullptr)
          throw MeshMistake{"no temporary folder " + path +
                            " can be made for its answer"};
      }

      ~PrivateFolder()
      {
        std::error_code ignored;
        fs::remove_all(path, ignored);
      }

      PrivateFolder(const PrivateFolder &)            = delete;
      PrivateFolder &operator=(const PrivateFolder &) = delete;

      std::string file(const std::string &name) const
      {
        return path + "/" + name;
      }

    private:
      std::string path;
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
        // gmsh would else leave its parser by an exception.
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

      /** The first of gmsh's error messages; empty if none. */
      std::string errors() const
      {
        const std::string        mark = "Error: ";
        std::vector<std::string> log;
        gmsh::logger::get(log);
        std::string  text;
        unsigned int n_shown = 0;
        for (const auto &message : log)
          if (message.compare(0, mark.size(), mark) == 0 && n_shown++ < 3)
            text += (text.empty() ? "" : "\n  ") + message.substr(mark.size());
        return text;
      }
    };

    /** Meshes the curves of @p file into @p result; gmsh's errors, or none. */
    std::string mesh_curves(const std::string &file, const std::string &result)
    {
      try
        {
          const GmshSession session;
          gmsh::open(file);
          std::vector<std::size_t> nodes;
          std::vector<double>      coordinates, unused;
          gmsh::model::mesh::getNodes(nodes, coordinates, unused);
          // Where the parser failed, meshing would only add further errors.
          if (nodes.empty() && session.errors().empty())
            gmsh::model::mesh::generate(1);
          gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
          // As text, coordinates would lose their last digit.
          gmsh::option::setNumber("Mesh.Binary", 1);
          // Also lines outside of all groups are struts.
          gmsh::option::setNumber("Mesh.SaveAll", 1);
          gmsh::write(result);
          return session.errors();
        }
      catch (const std::bad_alloc &)
        {
          return "gmsh needs more memory than the " +
            std::to_string(most_memory >> 30) + " GB that it may take";
        }
      catch (const std::exception &error)
        {
          return error.what();
        }
      catch (const std::string &message)
        {
          return message;
        }
    }

    LineMesh mesh_of_curves(const std::string   &file,
                            const PrivateFolder &folder,
                            const double         seconds)
    {
      const std::string result = folder.file("result.msh");
      std::string       errors;
      try
        {
          errors =
            run_in_separate_process([&]() { return mesh_curves(file, result); },
                                    {seconds, most_memory});
        }
      catch (const CrashedProcess &crash)
        {
          errors = "gmsh has failed: " + crash.how +
            (crash.is_out_of_time ? ", the Gmsh time limit" : "");
        }
      if (!errors.empty())
        throw MeshMistake{errors};
      try
        {
          return read_msh(read_input_file(result));
        }
      catch (const UnreadableFile &unreadable)
        {
          throw MeshMistake{"its answer " + unreadable.reason};
        }
    }
  } // namespace

  LineMesh run_gmsh_script(const std::string &file, const double seconds)
  {
    return mesh_of_curves(file, PrivateFolder(), seconds);
  }

  bool gmsh_reads(const std::string &ending)
  {
    return beginnings.count(ending) > 0;
  }

  LineMesh read_with_gmsh(const std::string &content,
                          const std::string &ending,
                          const double       seconds)
  {
    const std::string &beginning = beginnings.at(ending);
    if (content.compare(0, beginning.size(), beginning) != 0)
      throw MeshMistake{"the file does not begin with \"" + beginning + "\""};
    // gmsh runs FILE.opt beside a file, and its readers look at the ending
    // only.
    const PrivateFolder folder;
    const std::string   copy = folder.file("mesh" + ending);
    std::ofstream(copy, std::ios::binary) << content;
    return mesh_of_curves(copy, folder, seconds);
  }
} // namespace auxfem
