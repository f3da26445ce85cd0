#include <auxfem/mesh/cells/line_mesh.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::trim;

    std::string upper_case(std::string text)
    {
      for (char &letter : text)
        letter = std::toupper(static_cast<unsigned char>(letter));
      return text;
    }

    bool begins_with(const std::string &text, const std::string &beginning)
    {
      return text.compare(0, beginning.size(), beginning) == 0;
    }

    std::string join(const std::set<std::string> &words)
    {
      std::string text;
      for (const std::string &word : words)
        text += (text.empty() ? "" : ", ") + word;
      return text;
    }

    /** Cells between commas; an empty last cell does not count. */
    std::vector<std::string> cells_of(const std::string &line)
    {
      std::vector<std::string> cells;
      std::istringstream       stream(line);
      for (std::string cell; std::getline(stream, cell, ',');)
        cells.push_back(trim(cell));
      return cells;
    }

    /** Number of nodes of element types that are struts, without the final
     * letter H (hybrid) of their names in the Abaqus manual. */
    const std::map<std::string, unsigned int> strut_types = {{"B21", 2},
                                                             {"B22", 3},
                                                             {"B23", 2},
                                                             {"B31", 2},
                                                             {"B32", 3},
                                                             {"B33", 2},
                                                             {"T2D2", 2},
                                                             {"T3D2", 2}};

    /** Refused keywords: they make nodes, elements or sets in ways that are not
     * read, so that a part of the frame would be missing. */
    const std::set<std::string> refused_keywords = {"NGEN",
                                                    "NFILL",
                                                    "NCOPY",
                                                    "NMAP",
                                                    "ELGEN",
                                                    "ELCOPY",
                                                    "INCLUDE",
                                                    "SYSTEM",
                                                    "PARAMETER"};

    const std::set<std::string> keywords_of_parts = {"PART",
                                                     "INSTANCE",
                                                     "ASSEMBLY"};

    /** A set of numbers with its name as first written. */
    struct NumberSet
    {
      std::string           name;
      std::set<std::size_t> members;
    };

    /** Sets by upper-case names, as Abaqus ignores case. */
    using NumberSets = std::map<std::string, NumberSet>;

    /** Reader of one file, line by line. */
    class AbaqusFile
    {
    public:
      explicit AbaqusFile(const std::string &content) : stream(content)
      {}

      LineMesh read()
      {
        for (std::string text; next_line(text);)
          if (text[0] == '*')
            begin_keyword(text);
          else if (keyword.empty())
            fail("the file does not begin with a keyword, as *HEADING or "
                 "*NODE");
          else
            read_data(text);
        if (keyword.empty())
          fail("the file has no keyword, as *NODE");
        finish();
        return std::move(mesh);
      }

    private:
      /** The next line that is neither empty nor a comment. */
      bool next_line(std::string &text)
      {
        while (std::getline(stream, text))
          {
            ++line;
            text = trim(text);
            if (!text.empty() && !begins_with(text, "**"))
              return true;
          }
        return false;
      }

      [[noreturn]] void fail(const std::string &problem) const
      {
        throw MeshMistake{"line " + std::to_string(line) + ": " + problem};
      }

      void begin_keyword(std::string text)
      {
        for (std::string more; text.back() == ',' && next_line(more);)
          text += more;
        std::vector<std::string> cells = cells_of(text.substr(1));
        if (cells.empty() || cells[0].empty() ||
            !std::isalpha(static_cast<unsigned char>(cells[0][0])))
          fail("a keyword is expected behind *");
        keyword = upper_case(cells[0]);
        parameters.clear();
        for (std::size_t i = 1; i < cells.size(); ++i)
          {
            const std::size_t equals = cells[i].find('=');
            const std::string name =
              upper_case(trim(cells[i].substr(0, equals)));
            std::string value = equals == std::string::npos
              ? ""
              : trim(cells[i].substr(equals + 1));
            if (value.size() > 1 && value.front() == '"' && value.back() == '"')
              value = value.substr(1, value.size() - 2);
            parameters[name] = value;
          }
        check_keyword();
      }

      void check_keyword()
      {
        if (keywords_of_parts.count(keyword) > 0 ||
            parameters.count("INSTANCE") > 0)
          fail(
            "*" + keyword +
            ": parts and instances are not read. Write a flat input file, in "
            "Abaqus/CAE by the model attribute \"Do not use parts and "
            "assemblies in input files\"");
        if (refused_keywords.count(keyword) > 0)
          fail("*" + keyword +
               " is not read. Write every node, element and member of a set "
               "into the file");
        const bool is_read = keyword == "NODE" || keyword == "ELEMENT" ||
          keyword == "NSET" || keyword == "ELSET";
        if (is_read)
          begin_block();
        else if (keyword != "HEADING" && keyword != "PREPRINT" &&
                 !begins_with(keyword, "END "))
          skipped.insert("*" + keyword);
      }

      void begin_block()
      {
        for (const char *name : {"INPUT", "SYSTEM", "ELSET OFFSET"})
          if (parameters.count(name) > 0)
            fail("*" + keyword + " with " + name +
                 " is not read. Write the data without it");
        if (keyword == "ELEMENT")
          begin_elements();
        else if (keyword != "NODE" && parameters[keyword].empty())
          fail("*" + keyword + " has no name: " + keyword + "=NAME is missing");
      }

      void begin_elements()
      {
        type = upper_case(parameters["TYPE"]);
        const bool is_truss =
          begins_with(type, "T2D") || begins_with(type, "T3D");
        std::string base = type;
        if (base.size() > 1 && base.back() == 'H')
          base.pop_back();
        const auto known = strut_types.find(base);
        n_nodes          = known == strut_types.end() ? 0 : known->second;
        if (n_nodes > 0 && is_truss)
          trusses.insert(type);
        if (n_nodes > 0)
          return;
        if (is_truss || begins_with(type, "B2") || begins_with(type, "B3") ||
            begins_with(type, "PIPE") || begins_with(type, "FRAME"))
          fail("elements of type " + type +
               " are not read; those of types B21, B22, B23, B31, B32, B33, "
               "T2D2, T3D2 are");
        skipped.insert("elements of type " + type);
      }

      void read_data(const std::string &text)
      {
        if (keyword == "NODE")
          read_node(cells_of(text));
        else if (keyword == "ELEMENT" && n_nodes > 0)
          read_element(text);
        else if (keyword == "NSET")
          read_members(cells_of(text), node_sets);
        else if (keyword == "ELSET")
          read_members(cells_of(text), element_sets);
      }

      std::size_t number(const std::string &cell, const std::string &noun) const
      {
        std::size_t value = 0;
        const auto  answer =
          std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (answer.ec != std::errc() ||
            answer.ptr != cell.data() + cell.size() || value == 0)
          fail("'" + cell.substr(0, 30) + "' is found where the " + noun +
               ", a positive whole number, is expected");
        return value;
      }

      double coordinate(std::string cell) const
      {
        if (cell.empty())
          return 0;
        // Fortran writes exponents of double precision with D.
        std::replace_if(
          cell.begin(),
          cell.end(),
          [](const char letter) { return letter == 'd' || letter == 'D'; },
          'e');
        double            value  = 0;
        const char *const begin  = cell.data() + (cell[0] == '+' ? 1 : 0);
        const char *const end    = cell.data() + cell.size();
        const auto        answer = std::from_chars(begin, end, value);
        if (answer.ec != std::errc() || answer.ptr != end ||
            !std::isfinite(value))
          fail("'" + cell.substr(0, 30) +
               "' is found where a coordinate, a number, is expected");
        return value;
      }

      void read_node(const std::vector<std::string> &cells)
      {
        const std::size_t node = number(cells[0], "number of a node");
        dealii::Point<3>  position;
        for (unsigned int d = 0; d < 3 && d + 1 < cells.size(); ++d)
          position[d] = coordinate(cells[d + 1]);
        const auto known = mesh.positions.emplace(node, position);
        if (!known.second && known.first->second != position)
          fail("node " + std::to_string(node) +
               " is given a second time, at another place");
        add_to(node_sets, "NSET", node);
      }

      /** Adds @p number to the set that the keyword names, if any. */
      void
      add_to(NumberSets &sets, const std::string &parameter, std::size_t number)
      {
        const auto name = parameters.find(parameter);
        if (name != parameters.end())
          set_named(sets, name->second).members.insert(number);
      }

      static NumberSet &set_named(NumberSets &sets, const std::string &name)
      {
        NumberSet &set = sets[upper_case(name)];
        if (set.name.empty())
          set.name = name;
        return set;
      }

      void read_element(const std::string &text)
      {
        const std::vector<std::string> cells = cells_of(text);
        const std::size_t element = number(cells[0], "number of an element");
        // Beams in space may have another node that orients their section.
        const bool has_direction =
          cells.size() == 2 + n_nodes && begins_with(type, "B3");
        if (cells.size() != 1 + n_nodes && !has_direction)
          fail("element " + std::to_string(element) + " of type " + type +
               " has " + std::to_string(cells.size() - 1) +
               " nodes; needed are " + std::to_string(n_nodes));
        if (has_direction)
          skipped.insert("nodes for the direction of sections");
        if (!elements.insert(element).second)
          fail("element " + std::to_string(element) +
               " is given a second time");
        std::vector<std::size_t> nodes;
        for (std::size_t i = 1; i <= n_nodes; ++i)
          nodes.push_back(
            number(cells[i], "node of element " + std::to_string(element)));
        mesh.lines.push_back({element,
                              nodes.front(),
                              nodes.back(),
                              n_nodes == 3 ? nodes[1] : LineMesh::no_node,
                              {type}});
        line_of_element[element] = line;
        add_to(element_sets, "ELSET", element);
      }

      void read_members(const std::vector<std::string> &cells, NumberSets &sets)
      {
        NumberSet &set = set_named(sets, parameters[keyword]);
        if (parameters.count("GENERATE") > 0)
          return generate(cells, set);
        for (const std::string &cell : cells)
          if (cell.empty())
            continue;
          else if (std::isdigit(static_cast<unsigned char>(cell[0])))
            set.members.insert(number(cell, "member of a set"));
          else
            {
              const auto other = sets.find(upper_case(cell));
              if (other == sets.end())
                fail("there is no set " + cell + " before this line");
              const std::set<std::size_t> members = other->second.members;
              set.members.insert(members.begin(), members.end());
            }
      }

      void generate(const std::vector<std::string> &cells, NumberSet &set) const
      {
        if (cells.size() < 2 || cells.size() > 3)
          fail("GENERATE needs the first number, the last, and their distance");
        const std::size_t first = number(cells[0], "first member"),
                          last  = number(cells[1], "last member"),
                          step  = cells.size() == 3
           ? number(cells[2], "distance")
           : 1;
        // No mesh with more members fits into memory.
        constexpr std::size_t max_members = 100000000;
        if (last < first || (last - first) / step >= max_members)
          fail("no set can be generated from " + cells[0] + " to " + cells[1]);
        for (std::size_t member = first; member <= last; member += step)
          set.members.insert(member);
      }

      void finish()
      {
        std::set<std::size_t> ends;
        for (LineMesh::Line &one : mesh.lines)
          {
            for (const std::size_t node : {one.first, one.second, one.middle})
              if (node != LineMesh::no_node && mesh.positions.count(node) == 0)
                throw MeshMistake{"line " +
                                  std::to_string(line_of_element[one.tag]) +
                                  ": element " + std::to_string(one.tag) +
                                  " has node " + std::to_string(node) +
                                  ", which is not one of the file's nodes"};
            ends.insert({one.first, one.second});
            for (const auto &[ignored, set] : element_sets)
              if (set.members.count(one.tag) > 0)
                one.sets.push_back(set.name);
          }
        std::sort(mesh.lines.begin(),
                  mesh.lines.end(),
                  [](const LineMesh::Line &a, const LineMesh::Line &b) {
                    return a.tag < b.tag;
                  });
        add_node_sets(ends);
        add_notes();
      }

      void add_node_sets(const std::set<std::size_t> &ends)
      {
        for (const auto &[ignored, set] : node_sets)
          {
            std::vector<std::size_t> &nodes = mesh.node_sets[set.name];
            std::set_intersection(set.members.begin(),
                                  set.members.end(),
                                  ends.begin(),
                                  ends.end(),
                                  std::back_inserter(nodes));
            if (nodes.size() < set.members.size())
              mesh.notes.push_back(
                "The node set " + set.name + " has " +
                std::to_string(set.members.size() - nodes.size()) +
                " nodes at which no strut ends; they are not in the joint "
                "set.");
          }
      }

      void add_notes()
      {
        if (!trusses.empty())
          mesh.notes.push_back(
            "Elements of type " + join(trusses) +
            " carry axial forces only, but struts are clamped to their "
            "joints. Add hinges (Joints) for the strut set of that name.");
        if (!skipped.empty())
          mesh.notes.push_back(
            "Only nodes, elements and sets of the input file are read. "
            "Skipped: " +
            join(skipped) +
            ". Give Sections, Supports, Loads in the parameter file.");
      }

      std::istringstream                 stream;
      std::size_t                        line = 0;
      std::string                        keyword;
      std::map<std::string, std::string> parameters;
      std::string                        type;        ///< of elements
      unsigned int                       n_nodes = 0; ///< 0: type is skipped
      LineMesh                           mesh;
      std::set<std::size_t>              elements;
      std::map<std::size_t, std::size_t> line_of_element;
      NumberSets                         node_sets, element_sets;
      std::set<std::string>              trusses, skipped;
    };
  } // namespace

  LineMesh read_abaqus(const std::string &content)
  {
    return AbaqusFile(content).read();
  }
} // namespace auxfem
