#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::split_string_list;
    using dealii::Utilities::trim;

    using Indices = std::vector<unsigned int>;

    template <class Value>
    std::vector<std::string> names_of(const std::map<std::string, Value> &sets)
    {
      std::vector<std::string> names;
      for (const auto &set : sets)
        names.push_back(set.first);
      return names;
    }

    const Lattice &as_designed(const Lattice &lattice)
    {
      return lattice.as_designed ? *lattice.as_designed : lattice;
    }

    std::string quoted(const std::string &text)
    {
      return "\"" + text + "\"";
    }

    /** Lists the first names only, because a scene may define very many. */
    std::string list_of(const std::vector<std::string> &names)
    {
      const std::size_t limit = 20;
      std::string       text;
      for (std::size_t i = 0; i < std::min(limit, names.size()); ++i)
        text += (i == 0 ? "" : ", ") + quoted(names[i]);
      return names.size() > limit ? text + ", ..." : text;
    }

    /** Selects items with numbers, positions and named sets: joints, or struts
     * at their middles. */
    class Selector
    {
    public:
      /** Position of an item by its number (m). */
      using Positions = std::function<dealii::Point<3>(unsigned int)>;

      Selector(const std::string                    &noun,
               const std::map<std::string, Indices> &sets,
               const unsigned int                    n_items,
               const Positions                      &position_of,
               const Lattice                        &lattice,
               const SceneContext                   &context,
               const std::string                    &path)
        : noun(noun)
        , sets(sets)
        , n_items(n_items)
        , position_of(position_of)
        , lattice(lattice)
        , context(context)
        , path(path)
      {}

      Indices select(const std::string &written) const
      {
        const std::string text = trim(written);
        if (text.empty())
          throw InputError(path + ": no " + noun + "s are named. " + allowed());
        Indices result = members(text);
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
        if (result.empty())
          throw InputError(path + ": " + quoted(text) + " selects no " + noun +
                           ". " + extent());
        return result;
      }

    private:
      Indices members(const std::string &text) const
      {
        const auto set = sets.find(text);
        if (set != sets.end())
          return set->second;
        if (text.find(':') != std::string::npos && !is_condition(text))
          return nearest(text);
        if (is_condition(text))
          return matches(text);
        Indices result;
        for (const std::string &piece : split_string_list(text, ','))
          {
            const Indices more =
              piece.empty() || is_digit(piece.front()) || piece.front() == '-'
              ? numbers(piece, text)
              : united_sets(piece);
            result.insert(result.end(), more.begin(), more.end());
          }
        return result;
      }

      static bool is_digit(const char letter)
      {
        return letter >= '0' && letter <= '9';
      }

      Indices numbers(const std::string &list, const std::string &text) const
      {
        Indices result;
        for (const std::string &word : split_words(list))
          result.push_back(number(word, text));
        return result;
      }

      unsigned int number(const std::string &word,
                          const std::string &text) const
      {
        const auto index = read_index(word);
        if (!index)
          throw InputError(path + ": " + quoted(word) + " in " + quoted(text) +
                           " is not the number of a " + noun + ". " +
                           allowed());
        if (*index >= n_items)
          throw InputError(path + ": there is no " + noun + " " + trim(word) +
                           ". The lattice has " + std::to_string(n_items) +
                           " " + noun + "s, numbered from 0 to " +
                           std::to_string(n_items - 1) + ".");
        return *index;
      }

      Indices united_sets(const std::string &text) const
      {
        Indices result;
        for (const auto &name : split_string_list(text, '+'))
          {
            const auto set = sets.find(name);
            if (set == sets.end())
              throw InputError(
                path + ": there is no set of " + noun + "s named " +
                quoted(name) + did_you_mean(name, names_of(sets)) +
                "\nKnown sets of " + noun + "s: " + list_of(names_of(sets)) +
                ".\n" + allowed());
            result.insert(result.end(), set->second.begin(), set->second.end());
          }
        return result;
      }

      /** Items for which the condition @p text holds. */
      Indices matches(const std::string &text) const
      {
        Condition condition(text, lattice, context, path);
        Indices   result;
        for (unsigned int i = 0; i < n_items; ++i)
          if (condition.holds_at(position_of(i)))
            result.push_back(i);
        return result;
      }

      Indices nearest(const std::string &text) const
      {
        const auto colon = text.find(':');
        if (trim(text.substr(0, colon)) != "nearest")
          throw InputError(path + ": " + quoted(text.substr(0, colon + 1)) +
                           " in " + quoted(text) + " is not known. " +
                           allowed());
        const dealii::Point<3> position =
          read_position(text.substr(colon + 1), text);
        refuse_far(position, text);
        unsigned int closest  = 0;
        double       shortest = std::numeric_limits<double>::max();
        for (unsigned int i = 0; i < n_items; ++i)
          if (const double distance = position.distance_square(position_of(i));
              distance < shortest)
            {
              shortest = distance;
              closest  = i;
            }
        return {closest};
      }

      /** Refuses a far position: millimetres without unit would silently select
       * a wrong joint. */
      void refuse_far(const dealii::Point<3> &position,
                      const std::string      &text) const
      {
        constexpr double     largest_distance = 10; // sizes of the lattice
        const auto           box              = bounding_box(lattice);
        dealii::Tensor<1, 3> away;
        for (unsigned int d = 0; d < 3; ++d)
          away[d] =
            std::max({box[0][d] - position[d], position[d] - box[1][d], 0.});
        if (!(away.norm() <= largest_distance * (box[1] - box[0]).norm()))
          throw InputError(path + ": " + quoted(text) +
                           " lies far from the lattice. " + extent() +
                           " Positions are in m unless a unit is given.");
      }

      dealii::Point<3> read_position(const std::string &list,
                                     const std::string &text) const
      {
        dealii::Point<3> position;
        try
          {
            const auto items = split_quantity_list(list);
            if (items.size() != 2 && items.size() != 3)
              throw InputError(std::to_string(items.size()) +
                               " coordinates are given");
            for (std::size_t i = 0; i < items.size(); ++i)
              position[i] = parse_quantity(items[i], "m");
          }
        catch (const InputError &error)
          {
            throw InputError(path + ": " + quoted(text) + ": " + error.what() +
                             (context.dimension == 3
                                ? ". Write the position like \"nearest: 0.01, "
                                  "0.02, 0.03\" (in m) or \"nearest: 10 mm, "
                                  "20 mm, 30 mm\"."
                                : ". Write the position like \"nearest: 0.01, "
                                  "0.02\" (in m) or \"nearest: 10 mm, 20 "
                                  "mm\"."));
          }
        return position;
      }

      std::string extent() const
      {
        const auto box = bounding_box(lattice);
        return "The joints lie between " +
          position_text(box[0], context.dimension) + " and " +
          position_text(box[1], context.dimension) + ".";
      }

      std::string allowed() const
      {
        return "Allowed: the name of a set of " + noun +
          "s, several joined by + or commas, numbers like \"3, 5\" or \"3 5\", "
          "\"nearest: " +
          (context.dimension == 3
             ? "x, y, z\", or a condition like \"y > ymax - 1e-6 && z < "
               "0.02\"."
             : "x, y\", or a condition like \"y > ymax - 1e-6 && x < "
               "0.02\".");
      }

      const std::string                     noun;
      const std::map<std::string, Indices> &sets;
      const unsigned int                    n_items;
      const Positions                       position_of;
      const Lattice                        &lattice;
      const SceneContext                   &context;
      const std::string                    &path;
    };

    std::vector<JointPair> pairs_by_number(const Lattice      &lattice,
                                           const std::string  &text,
                                           const SceneContext &context,
                                           const std::string  &path)
    {
      std::vector<JointPair> pairs;
      for (const auto &item : split_string_list(text, ';'))
        {
          const std::vector<std::string> words = split_words(item);
          if (words.size() != 2 || !read_index(words[0]) ||
              !read_index(words[1]))
            throw InputError(path + ": " + quoted(item) + " in " +
                             quoted(text) +
                             " is not a pair of joint numbers. Write pairs "
                             "like \"3 5; 7 9\".");
          const unsigned int first =
            select_joints(lattice, words[0], context, path).front();
          const unsigned int second =
            select_joints(lattice, words[1], context, path).front();
          if (first == second)
            throw InputError(path + ": " + quoted(item) +
                             " links a joint with itself. Give two different "
                             "joints.");
          pairs.push_back({first, second});
        }
      return pairs;
    }

    std::vector<JointPair> pairs_to_ground(const Lattice      &lattice,
                                           const std::string  &joints,
                                           const SceneContext &context,
                                           const std::string  &path)
    {
      std::vector<JointPair> pairs;
      for (const unsigned int joint :
           select_joints(lattice, joints, context, path))
        pairs.push_back({joint, invalid_index});
      return pairs;
    }

    /** Those of @p pairs whose middle meets @p text. */
    std::vector<JointPair> pairs_where(const Lattice                &lattice,
                                       const std::vector<JointPair> &pairs,
                                       const std::string            &text,
                                       const SceneContext           &context,
                                       const std::string            &path)
    {
      const Lattice         &designed = as_designed(lattice);
      Condition              condition(text, designed, context, path);
      std::vector<JointPair> chosen;
      for (const JointPair &pair : pairs)
        {
          const dealii::Point<3> &first = designed.joints[pair.first];
          const dealii::Point<3> &second =
            pair.second == invalid_index ? first : designed.joints[pair.second];
          if (condition.holds_at(first + (second - first) / 2))
            chosen.push_back(pair);
        }
      if (chosen.empty())
        throw InputError(path + ": no pair has its middle where " + text + ".");
      return chosen;
    }

    /** Refuses an empty pair set, which only pairs across cells can be. */
    [[noreturn]] void refuse_without_pairs(const Lattice      &lattice,
                                           const std::string  &name,
                                           const SceneContext &context,
                                           const std::string  &path)
    {
      throw InputError(
        path + ": the lattice has no joint pairs " + quoted(name) +
        ". They link neighbouring cells, and " +
        (lattice.n_cells == 1
           ? "one cell has no neighbour"
           : "here no cell has a neighbour in their direction, or both share "
             "the joint") +
        ". Repeat the cell in that direction ('Cells x', 'Cells y'" +
        (context.dimension == 3 ? ", 'Cells z'" : "") +
        " of the lattice) or remove what uses these pairs.");
    }
  } // namespace

  std::vector<unsigned int> select_joints(const Lattice      &lattice,
                                          const std::string  &text,
                                          const SceneContext &context,
                                          const std::string  &path)
  {
    const Lattice &designed = as_designed(lattice);
    return Selector(
             "joint",
             lattice.joint_sets,
             lattice.n_structural_joints(),
             [&](const unsigned int i) { return designed.joints[i]; },
             designed,
             context,
             path)
      .select(text);
  }

  std::vector<unsigned int> select_struts(const Lattice      &lattice,
                                          const std::string  &text,
                                          const SceneContext &context,
                                          const std::string  &path)
  {
    const Lattice &designed = as_designed(lattice);
    const auto     middle   = [&](const unsigned int i) {
      dealii::Point<3>     position;
      dealii::Tensor<1, 3> tangent;
      designed.axis(designed.struts[i], 0.5, position, tangent);
      return position;
    };
    return Selector("strut",
                    lattice.strut_sets,
                    lattice.struts.size(),
                    middle,
                    designed,
                    context,
                    path)
      .select(text);
  }

  std::vector<JointPair> select_pairs(const Lattice      &lattice,
                                      const std::string  &written,
                                      const SceneContext &context,
                                      const std::string  &path)
  {
    const std::string text  = trim(written);
    const std::string where = " where ";
    if (const auto begin = text.find(where); begin != std::string::npos)
      return pairs_where(
        lattice,
        select_pairs(lattice, text.substr(0, begin), context, path),
        trim(text.substr(begin + where.size())),
        context,
        path);
    const auto set = lattice.pair_sets.find(text);
    if (set != lattice.pair_sets.end())
      {
        if (set->second.empty())
          refuse_without_pairs(lattice, text, context, path);
        return set->second;
      }

    const auto colon = text.find(':');
    if (colon != std::string::npos && trim(text.substr(0, colon)) == "ground")
      return pairs_to_ground(lattice, text.substr(colon + 1), context, path);
    if (!text.empty() &&
        text.find_first_not_of("0123456789-,; \t") == std::string::npos)
      return pairs_by_number(lattice, text, context, path);

    const auto known = names_of(lattice.pair_sets);
    throw InputError(
      path + ": this cell offers no joint pairs named " + quoted(text) +
      did_you_mean(text, known) + "\n" +
      (known.empty() ? std::string("It offers none by name.")
                     : "Known pairs: " + list_of(known) + ".") +
      "\nAllowed: the name of pairs, joint numbers like \"3 5; 7 9\", or "
      "\"ground: \" and a selection of joints, each maybe followed by \" where \" "
      "and a condition.");
  }
} // namespace auxfem
