#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/scene/general_parameters.h>
#include <auxfem/scene/scene_subsections.h>

#include <set>

namespace auxfem
{
  namespace
  {
    std::string directory_of(const std::string &file)
    {
      const std::size_t slash = file.rfind('/');
      return slash == std::string::npos ? "."
        : slash == 0                    ? "/"
                                        : file.substr(0, slash);
    }

    /** Adds the files that @p subsection and those inside it are written in. */
    void add_files(const ParameterSubsection &subsection,
                   std::set<std::string>     &files)
    {
      // What comes from the command line has no line.
      for (const ParameterEntry &entry : subsection.entries)
        if (entry.location.line > 0)
          files.insert(entry.location.file);
      for (const ParameterSubsection &inner : subsection.subsections)
        {
          if (inner.location.line > 0)
            files.insert(inner.location.file);
          add_files(inner, files);
        }
    }

    void read_subsection(const SceneSubsection &subsection,
                         ParameterValues       &values,
                         Scene                 &scene,
                         Mistakes              &mistakes)
    {
      try
        {
          subsection.read(values, scene);
        }
      catch (const InputError &error)
        {
          mistakes.add(values.location.text() + ": " + error.what());
        }
    }

    /** Without them nothing can be said about what the rest may be. */
    void read_model_and_dimension(const ParameterSubsection &root, Scene &scene)
    {
      const std::optional<Model>        model     = model_of(root);
      const std::optional<unsigned int> dimension = dimension_of(root);
      if (!model || !dimension)
        {
          Mistakes mistakes;
          check_subsection(root, general_schema(), {}, mistakes);
          mistakes.throw_if_any(scene.file);
        }
      scene.context.model     = *model;
      scene.context.dimension = *dimension;
    }

    Scene make_scene(const ParameterSubsection &root, const std::string &file)
    {
      Scene                 scene;
      Mistakes              mistakes;
      std::set<std::string> files = {file};
      add_files(root, files);
      scene.file              = file;
      scene.context.directory = directory_of(file);
      read_model_and_dimension(root, scene);
      check_subsection_names(root, scene.context.model, mistakes);
      for (const SceneSubsection &subsection : scene_subsections())
        if (subsection.schema.serves(scene.context.model))
          {
            std::vector<ParameterValues> found =
              check_subsection(root,
                               subsection.schema,
                               scene.context,
                               mistakes);
            // Without its constants other expressions would seem wrong.
            if (subsection.schema.name.empty() && found.empty())
              mistakes.throw_if_any(file);
            for (ParameterValues &values : found)
              {
                read_subsection(subsection, values, scene, mistakes);
                files.insert(values.files.begin(), values.files.end());
              }
            scene.all_parameters += listing_of(subsection.schema, found);
          }
      scene.newton =
        scene.newton.for_steps_within(scene.time.relative_tolerance);
      check_consistency(scene, mistakes);
      mistakes.throw_if_any(file);
      scene.input_files.assign(files.begin(), files.end());
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
