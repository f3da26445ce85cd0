#include <auxfem/mesh/cells/line_mesh.h>
#include <auxfem/mesh/cells/msh_tokens.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <unordered_set>

namespace auxfem
{
  namespace
  {
    constexpr long long line_of_2_nodes = 1, line_of_3_nodes = 8, point = 15;

    /** Number of nodes by gmsh's element type. */
    std::optional<unsigned int> n_nodes_of(const long long type)
    {
      static const std::map<long long, unsigned int> known = {
        {1, 2},   {2, 3},   {3, 4},   {4, 4},   {5, 8},   {6, 6},   {7, 5},
        {8, 3},   {9, 6},   {10, 9},  {11, 10}, {12, 27}, {13, 18}, {14, 14},
        {15, 1},  {16, 8},  {17, 20}, {18, 15}, {19, 13}, {20, 9},  {21, 10},
        {22, 12}, {23, 15}, {24, 15}, {25, 21}, {26, 4},  {27, 5},  {28, 6},
        {29, 20}, {30, 35}, {31, 56}};
      const auto entry = known.find(type);
      return entry == known.end() ? std::nullopt
                                  : std::optional<unsigned int>(entry->second);
    }

    bool is_line_of_more_nodes(const long long type)
    {
      return type == 26 || type == 27 || type == 28;
    }

    /** Reader of one file, section by section. */
    class MshFile
    {
    public:
      explicit MshFile(const std::string &content) : tokens(content)
      {}

      LineMesh read()
      {
        read_format();
        for (std::string word = tokens.next(); !word.empty();
             word             = tokens.next())
          read_section(word);
        std::sort(mesh.lines.begin(),
                  mesh.lines.end(),
                  [](const LineMesh::Line &a, const LineMesh::Line &b) {
                    return a.tag < b.tag;
                  });
        return std::move(mesh);
      }

    private:
      /** A point, curve, surface or volume, by dimension and number. */
      using Entity = std::pair<long long, long long>;

      void read_format()
      {
        std::string section = tokens.next();
        if (section == "$Comments")
          {
            skip(section);
            section = tokens.next();
          }
        if (section != "$MeshFormat")
          tokens.fail(
            "the file does not begin with $MeshFormat; scripts of gmsh "
            "have the ending .geo");
        const std::string version = tokens.next();
        if (version != "4.1" && version != "2" &&
            version.compare(0, 2, "2.") != 0)
          tokens.fail("version '" + version.substr(0, 30) +
                      "' of the format is not read, only 2 and 4.1");
        is_version_4                     = version == "4.1";
        const bool      holds_bytes      = tokens.integer("type of the file");
        const long long size_of_a_number = tokens.integer("size of a number");
        if (holds_bytes)
          {
            tokens.is_binary = true;
            tokens.skip_line();
            if (size_of_a_number != sizeof(double) ||
                tokens.integer("number 1 for the order of bytes") != 1)
              tokens.fail("the file is from a machine with another binary "
                          "format of numbers; save it as text");
          }
        end(section);
      }

      void read_section(const std::string &section)
      {
        if (section == "$PhysicalNames")
          read_physical_names();
        else if (section == "$Entities" && is_version_4)
          read_numbers(&MshFile::read_entities);
        else if (section == "$Nodes")
          read_numbers(is_version_4 ? &MshFile::read_nodes_4
                                    : &MshFile::read_nodes_2);
        else if (section == "$Elements")
          read_numbers(is_version_4 ? &MshFile::read_elements_4
                                    : &MshFile::read_elements_2);
        else if (section == "$PartitionedEntities")
          tokens.fail("the mesh is divided into partitions; save it without");
        else
          {
            skip(section);
            return;
          }
        end(section);
      }

      /** Numbers of a section may be binary from the next line on. */
      void read_numbers(void (MshFile::*read_them)())
      {
        if (tokens.is_binary && is_version_4)
          tokens.skip_line();
        (this->*read_them)();
      }

      void end(const std::string &section)
      {
        const std::string expected = "$End" + section.substr(1);
        const std::string word     = tokens.next();
        if (word != expected)
          tokens.fail((word.empty() ? "the file ends"
                                    : "'" + word.substr(0, 30) + "' is found") +
                      " where " + expected +
                      " is expected, after as many entries as the section " +
                      section + " announces");
      }

      /** Skips a section without nodes and lines, or a stray line. */
      void skip(const std::string &section)
      {
        if (section[0] != '$')
          tokens.skip_line();
        else if (!tokens.skip_to_end_of("$End" + section.substr(1)))
          tokens.fail("the file ends within the section " +
                      section.substr(0, 30));
      }

      /** Reads a number that is text in binary files, too. */
      long long number_as_text(const std::string &noun)
      {
        const bool is_binary = tokens.is_binary;
        tokens.is_binary     = false;
        const long long n    = tokens.count(noun);
        tokens.is_binary     = is_binary;
        return n;
      }

      void read_physical_names()
      {
        const bool is_binary = tokens.is_binary;
        tokens.is_binary     = false;
        const long long n    = tokens.count("number of physical names");
        for (long long i = 0; i < n; ++i)
          {
            const long long dimension = read_dimension();
            const long long group =
              tokens.integer("number of a physical group");
            names[{dimension, group}] = tokens.quoted();
          }
        tokens.is_binary = is_binary;
      }

      long long read_dimension()
      {
        const long long dimension = tokens.integer("dimension");
        if (dimension < 0 || dimension > 3)
          tokens.fail("the dimension " + std::to_string(dimension) +
                      " is not one of 0, 1, 2, 3");
        return dimension;
      }

      long long read_tag(const std::string &noun)
      {
        const long long tag = tokens.integer(noun);
        if (std::llabs(tag) > 2147483647)
          tokens.fail("the " + noun + " is too large");
        return tag;
      }

      void read_entities()
      {
        long long numbers[4];
        for (long long &n : numbers)
          n = tokens.long_count("number of entities");
        for (unsigned int dimension = 0; dimension < 4; ++dimension)
          for (long long i = 0; i < numbers[dimension]; ++i)
            {
              const long long tag = read_tag("number of an entity");
              for (unsigned int c = 0; c < (dimension == 0 ? 3 : 6); ++c)
                tokens.real("position of an entity");
              std::vector<long long> groups =
                read_tags("number of physical groups", "physical group");
              if (dimension > 0)
                read_tags("number of boundaries", "boundary");
              for (const long long group : groups)
                sets_of_entity[{dimension, tag}].push_back(
                  name_of_group(dimension, group));
            }
      }

      std::vector<long long> read_tags(const std::string &number,
                                       const std::string &one)
      {
        const long long        n = tokens.long_count(number);
        std::vector<long long> tags;
        for (long long i = 0; i < n; ++i)
          tags.push_back(read_tag("number of a " + one));
        return tags;
      }

      /** Name of a group; its number is negative for reversed curves. */
      std::string name_of_group(const long long dimension,
                                const long long group) const
      {
        const auto name = names.find({dimension, std::llabs(group)});
        return name == names.end() || name->second.empty()
          ? "group " + std::to_string(std::llabs(group))
          : name->second;
      }

      long long checked_node(const long long tag) const
      {
        if (tag < 1)
          tokens.fail("the node number " + std::to_string(tag) +
                      " is not positive");
        return tag;
      }

      void read_position(const long long node, const long long n_parameters)
      {
        dealii::Point<3> position;
        for (unsigned int d = 0; d < 3; ++d)
          position[d] = tokens.real("coordinate of a node");
        for (long long i = 0; i < n_parameters; ++i)
          tokens.real("parameter of a node");
        mesh.positions[node] = position;
      }

      void read_nodes_2()
      {
        const long long n = number_as_text("number of nodes");
        if (tokens.is_binary)
          tokens.skip_line();
        for (long long i = 0; i < n; ++i)
          read_position(checked_node(tokens.integer("number of a node")), 0);
      }

      void read_nodes_4()
      {
        const long long n_blocks = tokens.long_count("number of node blocks");
        const long long n        = tokens.long_count("number of nodes");
        tokens.long_integer("smallest node number");
        tokens.long_integer("largest node number");
        long long n_read = 0;
        for (long long block = 0; block < n_blocks; ++block)
          {
            const long long dimension = read_dimension();
            const Entity entity = {dimension, read_tag("number of an entity")};
            const bool   is_parametric = tokens.integer("0 or 1") != 0;
            const long long size =
              tokens.long_count("number of nodes of a block");
            std::vector<long long> nodes;
            for (long long i = 0; i < size; ++i)
              nodes.push_back(
                checked_node(tokens.long_integer("number of a node")));
            for (const long long node : nodes)
              {
                read_position(node, is_parametric ? dimension : 0);
                if (dimension == 0)
                  add_point(node, sets_of(entity));
              }
            n_read += size;
          }
        expect_total(n, n_read, "nodes");
      }

      const std::vector<std::string> &sets_of(const Entity &entity) const
      {
        static const std::vector<std::string> none;
        const auto sets = sets_of_entity.find(entity);
        return sets == sets_of_entity.end() ? none : sets->second;
      }

      void add_point(const long long node, const std::vector<std::string> &sets)
      {
        for (const std::string &set : sets)
          {
            std::vector<std::size_t> &nodes = mesh.node_sets[set];
            if (points_of_set[set].insert(node).second)
              nodes.push_back(node);
          }
      }

      void expect_total(const long long    announced,
                        const long long    n_read,
                        const std::string &noun) const
      {
        if (announced != n_read)
          tokens.fail(std::to_string(announced) + ' ' + noun +
                      " are announced, but the blocks have " +
                      std::to_string(n_read));
      }

      unsigned int n_nodes_of_element(const long long element,
                                      const long long type) const
      {
        constexpr long long largest_type = 140;
        if (type < 1 || type > largest_type)
          tokens.fail("the element type " + std::to_string(type) +
                      " is none of gmsh's");
        const std::optional<unsigned int> n_nodes = n_nodes_of(type);
        if (!n_nodes || is_line_of_more_nodes(type))
          tokens.fail(
            (n_nodes ? "line elements of " + std::to_string(*n_nodes) + " nodes"
                     : "elements of type " + std::to_string(type)) +
            " are not read, for example element " + std::to_string(element) +
            ". Allowed are lines of 2 nodes (straight struts) and 3 nodes "
            "(arcs): set Mesh.ElementOrder in gmsh to 1 or 2");
        return *n_nodes;
      }

      /** Adds a line or point element; skips others. */
      void read_connectivity(const long long                 element,
                             const long long                 type,
                             const std::vector<std::string> &sets)
      {
        const unsigned int     n_nodes = n_nodes_of_element(element, type);
        std::vector<long long> nodes;
        for (unsigned int i = 0; i < n_nodes; ++i)
          {
            const std::string noun =
              "node of element " + std::to_string(element);
            const long long node =
              is_version_4 ? tokens.long_integer(noun) : tokens.integer(noun);
            if (mesh.positions.count(node) == 0)
              tokens.fail("element " + std::to_string(element) + " has node " +
                          std::to_string(node) +
                          ", which is not one of the file's nodes");
            nodes.push_back(node);
          }
        if (type == line_of_2_nodes || type == line_of_3_nodes)
          mesh.lines.push_back({static_cast<std::size_t>(element),
                                static_cast<std::size_t>(nodes[0]),
                                static_cast<std::size_t>(nodes[1]),
                                type == line_of_3_nodes
                                  ? static_cast<std::size_t>(nodes[2])
                                  : LineMesh::no_node,
                                sets});
        else if (type == point)
          add_point(nodes[0], sets);
      }

      void read_element_2(const long long type, const long long n_tags)
      {
        const long long element = tokens.integer("number of an element");
        read_element_2(element, type, n_tags);
      }

      /** Reads tags and nodes; the first tag is the physical group or 0. */
      void read_element_2(const long long element,
                          const long long type,
                          const long long n_tags)
      {
        long long group = 0;
        for (long long i = 0; i < n_tags; ++i)
          {
            const long long tag = read_tag("tag of an element");
            group               = i == 0 ? tag : group;
          }
        const long long dimension = type == point ? 0 : 1;
        read_connectivity(element,
                          type,
                          group == 0 ? std::vector<std::string>()
                                     : std::vector<std::string>{
                                         name_of_group(dimension, group)});
      }

      void read_elements_2()
      {
        const long long n = number_as_text("number of elements");
        if (tokens.is_binary)
          {
            tokens.skip_line();
            read_binary_elements_2(n);
            return;
          }
        for (long long i = 0; i < n; ++i)
          {
            const long long element = tokens.integer("number of an element");
            const long long type    = tokens.integer("type of an element");
            read_element_2(element, type, tokens.count("number of tags"));
          }
      }

      /** Reads blocks of elements with the same type and number of tags. */
      void read_binary_elements_2(const long long n)
      {
        for (long long n_read = 0; n_read < n;)
          {
            const long long type = tokens.integer("type of an element");
            const long long size =
              tokens.count("number of elements of a block");
            const long long n_tags = tokens.count("number of tags");
            if (size == 0)
              tokens.fail("a block has no elements");
            for (long long i = 0; i < size; ++i)
              read_element_2(type, n_tags);
            n_read += size;
          }
      }

      void read_elements_4()
      {
        const long long n_blocks =
          tokens.long_count("number of element blocks");
        const long long n = tokens.long_count("number of elements");
        tokens.long_integer("smallest element number");
        tokens.long_integer("largest element number");
        long long n_read = 0;
        for (long long block = 0; block < n_blocks; ++block)
          {
            const long long dimension = read_dimension();
            const Entity entity  = {dimension, read_tag("number of an entity")};
            const long long type = tokens.integer("type of an element");
            const long long size =
              tokens.long_count("number of elements of a block");
            for (long long i = 0; i < size; ++i)
              {
                const long long element =
                  tokens.long_integer("number of an element");
                read_connectivity(element, type, sets_of(entity));
              }
            n_read += size;
          }
        expect_total(n, n_read, "elements");
      }

      MshTokens                                            tokens;
      bool                                                 is_version_4 = false;
      LineMesh                                             mesh;
      std::map<Entity, std::string>                        names;
      std::map<Entity, std::vector<std::string>>           sets_of_entity;
      std::map<std::string, std::unordered_set<long long>> points_of_set;
    };
  } // namespace

  LineMesh read_msh(const std::string &content)
  {
    return MshFile(content).read();
  }
} // namespace auxfem
