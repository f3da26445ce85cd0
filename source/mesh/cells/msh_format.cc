#include <auxfem/mesh/cells/msh_format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <unordered_set>

namespace auxfem
{
  namespace
  {
    /** A mistake in the file, with its line. */
    struct Mistake
    {
      std::string text;
    };

    /** Numbers of nodes by gmsh's number of the element type. */
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

    /** Words of a text file, wherever its lines break. */
    class Words
    {
    public:
      explicit Words(const std::string &file) : stream(file, std::ios::binary)
      {
        stream.seekg(0, std::ios::end);
        size = stream.tellg();
        stream.seekg(0);
      }

      /** Empty at the end of the file. */
      std::string next()
      {
        std::string word;
        for (int c = stream.get(); c != std::char_traits<char>::eof();
             c     = stream.get())
          {
                const bool is_blank =
                  c == ' ' || c == '\n' || c == '\t' || c == '\r';
                if (is_blank && !word.empty())
              {
                    stream.unget();
                    return word;
              }
            if (c == '\n')
              ++line;
            if (!is_blank)
              word += char(c);
          }
        return word;
      }

      void skip_line()
      {
        std::string rest;
        if (std::getline(stream, rest))
          ++line;
      }

      /** The next word in quotes. */
      void skip_quoted()
      {
        std::string text;
        if (next_is_no_quote() || !std::getline(stream, text, '"'))
          fail("a name in double quotes is expected");
        if (text.find('\n') != std::string::npos)
          fail("a name has no closing double quote");
      }

      long long integer(const std::string &what)
      {
        return number<long long>(what, "a whole number");
      }

      /** An integer that counts things of at least one byte each. */
      long long count(const std::string &what)
      {
        const long long n = integer(what);
        if (n < 0 || n > size)
          fail("the " + what + " is " + std::to_string(n) +
               ", and a file of this size cannot hold so many");
        return n;
      }

      void real(const std::string &what)
      {
        if (!std::isfinite(number<double>(what, "a number")))
          fail("the " + what + " is not finite");
      }

      [[noreturn]] void fail(const std::string &what) const
      {
        throw Mistake{"line " + std::to_string(line) + ": " + what};
      }

    private:
      bool next_is_no_quote()
      {
        stream >> std::ws;
        return stream.get() != '"';
      }

      template <class Number>
      Number number(const std::string &what, const std::string &kind)
      {
        constexpr std::size_t n_shown = 30;
        const std::string     word    = next();
        Number                value{};
        const char *const     begin =
          word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
        const char *const end    = word.data() + word.size();
        const auto        answer = std::from_chars(begin, end, value);
        if (word.empty())
          fail("the file ends where the " + what + " is expected");
        if (answer.ec != std::errc() || answer.ptr != end)
          fail("'" + word.substr(0, n_shown) + "' is found where the " + what +
               ", " + kind + ", is expected");
        return value;
      }

      std::ifstream stream;
      long long     size = 0;
      unsigned long line = 1;
    };

    /** The sections of one file. */
    class MshFile
    {
    public:
      explicit MshFile(const std::string &file) : words(file)
      {}

      void check()
      {
        for (std::string word = words.next(); !word.empty();
             word             = words.next())
          {
                        if (word == "$MeshFormat")
              read_format();
            else if (format == Format::other)
              return;
            else if (word == "$PhysicalNames")
              read_physical_names();
            else if (word == "$Entities" && format == Format::four)
              read_entities();
            else if (word == "$Nodes")
              format == Format::four ? read_nodes_4() : read_nodes_2();
            else if (word == "$Elements")
              format == Format::four ? read_elements_4() : read_elements_2();
            else
              {
                            skip(word);
                            continue;
              }
            if (format != Format::other)
              end(word);
          }
      }

    private:
      enum class Format
      {
        two,
        four,
        other
      };

      void read_format()
      {
        const std::string version   = words.next();
        const bool        is_binary = words.integer("type of the file") != 0;
        words.integer("size of a number");
        if (is_binary)
          format = Format::other;
        else if (version == "4.1")
          format = Format::four;
        else if (version == "2" || version.compare(0, 2, "2.") == 0)
          format = Format::two;
        else
          format = Format::other;
      }

      void end(const std::string &section)
      {
        const std::string expected = "$End" + section.substr(1);
        const std::string word     = words.next();
        if (word != expected)
          words.fail((word.empty() ? "the file ends"
                                   : "'" + word.substr(0, 30) + "' is found") +
                     " where " + expected +
                     " is expected, after as many entries as the section " +
                     section + " announces");
      }

      /** A section that says nothing of nodes and lines, or a stray line. */
      void skip(const std::string &section)
      {
        if (section[0] != '$')
          {
            words.skip_line();
            return;
          }
        const std::string last = "$End" + section.substr(1);
        std::string       word = words.next();
        while (!word.empty() && word != last)
          word = words.next();
        if (word.empty())
          words.fail("the file ends within the section " +
                     section.substr(0, 30));
      }

      void read_physical_names()
      {
        const long long n = words.count("number of physical names");
        for (long long i = 0; i < n; ++i)
          {
            read_dimension();
            words.integer("number of a physical group");
            words.skip_quoted();
          }
      }

      long long read_dimension()
      {
        const long long dimension = words.integer("dimension");
        if (dimension < 0 || dimension > 3)
          words.fail("the dimension " + std::to_string(dimension) +
                     " is not one of 0, 1, 2, 3");
        return dimension;
      }

      void read_tag(const std::string &what)
      {
        const long long tag = words.integer(what);
        if (std::llabs(tag) > 2147483647)
          words.fail("the " + what + " is too large");
      }

      void read_entities()
      {
        long long numbers[4];
        for (long long &n : numbers)
          n = words.count("number of entities");
        for (unsigned int dimension = 0; dimension < 4; ++dimension)
          for (long long i = 0; i < numbers[dimension]; ++i)
            {
              read_tag("number of an entity");
              for (unsigned int c = 0; c < (dimension == 0 ? 3 : 6); ++c)
                words.real("position of an entity");
              read_tags("number of physical groups", "physical group");
              if (dimension > 0)
                read_tags("number of boundaries", "boundary");
            }
      }

      void read_tags(const std::string &number, const std::string &one)
      {
        const long long n = words.count(number);
        for (long long i = 0; i < n; ++i)
          read_tag("number of a " + one);
      }

      void add_node()
      {
        const long long tag = words.integer("number of a node");
        if (tag < 1)
          words.fail("the node number " + std::to_string(tag) +
                     " is not positive");
        nodes.insert(tag);
      }

      void read_position(const long long n_numbers)
      {
        for (long long c = 0; c < n_numbers; ++c)
          words.real("coordinate of a node");
      }

      void read_nodes_2()
      {
        const long long n = words.count("number of nodes");
        for (long long i = 0; i < n; ++i)
          {
            add_node();
            read_position(3);
          }
      }

      void read_nodes_4()
      {
        const long long n_blocks = words.count("number of node blocks");
        const long long n        = words.count("number of nodes");
        words.integer("smallest node number");
        words.integer("largest node number");
        long long found = 0;
        for (long long block = 0; block < n_blocks; ++block)
          {
            const long long dimension = read_dimension();
            read_tag("number of an entity");
            const bool      is_parametric = words.integer("0 or 1") != 0;
            const long long size = words.count("number of nodes of a block");
            for (long long i = 0; i < size; ++i)
              add_node();
            for (long long i = 0; i < size; ++i)
              read_position(3 + (is_parametric ? dimension : 0));
            found += size;
          }
        expect_total(n, found, "nodes");
      }

      void expect_total(const long long    announced,
                        const long long    found,
                        const std::string &what) const
      {
        if (announced != found)
          words.fail(std::to_string(announced) + ' ' + what +
                     " are announced, but the blocks have " +
                     std::to_string(found));
      }

      /** Nodes of an element; format becomes `other` for an unknown type. */
      void read_connectivity(const long long element, const long long type)
      {
        constexpr long long largest_type = 140;
        if (type < 1 || type > largest_type)
          words.fail("the element type " + std::to_string(type) +
                     " is none of gmsh's");
        const std::optional<unsigned int> n_nodes = n_nodes_of(type);
        if (!n_nodes)
          {
            format = Format::other;
            return;
          }
        for (unsigned int i = 0; i < *n_nodes; ++i)
          {
            const long long node =
              words.integer("node of element " + std::to_string(element));
            if (nodes.count(node) == 0)
              words.fail("element " + std::to_string(element) + " has node " +
                         std::to_string(node) +
                         ", which is not one of the file's nodes");
          }
      }

      void read_elements_2()
      {
        const long long n = words.count("number of elements");
        for (long long i = 0; i < n && format != Format::other; ++i)
          {
            const long long element = words.integer("number of an element");
            const long long type    = words.integer("type of an element");
            read_tags("number of tags", "tag");
            read_connectivity(element, type);
          }
      }

      void read_elements_4()
      {
        const long long n_blocks = words.count("number of element blocks");
        const long long n        = words.count("number of elements");
        words.integer("smallest element number");
        words.integer("largest element number");
        long long found = 0;
        for (long long block = 0; block < n_blocks; ++block)
          {
            read_dimension();
            read_tag("number of an entity");
            const long long type = words.integer("type of an element");
            const long long size = words.count("number of elements of a block");
            for (long long i = 0; i < size; ++i)
              {
                const long long element = words.integer("number of an element");
                read_connectivity(element, type);
                if (format == Format::other)
                  return;
              }
            found += size;
          }
        expect_total(n, found, "elements");
      }

      Words                         words;
      Format                        format = Format::other;
      std::unordered_set<long long> nodes;
    };
  } // namespace

  std::string mistake_in_mesh_file(const std::string &file)
  {
    try
      {
        MshFile(file).check();
      }
    catch (const Mistake &mistake)
      {
        return mistake.text;
      }
    return "";
  }
} // namespace auxfem
