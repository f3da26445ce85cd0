#include <auxfem/joints/constraint_definition.h>
#include <auxfem/mesh/lattice_definition.h>
#include <auxfem/parameters/quantity.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::split_string_list;
    using dealii::Utilities::trim;

    const Text alike_components = {
      "Components",
      "",
      "Components in which all joints move alike: x, y, z, "
      "rotation x, rotation y, rotation z, separated by "
      "commas.",
      true};
    const QuantityList line_direction = {
      "Direction",
      "",
      "1",
      Range::any(),
      2,
      3,
      "Vector along the line, of any length but zero."};
    const Text relation_terms = {
      "Relation",
      "",
      "Terms COEFFICIENT COMPONENT of JOINTS, separated by semicolons, whose "
      "sum is zero: x of 3; -2 y of 5. Without a coefficient it is 1. Of "
      "several joints it is the mean motion. Beside displacements the "
      "coefficient of a rotation is a length.",
      true};

    std::vector<SubsectionVariant> constraint_types()
    {
      return {
        {"equal motion",
         "The joints of a set move alike in chosen components.",
         {set_of_joints, alike_components}},
        {"line",
         "Each joint of a set stays on the straight line through its position "
         "at rest, fixed in space.",
         {set_of_joints, line_direction}},
        {"linear relation",
         "The sum of multiples of motions is zero.",
         {relation_terms}}};
    }

    Choice constraint_type()
    {
      return {"Type",
              "equal motion",
              names_of(constraint_types()),
              "Relation between the motions."};
    }

    const std::array<const char *, n_motion_components> component_names = {
      {"x", "y", "z", "rotation x", "rotation y", "rotation z"}};

    /** Number of the component @p name, which the dimension must have. */
    unsigned int component_of(const ParameterValues &values,
                              const Parameter       &parameter,
                              const std::string     &name)
    {
      const auto found =
        std::find(component_names.begin(), component_names.end(), name);
      const unsigned int component = found - component_names.begin();
      if (found != component_names.end() &&
          (values.context.dimension == 3 || is_in_plane(component)))
        return component;
      values.refuse(parameter,
                    "\"" + name + "\" is no component of motion" +
                      (found == component_names.end()
                         ? std::string(". Name one of ")
                         : std::string(" in the plane. Name one of ")) +
                      (values.context.dimension == 3
                         ? "x, y, z, rotation x, rotation y, rotation z"
                         : "x, y, rotation z"));
    }

    /** Factor and component of `-2 rotation z`, `x` or `-x`. */
    std::pair<std::string, std::string> split_factor(const std::string &motion)
    {
      std::vector<std::string> words     = split_words(motion);
      const auto               take_last = [&words] {
        const std::string word = words.empty() ? "" : words.back();
        if (!words.empty())
          words.pop_back();
        return word;
      };
      std::string component = take_last();
      if (!words.empty() && words.back().find("rotation") != std::string::npos)
        component = take_last() + ' ' + component;
      std::string factor;
      for (const std::string &word : words)
        factor += (factor.empty() ? "" : " ") + word;
      if (factor.empty() && !component.empty() &&
          (component[0] == '-' || component[0] == '+'))
        {
          factor = component.substr(0, 1);
          component.erase(0, 1);
        }
      return {factor, component};
    }

    struct WrittenTerm
    {
      std::string  factor;
      unsigned int component;
      std::string  joints;
    };

    WrittenTerm read_term(const ParameterValues &values,
                          const std::string     &text)
    {
      const std::string separator = " of ";
      const std::size_t at        = text.find(separator);
      if (at == std::string::npos)
        values.refuse(relation_terms,
                      "the term \"" + text +
                        "\" has no \"of\". Write COEFFICIENT COMPONENT of "
                        "JOINTS, for instance -2 y of 5");
      const auto [factor, component] = split_factor(text.substr(0, at));
      return {factor,
              component_of(values, relation_terms, component),
              trim(text.substr(at + separator.size()))};
    }

    double coefficient_of(const ParameterValues &values,
                          const WrittenTerm     &term,
                          const bool             beside_displacements)
    {
      if (term.factor.empty() || term.factor == "+")
        return 1;
      if (term.factor == "-")
        return -1;
      const bool is_length =
        beside_displacements && term.component >= first_rotation;
      double coefficient = 0;
      try
        {
          coefficient = parse_quantity(term.factor, is_length ? "m" : "1");
        }
      catch (const InputError &error)
        {
          values.refuse(relation_terms,
                        "the coefficient \"" + term.factor +
                          "\": " + error.what());
        }
      if (coefficient == 0)
        values.refuse(relation_terms,
                      "a term with the coefficient 0 has no effect. Remove it");
      return coefficient;
    }

    std::vector<ConstraintDefinition::Term>
    read_terms(const ParameterValues &values)
    {
      std::vector<WrittenTerm> written;
      for (const std::string &term :
           split_string_list(values[relation_terms], ';'))
        written.push_back(read_term(values, term));
      const bool has_displacements =
        std::any_of(written.begin(), written.end(), [](const auto &term) {
          return term.component < first_rotation;
        });
      std::vector<ConstraintDefinition::Term> terms;
      for (const WrittenTerm &term : written)
        terms.push_back({coefficient_of(values, term, has_displacements),
                         term.component,
                         term.joints});
      return terms;
    }
  } // namespace



  SubsectionSchema constraints_schema()
  {
    return {"Constraints",
            SubsectionSchema::Form::named_groups,
            "Linear relations between motions of joints, kept by forces that "
            "do no work (multi-point constraints).",
            {constraint_type()},
            "Type",
            constraint_types()};
  }



  ConstraintDefinition read_constraint(ParameterValues &values)
  {
    ConstraintDefinition constraint;
    constraint.name        = values.name();
    constraint.path        = values.context.path;
    const std::string type = values[constraint_type()];
    if (type == "linear relation")
      {
        constraint.type  = ConstraintDefinition::Type::relation;
        constraint.terms = read_terms(values);
        return constraint;
      }
    constraint.joints = values[set_of_joints];
    if (type == "line")
      {
        constraint.type      = ConstraintDefinition::Type::line;
        constraint.direction = unit_vector_of(values, line_direction);
        if (values.context.dimension == 2 && constraint.direction[2] != 0)
          values.refuse(line_direction,
                        "the line leaves the plane. Give x and y only");
      }
    else
      for (const std::string &component :
           split_string_list(values[alike_components], ','))
        constraint
          .components[component_of(values, alike_components, component)] = true;
    return constraint;
  }
} // namespace auxfem
