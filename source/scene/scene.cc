#include <auxfem/parameters/errors.h>
#include <auxfem/scene/input_files.h>
#include <auxfem/scene/scene.h>
#include <auxfem/scene/scene_sections.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    using Form = SubsectionKind::Form;

    /** Runs @p action with @p prm inside the subsection of @p kind and @p name. */
    template <class Action>
    void inside(dealii::ParameterHandler &prm,
                const SubsectionKind     &kind,
                const std::string        &name,
                const Action             &action)
    {
      std::vector<std::string> path;
      if (!kind.name.empty())
        path.push_back(kind.name);
      if (kind.form == Form::named_groups)
        path.push_back(name);
      for (const std::string &step : path)
        prm.enter_subsection(step);
      action();
      for (unsigned int i = 0; i < path.size(); ++i)
        prm.leave_subsection();
    }

    void read_subsection(dealii::ParameterHandler &prm,
                         const SubsectionKind     &kind,
                         const CheckedSubsection  &checked,
                         Scene                    &scene,
                         Mistakes                 &mistakes)
    {
      SceneContext context = scene.context;
      context.path         = checked.path;
      inside(prm, kind, checked.name, [&]() {
        try
          {
            kind.read(prm, checked.name, context, scene);
          }
        catch (const InputError &error)
          {
            mistakes.add(checked.place.text() + ": " + error.what());
          }
      });
    }

    std::string listing(const dealii::ParameterHandler &prm)
    {
      std::ostringstream text;
      prm.print_parameters(text,
                           dealii::ParameterHandler::PRM |
                             dealii::ParameterHandler::KeepDeclarationOrder);
      return text.str();
    }

    std::string directory_of(const std::string &file)
    {
      const std::size_t slash = file.rfind('/');
      return slash == std::string::npos ? "."
        : slash == 0                    ? "/"
                                        : file.substr(0, slash);
    }

    Scene make_scene(const ParameterSubsection &root, const std::string &file)
    {
      Scene                    scene;
      Mistakes                 mistakes;
      dealii::ParameterHandler prm;
      scene.file              = file;
      scene.input_files       = input_files(root, file);
      scene.context.directory = directory_of(file);

      // Without model and dimension nothing can be said about what the rest may
      // be.
      const std::optional<Model> model = model_of(root);
      if (model && dimension_of(root))
        {
          scene.model = *model;
          check_subsection_names(root, *model, mistakes);
        }
      else
        {
          check_and_declare(root, general_kinds().front(), prm, mistakes);
          mistakes.throw_if_any(file);
        }
      for (const SubsectionKind &kind : subsection_kinds())
        if (kind.serves(scene.model))
          for (const CheckedSubsection &checked :
               check_and_declare(root, kind, prm, mistakes))
            read_subsection(prm, kind, checked, scene, mistakes);
      check_consistency(scene, mistakes);
      mistakes.throw_if_any(file);

      scene.all_parameters = listing(prm);
      return scene;
    }

    Scene make_scene(ParameterSubsection             root,
                     const std::string              &file,
                     const std::vector<std::string> &overrides)
    {
      for (const std::string &assignment : overrides)
        apply_override(root, assignment);
      return make_scene(root, file);
    }
  } // namespace



  Scene read_scene(const std::string              &file,
                   const std::vector<std::string> &overrides)
  {
    return make_scene(read_parameter_file(file), file, overrides);
  }



  Scene read_scene_from_text(const std::string              &text,
                             const std::string              &name,
                             const std::vector<std::string> &overrides)
  {
    return make_scene(parse_parameter_text(text, name), name, overrides);
  }
} // namespace auxfem
