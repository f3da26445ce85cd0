#include <auxfem/mesh/cells/entries.h>
#include <auxfem/mesh/index_text.h>
#include <auxfem/parameters/declare.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>

#include <deal.II/base/utilities.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    const Text joints_entry{
      "Joints",
      "",
      "Positions `x y` of the joints in m, separated by semicolons; they are "
      "numbered from 0 in this order.",
      true};

    const Text struts_entry{
      "Struts",
      "",
      "Numbers of the two joints of each strut, separated by semicolons; a "
      "third number is the rise in m of a circular arc over its chord, positive "
      "to the left of the direction from the first to the second joint.",
      true};

    void declare_frame(dealii::ParameterHandler &prm)
    {
      declare(prm, joints_entry);
      declare(prm, struts_entry);
    }

    /** The blank-separated words of one of the entries between semicolons. */
    struct Item
    {
      std::string              where; ///< beginning of a message about it
      std::string              text;
      std::vector<std::string> words;
    };

    std::vector<Item> split_items(const std::string &value,
                                  const std::string &entry,
                                  const std::string &noun,
                                  const std::string &path)
    {
      std::vector<Item> items;
      for (const auto &text : dealii::Utilities::split_string_list(value, ';'))
        {
          Item item;
          item.text  = text;
          item.where = path + "/" + entry + ": " + noun + " " +
            std::to_string(items.size()) + " (\"" + text + "\") ";
          std::istringstream stream(text);
          for (std::string word; stream >> word;)
            item.words.push_back(word);
          items.push_back(item);
        }
      return items;
    }

    double read_metres(const std::string &word, const Item &item)
    {
      try
        {
          const ParsedQuantity quantity = split_quantity(word);
          if (quantity.unit.empty())
            return quantity.number;
        }
      catch (const InputError &)
        {}
      throw InputError(item.where + "has \"" + word +
                       "\" where a number in m, without unit word, is needed.");
    }

    std::vector<dealii::Point<3>> read_joints(const std::string &value,
                                              const std::string &path)
    {
      std::vector<dealii::Point<3>> joints;
      for (const Item &item :
           split_items(value, joints_entry.name, "joint", path))
        {
          if (item.words.size() != 2)
            throw InputError(
              item.where + "has " + std::to_string(item.words.size()) +
              " numbers instead of the two coordinates x y. "
              "Separate joints by semicolons: \"0 0; 1 0; 1 1\".");
          joints.emplace_back(read_metres(item.words[0], item),
                              read_metres(item.words[1], item),
                              0.);
        }
      return joints;
    }

    unsigned int read_joint_number(const std::string &word,
                                   const Item        &item,
                                   const std::size_t  n_joints)
    {
      const auto index = read_index(word);
      if (!index)
        throw InputError(item.where + "has \"" + word +
                         "\" where the number of a joint is needed.");
      if (*index >= n_joints)
        throw InputError(
          item.where + "names joint " + word +
          ", which does not exist. There are " + std::to_string(n_joints) +
          " joints, numbered from 0 to " + std::to_string(n_joints - 1) + ".");
      return *index;
    }

    void
    check_strut(const UnitStrut &strut, const UnitCell &cell, const Item &item)
    {
      const double chord =
        cell.joints[strut.first].distance(cell.joints[strut.second]);
      if (chord == 0.)
        throw InputError(item.where +
                         "has zero length: its two joints lie at the same "
                         "place. Make a ring of two or more arcs.");

      for (const UnitStrut &other : cell.struts)
        if ((other.first == strut.first && other.second == strut.second &&
             other.sagitta == strut.sagitta) ||
            (other.first == strut.second && other.second == strut.first &&
             other.sagitta == -strut.sagitta))
          throw InputError(item.where + "repeats strut " +
                           std::to_string(&other - cell.struts.data()) +
                           ". Remove one of them.");
    }

    void read_struts(const std::string &value,
                     const std::string &path,
                     UnitCell          &cell)
    {
      for (const Item &item :
           split_items(value, struts_entry.name, "strut", path))
        {
          if (item.words.size() != 2 && item.words.size() != 3)
            throw InputError(item.where + "has " +
                             std::to_string(item.words.size()) +
                             " numbers instead of two joint numbers and, for "
                             "an arc, its rise. Separate struts by semicolons: "
                             "\"0 1; 1 2 0.25\".");
          UnitStrut strut;
          strut.first =
            read_joint_number(item.words[0], item, cell.joints.size());
          strut.second =
            read_joint_number(item.words[1], item, cell.joints.size());
          if (item.words.size() == 3)
            strut.sagitta = read_metres(item.words[2], item);
          check_strut(strut, cell, item);
          cell.struts.push_back(strut);
        }
    }

    class FrameCell : public Cell
    {
    public:
      explicit FrameCell(const UnitCell &cell) : cell(cell)
      {}

      UnitCell build() const override
      {
        return cell;
      }

    private:
      UnitCell cell;
    };

    std::unique_ptr<Cell> make_frame(dealii::ParameterHandler &prm,
                                     const SceneContext       &context)
    {
      UnitCell cell;
      cell.joints = read_joints(get(prm, joints_entry), context.path);
      if (cell.joints.size() < 2)
        throw InputError(context.path + "/" + joints_entry.name +
                         ": a frame needs at least two joints, for example "
                         "\"0 0; 1 0\".");
      read_struts(get(prm, struts_entry), context.path, cell);
      if (cell.struts.empty())
        throw InputError(context.path + "/" + struts_entry.name +
                         ": a frame needs at least one strut, for example "
                         "\"0 1\".");
      cell.why_no_period.fill("A frame has no neighbour cells.");
      return std::make_unique<FrameCell>(cell);
    }
  } // namespace

  RegistryEntry<Cell> frame_cell_entry()
  {
    return {"frame",
            "Free-form planar frame: joints and straight or circular struts "
            "given one by one.",
            &declare_frame,
            &make_frame};
  }
} // namespace auxfem
