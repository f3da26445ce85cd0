#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/inheritance.h>
#include <auxfem/scene/constants.h>
#include <auxfem/scene/general_parameters.h>
#include <auxfem/scene/graded_sections.h>
#include <auxfem/scene/infinite_lattice.h>
#include <auxfem/scene/scene.h>

#include <algorithm>
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

    /** Adds the files in which @p subsection and its inner ones are written. */
    void add_files(const ParameterSubsection &subsection,
                   std::set<std::string>     &files)
    {
      // Entries of the command line have no line.
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

    /** Reads `Model` and `Dimension`, on which all other checks depend. */
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

    /** Number of groups in the subsections @p name. */
    std::size_t n_groups(const ParameterSubsection &root,
                         const std::string         &name)
    {
      std::size_t n = 0;
      for (const ParameterSubsection &subsection : root.subsections)
        if (subsection.name == name)
          n += subsection.subsections.size();
      return n;
    }

    Scene make_scene(ParameterSubsection root, const std::string &file)
    {
      Scene                 scene;
      Mistakes              mistakes;
      std::set<std::string> files = {file};
      add_files(root, files);
      scene.file              = file;
      scene.context.directory = directory_of(file);
      read_model_and_dimension(root, scene);
      scene.given_parameters = std::make_shared<ParameterSubsection>(root);
      check_subsection_names(root, scene.context.model, mistakes);
      inherit_values(sections_schema(),
                     base_section_parameter(),
                     root,
                     mistakes);
      for (const SceneSubsection &subsection : scene_subsections())
        if (subsection.schema.serves(scene.context.model))
          {
            std::vector<ParameterValues> groups =
              check_subsection(root,
                               subsection.schema,
                               scene.context,
                               mistakes);
            // Without constants or a material, what uses them would be refused,
            // too.
            if ((subsection.schema.name.empty() && groups.empty()) ||
                (subsection.schema.name == materials_schema().name &&
                 groups.size() < n_groups(root, subsection.schema.name)))
              mistakes.throw_if_any(file);
            for (ParameterValues &values : groups)
              {
                read_subsection(subsection, values, scene, mistakes);
                files.insert(values.files.begin(), values.files.end());
              }
            scene.all_parameters += listing_of(subsection.schema, groups);
            scene.changed_parameters += changes_in(subsection.schema, groups);
          }
      scene.newton =
        scene.newton.for_steps_within(scene.time.relative_tolerance);
      check_consistency(scene, mistakes);
      mistakes.throw_if_any(file);
      if (is_infinite(scene.analysis))
        make_infinite(scene, mistakes);
      mistakes.throw_if_any(file);
      scene.input_files.assign(files.begin(), files.end());
      grade_sections(scene);
      if (is_infinite(scene.analysis) && scene.analysis != Analysis::dispersion)
        prescribe_mean_deformation(scene);
      return scene;
    }

    Scene make_scene(ParameterSubsection             root,
                     const std::string              &file,
                     const std::vector<std::string> &overrides)
    {
      std::vector<std::string> path_subsections;
      for (const SubsectionSchema &schema : scene_schemas())
        if (schema.form == SubsectionSchema::Form::path_entries)
          path_subsections.push_back(schema.name);
      for (const std::string &assignment : overrides)
        {
          const std::size_t equals = assignment.find('=');
          if (const auto constant = constant_in(assignment.substr(0, equals));
              constant && equals != std::string::npos)
            set_constant(root, *constant, assignment.substr(equals + 1));
          else
            apply_override(root, assignment, path_subsections);
        }
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

  Scene scene_of_case(const Scene                    &scene,
                      const std::vector<std::string> &overrides)
  {
    ParameterSubsection         root    = *scene.given_parameters;
    const std::set<std::string> removed = {sweep_schema().name,
                                           sampling_schema().name,
                                           design_variables_schema().name,
                                           optimization_schema().name};
    root.subsections.erase(
      std::remove_if(root.subsections.begin(),
                     root.subsections.end(),
                     [&](const ParameterSubsection &subsection) {
                       return removed.count(subsection.name) > 0;
                     }),
      root.subsections.end());
    return make_scene(root, scene.file, overrides);
  }

  namespace
  {
    void set_general(ParameterValues &values, Scene &scene)
    {
      scene.title             = read_title(values);
      scene.analysis          = read_analysis(values);
      scene.context.constants = read_constants(values);
    }

    /** Needs the analysis and the sections, on which defaults depend. */
    void set_discretization(ParameterValues &values, Scene &scene)
    {
      scene.discretization = read_discretization(values,
                                                 is_linearized(scene.analysis),
                                                 yields(scene.sections),
                                                 have_tapers(scene.sections));
    }

    /** A material that cannot be read keeps its name, so that sections that use
     * it are no further mistakes. */
    void add_material(ParameterValues &values, Scene &scene)
    {
      MaterialDefinition material;
      material.name    = values.name();
      material.density = 0;
      scene.materials.push_back(material);
      scene.materials.back() = read_material(values);
    }

    /** Needs the materials. */
    void add_section(ParameterValues &values, Scene &scene)
    {
      scene.sections.push_back(
        read_section(values, scene.materials, scene.sections));
    }

    void add_load(ParameterValues &values, Scene &scene)
    {
      const auto load = read_load(values);
      if (const auto *on_joints = std::get_if<JointLoadDefinition>(&load))
        scene.joint_loads.push_back(*on_joints);
      else if (const auto *on_struts = std::get_if<LineLoadDefinition>(&load))
        scene.line_loads.push_back(*on_struts);
      else if (const auto *pressure = std::get_if<PressureDefinition>(&load))
        scene.pressures.push_back(*pressure);
      else
        for (const InitialStrainDefinition &strain :
             std::get<std::vector<InitialStrainDefinition>>(load))
          scene.initial_strains.push_back(strain);
    }

    void add_plate(ParameterValues &values, Scene &scene)
    {
      const PlateDefinition plate = read_plate(values);
      if (plate.support)
        scene.supports.push_back(*plate.support);
      if (plate.mass)
        scene.masses.push_back(*plate.mass);
      if (plate.initial_velocity)
        scene.initial_velocities.push_back(*plate.initial_velocity);
      scene.plates.push_back(plate);
    }

    void add_probe(ParameterValues &values, Scene &scene)
    {
      scene.output.probes.push_back(read_probe(values));
    }

    void add_column(ParameterValues &values, Scene &scene)
    {
      scene.output.columns.push_back(read_derived_column(values));
    }

    /** Adds to the figures what @p read finds. */
    template <auto read>
    void add_figures(ParameterValues &values, Scene &scene)
    {
      read(values, scene.figures);
    }

    /** Needs the study, which set<&Scene::study> would overwrite. */
    void add_quantity(ParameterValues &values, Scene &scene)
    {
      scene.study.quantities.push_back(read_quantity(values));
    }

    void add_swept_parameter(ParameterValues &values, Scene &scene)
    {
      scene.sweep.parameters.push_back(read_swept_parameter(values));
    }

    void add_design_variable(ParameterValues &values, Scene &scene)
    {
      scene.optimization.variables.push_back(read_design_variable(values));
    }

    void set_optimization(ParameterValues &values, Scene &scene)
    {
      read_optimization(values, scene.optimization);
    }

    void set_sampling(ParameterValues &values, Scene &scene)
    {
      read_sampling(values, scene.sweep);
    }

    /** Assigns the result of @p read to @p member. */
    template <auto member, auto read>
    void set(ParameterValues &values, Scene &scene)
    {
      scene.*member = read(values);
    }

    /** Appends the result of @p read to @p list. */
    template <auto list, auto read>
    void add(ParameterValues &values, Scene &scene)
    {
      (scene.*list).push_back(read(values));
    }
  } // namespace



  const std::vector<SceneSubsection> &scene_subsections()
  {
    static const std::vector<SceneSubsection> all = {
      {general_schema(), set_general},
      {reduced_cell_schema(), set<&Scene::reduced_cell, read_reduced_cell>},
      {lattice_schema(), set<&Scene::lattice, read_lattice>},
      {sets_schema(), add<&Scene::sets, read_set>},
      {imperfections_schema(), add<&Scene::imperfections, read_imperfection>},
      {materials_schema(), add_material},
      {sections_schema(), add_section},
      {rigid_parts_schema(), add<&Scene::rigid_parts, read_rigid_part>},
      {joints_schema(), add<&Scene::joints, read_joint>},
      {connectors_schema(), add<&Scene::connectors, read_connector>},
      {constraints_schema(), add<&Scene::constraints, read_constraint>},
      {supports_schema(), add<&Scene::supports, read_support>},
      {masses_schema(), add<&Scene::masses, read_mass>},
      {loads_schema(), add_load},
      {gravity_schema(), set<&Scene::gravity, read_gravity>},
      {base_motion_schema(), set<&Scene::base_motion, read_base_motion>},
      {initial_velocities_schema(),
       add<&Scene::initial_velocities, read_initial_velocity>},
      {plates_schema(), add_plate},
      {contact_schema(), set<&Scene::contact, read_contact>},
      {discretization_schema(), set_discretization},
      {effects_schema(), set<&Scene::effects, read_effects>},
      {time_schema(), set<&Scene::time, read_time>},
      {newton_schema(), set<&Scene::newton, read_newton>},
      {solver_schema(), set<&Scene::solver, read_solver>},
      {output_schema(), set<&Scene::output, read_output>},
      {probes_schema(), add_probe},
      {columns_schema(), add_column},
      {evaluation_schema(), add_figures<read_evaluation>},
      {crush_curve_schema(), add_figures<read_crush_curve>},
      {transmission_schema(), add_figures<read_transmission>},
      {stresses_schema(), add_figures<read_stress_probe>},
      {member_forces_schema(), add_figures<read_member_forces>},
      {modes_schema(), set<&Scene::modes, read_modes>},
      {path_schema(), set<&Scene::path, read_path>},
      {frequency_response_schema(),
       set<&Scene::frequency_response, read_frequency_response>},
      {mean_deformation_schema(),
       set<&Scene::mean_deformation, read_mean_deformation>},
      {dispersion_schema(), set<&Scene::dispersion, read_dispersion>},
      {study_schema(), set<&Scene::study, read_study>},
      {quantities_schema(), add_quantity},
      {sweep_schema(), add_swept_parameter},
      {sampling_schema(), set_sampling},
      {design_variables_schema(), add_design_variable},
      {optimization_schema(), set_optimization}};
    return all;
  }



  std::vector<SubsectionSchema> scene_schemas()
  {
    std::vector<SubsectionSchema> schemas;
    for (const SceneSubsection &subsection : scene_subsections())
      schemas.push_back(subsection.schema);
    return schemas;
  }



  void check_subsection_names(const ParameterSubsection &root,
                              const Model                model,
                              Mistakes                  &mistakes)
  {
    std::vector<std::string> known, others;
    for (const SceneSubsection &subsection : scene_subsections())
      if (!subsection.schema.name.empty())
        (subsection.schema.serves(model) ? known : others)
          .push_back(subsection.schema.name);
    const auto is_among = [](const std::vector<std::string> &names,
                             const std::string              &name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const ParameterSubsection &subsection : root.subsections)
      {
        if (is_among(known, subsection.name))
          continue;
        mistakes.add(subsection.location.text() + ": " +
                     (!is_among(others, subsection.name)
                        ? "unknown subsection \"" + subsection.name + "\"" +
                          did_you_mean(subsection.name, known)
                        : "subsection \"" + subsection.name +
                          "\" has no meaning with Model = " + name_of(model) +
                          ". Remove it or choose another Model") +
                     "\n  Allowed here: " + joined(known));
      }
  }
} // namespace auxfem
