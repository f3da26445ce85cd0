#include <auxfem/mesh/cells/cell_table.h>
#include <auxfem/mesh/cells/frame_text.h>
#include <auxfem/mesh/cells/translations.h>
#include <auxfem/mesh/merge_joints.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>

namespace auxfem
{
  namespace
  {
    const Text joint_sets_entry{
      "Joint sets",
      "",
      "Named joints of the cell, NAME: JOINTS, separated by semicolons: tips: 0 "
      "1; seats: 4."};
    const Text strut_sets_entry{
      "Strut sets",
      "",
      "Named struts of the cell by their numbers from 0, NAME: STRUTS, separated "
      "by semicolons."};
    const Text pairs_entry{
      "Pairs",
      "",
      "Pairs of joints for connectors, NAME: JOINT JOINT, separated by "
      "semicolons. With at I J (in space I J K) the second joint is that of the "
      "cell I cells further along x, J along y: damper: 1 3; link: 2 0 at 1 0."};
    const Text neighbour_struts_entry{
      "Neighbour struts",
      "",
      "Struts to joints of other cells, NAME: JOINT JOINT at I J, as in Pairs; "
      "NAME is their strut set. They are made where that cell exists."};

    /** `NAME: WORDS`. */
    struct NamedItem
    {
      std::string name;
      ListItem    item;
    };

    std::vector<NamedItem> named_items(const ParameterValues &values,
                                       const Text            &entry)
    {
      std::vector<NamedItem> result;
      if (values[entry].empty())
        return result;
      for (ListItem &item :
           split_items(values[entry], entry.name, "entry", values.context.path))
        {
          const std::size_t colon = item.text.find(':');
          const std::string name =
            dealii::Utilities::trim(item.text.substr(0, colon));
          if (colon == std::string::npos || name.empty())
            throw InputError(item.where +
                             "has no name. Write NAME: NUMBERS, e.g. tips: 0 "
                             "1.");
          item.words = split_words(item.text.substr(colon + 1));
          result.push_back({name, item});
        }
      return result;
    }

    unsigned int read_strut_number(const std::string &word,
                                   const ListItem    &item,
                                   const std::size_t  n_struts)
    {
      const auto index = read_index(word);
      if (!index || *index >= n_struts)
        throw InputError(item.where + "has \"" + word +
                         "\", which is no strut of the cell. They are "
                         "numbered from 0 to " +
                         std::to_string(n_struts - 1) + ".");
      return *index;
    }

    void add_sets(const ParameterValues &values, UnitCell &cell)
    {
      for (const auto &[name, item] : named_items(values, joint_sets_entry))
        for (const std::string &word : item.words)
          cell.joint_sets[name].push_back(
            read_joint_number(word, item, cell.joints.size()));
      for (const auto &[name, item] : named_items(values, strut_sets_entry))
        for (const std::string &word : item.words)
          cell.struts[read_strut_number(word, item, cell.struts.size())]
            .sets.push_back(name);
    }

    int read_shift(const std::string &word, const ListItem &item)
    {
      const bool is_negative = !word.empty() && word[0] == '-';
      const auto size        = read_index(word.substr(is_negative));
      if (!size || *size > 1000)
        throw InputError(item.where + "has \"" + word +
                         "\" where a whole number of cells is needed.");
      return is_negative ? -int(*size) : int(*size);
    }

    /** Reads `JOINT JOINT` or `JOINT JOINT at I J`. */
    NeighbourPair read_pair(const ListItem    &item,
                            const std::size_t  n_joints,
                            const unsigned int dimension)
    {
      const std::size_t n = item.words.size();
      if (n != 2 && !(n == 3 + dimension && item.words[2] == "at"))
        throw InputError(item.where + "is no pair. Write NAME: JOINT JOINT" +
                         (dimension == 2 ? " or NAME: JOINT JOINT at I J."
                                         : " or NAME: JOINT JOINT at I J K."));
      NeighbourPair pair = {read_joint_number(item.words[0], item, n_joints),
                            read_joint_number(item.words[1], item, n_joints),
                            {{0, 0, 0}}};
      for (std::size_t i = 3; i < n; ++i)
        pair.shift[i - 3] = read_shift(item.words[i], item);
      return pair;
    }

    bool is_in_cell(const NeighbourPair &pair)
    {
      return pair.shift == std::array<int, 3>{{0, 0, 0}};
    }

    /** The user's numbers of joints, and those after a merger. */
    class MergedJoints
    {
    public:
      MergedJoints(const std::vector<dealii::Point<3>> &given,
                   const UnitCell                      &merged)
      {
        for (const dealii::Point<3> &position : given)
          numbers.push_back(std::min_element(merged.joints.begin(),
                                             merged.joints.end(),
                                             [&](const auto &a, const auto &b) {
                                               return a.distance_square(
                                                        position) <
                                                 b.distance_square(position);
                                             }) -
                            merged.joints.begin());
      }

      NeighbourPair operator()(NeighbourPair pair) const
      {
        pair.first  = numbers[pair.first];
        pair.second = numbers[pair.second];
        return pair;
      }

    private:
      std::vector<unsigned int> numbers;
    };

    void add_pairs(const ParameterValues &values,
                   const std::size_t      n_joints,
                   const MergedJoints    &merged,
                   UnitCell              &cell)
    {
      const unsigned int dimension = values.context.dimension;
      for (const auto &[name, item] : named_items(values, pairs_entry))
        {
          const NeighbourPair pair =
            merged(read_pair(item, n_joints, dimension));
          if (is_in_cell(pair))
            cell.pairs[name].push_back({pair.first, pair.second});
          else
            cell.pairs_across[name].push_back(pair);
        }
      for (const auto &[name, item] :
           named_items(values, neighbour_struts_entry))
        {
          const NeighbourPair pair =
            merged(read_pair(item, n_joints, dimension));
          if (is_in_cell(pair))
            throw InputError(item.where +
                             "lies within the cell. Name it in Struts, or say "
                             "at which cell its second joint is: " +
                             (dimension == 2 ? "at 1 0." : "at 1 0 0."));
          cell.struts_across.push_back({name, {pair}});
        }
    }

    std::unique_ptr<Cell> make_pattern(ParameterValues &values)
    {
      UnitCell cell = read_frame(values, "pattern");
      add_sets(values, cell);
      const std::vector<dealii::Point<3>> given = cell.joints;
      merge_joints_of_frame(values, cell);
      add_pairs(values, given.size(), MergedJoints(given, cell), cell);
      set_translations(values, cell);
      return std::make_unique<PrebuiltCell>(cell);
    }
  } // namespace

  RegistryEntry<Cell> pattern_cell_entry()
  {
    Parameters parameters = frame_parameters();
    for (const Parameter &vector : translation_parameters())
      parameters.push_back(vector);
    for (const Text &list : {joint_sets_entry,
                             strut_sets_entry,
                             pairs_entry,
                             neighbour_struts_entry})
      parameters.push_back(list);
    return {"pattern",
            "A cell of your own, joint by joint, repeated by translation "
            "vectors; joints and struts at the same place as those of a "
            "neighbour are united.",
            parameters,
            make_pattern};
  }
} // namespace auxfem
