#ifndef auxfem_scene_scene_sections_h
#define auxfem_scene_scene_sections_h

#include <auxfem/parameters/declare.h>
#include <auxfem/parameters/mistakes.h>
#include <auxfem/parameters/parameter_file.h>
#include <auxfem/parameters/value_pattern.h>
#include <auxfem/scene/scene.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** The joints of a group that has to name some. */
  inline const Text set_of_joints = {"Joints", "", "Set of joints.", true};

  /** One value of a subsection's choice and the entries that come with it. */
  struct SubsectionVariant
  {
    std::string name;
    std::string sentence;
    /** Declares its entries; may be empty. */
    std::function<void(dealii::ParameterHandler &)> declare;
  };

  /**
   * One top-level subsection of the parameter file: what it may hold, what it
   * means.
   */
  struct SubsectionKind
  {
    enum class Form
    {
      fixed,        ///< `subsection KIND` holds the entries
      named_groups, ///< `subsection KIND / subsection NAME`, NAME the user's
      free_entries  ///< `subsection KIND / set NAME = text`, NAME the user's
    };

    /** Name of the subsection; empty for the top level of the file. */
    std::string name;
    Form        form = Form::fixed;
    std::string sentence;

    /** Declares the entries that do not depend on a choice. */
    std::function<void(dealii::ParameterHandler &)> declare;

    /** Entry whose value decides on further entries; empty if there is none. */
    std::string                    choice   = {};
    std::vector<SubsectionVariant> variants = {};

    /**
     * Fills the scene from @p prm, which stands in the subsection that holds the entries.
     * @p name is the user's name of it (empty for fixed ones). Values are
     * checked one by one already. Throws InputError for contradictions; its
     * message begins with context.path.
     */
    std::function<void(dealii::ParameterHandler &prm,
                       const std::string        &name,
                       const SceneContext       &context,
                       Scene                    &scene)>
      read = {};

    /** Models whose scenes may have this subsection. */
    std::vector<Model> models = {Model::lattice};

    bool serves(Model model) const;
  };

  /** All kinds of subsections, in the order of the reference. */
  const std::vector<SubsectionKind> &subsection_kinds();

  /** @name The kinds, group by group; each in its own scene_GROUP.cc. */
  ///@{
  std::vector<SubsectionKind> general_kinds();
  std::vector<SubsectionKind> structure_kinds();
  SubsectionKind              sections_kind();
  SubsectionKind              rigid_parts_kind();
  SubsectionKind              reduced_cell_kind();
  SubsectionKind              supports_kind();
  std::vector<SubsectionKind> load_kinds();
  std::vector<SubsectionKind> time_kinds();
  std::vector<SubsectionKind> output_kinds();
  ///@}

  /** @name The top-level entries `Model` and `Dimension`. */
  ///@{
  /** The word for @p model, e.g. `reduced cell`. */
  std::string name_of(Model model);

  /**
   * The model that the top level of the file asks for; nothing if its word is
   * none, which check_and_declare() reports.
   */
  std::optional<Model> model_of(const ParameterSubsection &root);

  /** As model_of(), the dimension of space. */
  std::optional<unsigned int> dimension_of(const ParameterSubsection &root);
  ///@}

  /**
   * The function of time in @p entry. The file name of a table becomes an
   * absolute one in @p prm.
   */
  TimeFunction read_time_function(dealii::ParameterHandler &prm,
                                  const TimeExpression     &entry,
                                  const SceneContext       &context,
                                  TableKind tables = TableKind::linear);

  /** An entry as a declare() function has declared it. */
  struct DeclaredEntry
  {
    std::string name;
    std::string default_value;
    std::string sentence;
    /** deal.II's description of the pattern. */
    std::string pattern;
    /** The rule in it; nothing for entries declared with a pattern of deal.II.
     */
    std::optional<ValueRule> rule;

    bool required() const;

    /** What is wrong with @p value, as ValueRule::problem(). */
    std::string problem(const std::string &value) const;

    /** What is allowed, unit words included. */
    std::string allowed() const;
  };

  /** The entries that @p declare declares, in order. */
  std::vector<DeclaredEntry> declared_entries(
    const std::function<void(dealii::ParameterHandler &)> &declare);

  /** Their names. */
  std::vector<std::string> names_of(const std::vector<DeclaredEntry> &entries);

  /** A subsection ready to be read: complete, no mistakes, declared and set. */
  struct CheckedSubsection
  {
    /** The user's name of the group or entry; empty for a fixed subsection. */
    std::string name;
    /** E.g. `Sections/beam`. */
    std::string path;
    FilePlace   place;
  };

  /**
   * Compares what the user wrote with what @p kind allows, adds all differences
   * to @p mistakes, and, where there are none, declares the entries in @p prm
   * and sets their values. Returns what may be read now.
   */
  std::vector<CheckedSubsection>
  check_and_declare(const ParameterSubsection &root,
                    const SubsectionKind      &kind,
                    dealii::ParameterHandler  &prm,
                    Mistakes                  &mistakes);

  /**
   * Adds the subsections of the file that no kind allows, and those that serve
   * other models than @p model, to @p mistakes.
   */
  void check_subsection_names(const ParameterSubsection &root,
                              Model                      model,
                              Mistakes                  &mistakes);

  /** Adds contradictions between subsections of @p scene to @p mistakes. */
  void check_consistency(const Scene &scene, Mistakes &mistakes);
} // namespace auxfem

#endif
