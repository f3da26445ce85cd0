#ifndef auxfem_parameters_subsection_schema_h
#define auxfem_parameters_subsection_schema_h

#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter_values.h>

#include <algorithm>
#include <string>
#include <vector>

namespace auxfem
{
  /** One value of a subsection's choice and its parameters. */
  struct SubsectionVariant
  {
    std::string name;
    std::string sentence;
    Parameters  parameters = {};
  };

  /**
   * Schema of one top-level subsection: its allowed content and its meaning.
   */
  struct SubsectionSchema
  {
    enum class Form
    {
      fixed,        ///< `subsection KIND` holds the parameters
      named_groups, ///< `subsection KIND / subsection NAME`, NAME the user's
      free_entries, ///< `subsection KIND / set NAME = text`, NAME the user's
      path_entries  ///< as free_entries, NAME the path of a parameter
    };

    /** Name of the subsection; empty for the top level of the file. */
    std::string name;
    Form        form = Form::fixed;
    std::string sentence;

    /** Parameters that do not depend on the choice. */
    Parameters parameters = {};

    /** Parameter that selects a variant; empty if there is none. */
    std::string                    choice   = {};
    std::vector<SubsectionVariant> variants = {};

    /** Models that may use this subsection. */
    std::vector<Model> models = {Model::lattice};

    bool serves(const Model model) const
    {
      return std::find(models.begin(), models.end(), model) != models.end();
    }
  };

  /** Text of an entry of Form::free_entries or Form::path_entries. */
  const std::string &text_of_free_entry(const ParameterValues &values);

  /**
   * Checks the user's input @p root against @p schema and adds all errors to @p
   * mistakes. Returns the values of the valid subsections, each with its own
   * path in @p context.
   */
  std::vector<ParameterValues> check_subsection(const ParameterSubsection &root,
                                                const SubsectionSchema &schema,
                                                const SceneContext     &context,
                                                Mistakes &mistakes);
} // namespace auxfem

#endif
