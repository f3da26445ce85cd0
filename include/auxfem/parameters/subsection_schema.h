#ifndef auxfem_parameters_subsection_schema_h
#define auxfem_parameters_subsection_schema_h

#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter_values.h>

#include <algorithm>
#include <string>
#include <vector>

namespace auxfem
{
  /** One value of a subsection's choice and the parameters that come with it.
   */
  struct SubsectionVariant
  {
    std::string name;
    std::string sentence;
    Parameters  parameters = {};
  };

  /**
   * One top-level subsection of the parameter file: what it may hold, what it
   * means.
   */
  struct SubsectionSchema
  {
    enum class Form
    {
      fixed,        ///< `subsection KIND` holds the parameters
      named_groups, ///< `subsection KIND / subsection NAME`, NAME the user's
      free_entries  ///< `subsection KIND / set NAME = text`, NAME the user's
    };

    /** Name of the subsection; empty for the top level of the file. */
    std::string name;
    Form        form = Form::fixed;
    std::string sentence;

    /** The parameters that do not depend on a choice. */
    Parameters parameters = {};

    /** Parameter whose value decides on further ones; empty if there is none.
     */
    std::string                    choice   = {};
    std::vector<SubsectionVariant> variants = {};

    /** Models whose scenes may have this subsection. */
    std::vector<Model> models = {Model::lattice};

    bool serves(const Model model) const
    {
      return std::find(models.begin(), models.end(), model) != models.end();
    }
  };

  /** The text of a Form::free_entries entry. */
  const std::string &text_of_free_entry(const ParameterValues &values);

  /**
   * Compares what the user wrote in @p root with what @p schema allows and adds
   * all differences to @p mistakes. Returns the values of the subsections
   * without any, each with its own path in @p context.
   */
  std::vector<ParameterValues> check_subsection(const ParameterSubsection &root,
                                                const SubsectionSchema &schema,
                                                const SceneContext     &context,
                                                Mistakes &mistakes);
} // namespace auxfem

#endif
