#include <auxfem/analysis/imperfect_lattice.h>
#include <auxfem/analysis/lattice_run.h>
#include <auxfem/analysis/saved_state.h>
#include <auxfem/analysis/small_motions/buckling_modes.h>
#include <auxfem/analysis/small_motions/modes.h>
#include <auxfem/equations/strut_motion.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/model/imperfections.h>
#include <auxfem/output/run_checkpoints.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter_file.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    using Type = ImperfectionDefinition::Type;

    bool is_mode(const ImperfectionDefinition &definition)
    {
      return definition.type == Type::buckling_mode;
    }

    bool is_result(const ImperfectionDefinition &definition)
    {
      return definition.type == Type::result;
    }

    /** Those that the equations of the designed lattice are needed for. */
    bool is_computed(const ImperfectionDefinition &definition)
    {
      return is_mode(definition) || is_result(definition);
    }

    /** Displacements of joints and middles of struts in @p shape, on all ranks. */
    GeometryOffsets offsets_of(const Vector &shape, const LatticeRun &run)
    {
      const DofNumbering  &numbering = run.model.numbering;
      const UnknownLayout &layout    = numbering.layout();
      const unsigned int   dimension = run.lattice.dimension,
                         n_joints    = run.lattice.n_structural_joints();
      std::vector<double> values(dimension *
                                   (n_joints + run.lattice.struts.size()),
                                 0.);
      for (unsigned int joint = 0; joint < n_joints; ++joint)
        for (unsigned int c = 0; c < dimension; ++c)
          if (const int i = numbering.joint_unknown(joint, c);
              layout.is_owned(i))
            values[dimension * joint + c] = shape[i];
      State moved        = run.solution.state;
      moved.displacement = shape;
      for (unsigned int e = 0; e < numbering.elements().size(); ++e)
        {
          const DofNumbering::Element &element = numbering.elements()[e];
          if (!element.is_owned || element.interval.begin != 0)
            continue;
          const StrutMotion of_strut =
            interpolated(motion_of_strut(numbering, moved, e), {2, 1});
          for (unsigned int c = 0; c < dimension; ++c)
            values[dimension * (n_joints + element.interval.strut) + c] =
              of_strut.displacement[numbering.n_components() + c];
        }
      values = layout.sum(values);
      GeometryOffsets offsets(run.lattice);
      for (unsigned int i = 0; i < n_joints; ++i)
        for (unsigned int c = 0; c < dimension; ++c)
          offsets.joints[i][c] = values[dimension * i + c];
      for (unsigned int i = 0; i < run.lattice.struts.size(); ++i)
        if (run.lattice.struts[i].is_rigid())
          offsets.middles[i] = offsets.mean_of_ends(run.lattice.struts[i]);
        else
          for (unsigned int c = 0; c < dimension; ++c)
            offsets.middles[i][c] = values[dimension * (n_joints + i) + c];
      return offsets;
    }

    void add_modes(const Scene     &scene,
                   const MPI_Comm   communicator,
                   GeometryOffsets &offsets)
    {
      unsigned int n_modes = 0;
      std::string  paths;
      for (const ImperfectionDefinition &definition : scene.imperfections)
        if (is_mode(definition))
          {
            n_modes = std::max(n_modes, definition.mode);
            paths += (paths.empty() ? "" : ", ") + definition.path;
          }
      RunPlan designed =
        plan_of_modes(scene, Analysis::buckling, scene.time.static_start);
      designed.has_imperfections = false;
      LatticeRun run(designed, communicator);
      run.prepare();
      if (designed.time.static_start)
        run.start();
      const BucklingModes found =
        buckling_modes_of(run, n_modes, paths + ", Type = buckling mode");
      for (const ImperfectionDefinition &definition : scene.imperfections)
        {
          if (!is_mode(definition))
            continue;
          if (definition.mode > found.modes.size())
            throw InputError(
              definition.path + "/Mode = " + std::to_string(definition.mode) +
              ": the lattice has only " + std::to_string(found.modes.size()) +
              " buckling modes with this mesh and these loads");
          const GeometryOffsets of_mode =
            offsets_of(found.modes[definition.mode - 1].shape, run);
          offsets.add(definition.amplitude / of_mode.largest(), of_mode);
        }
    }
    /** What decides which unknowns there are. */
    std::string numbering_text(const std::string &parameters,
                               const std::string &file)
    {
      const ParameterSubsection root = parse_parameter_text(parameters, file);
      std::string               text =
        "Dimension = " + root.find_entry("Dimension")->value + '\n';
      for (const char *name :
           {"Lattice", "Discretization", "Joints", "Rigid parts"})
        if (const ParameterSubsection *const found = root.find_subsection(name))
          text += values_text(*found, std::string(name) + "/");
      return text;
    }

    void add_result(const ImperfectionDefinition &definition,
                    const LatticeRun             &run,
                    const MPI_Comm                communicator,
                    GeometryOffsets              &offsets)
    {
      const RunToResume other =
        find_run_to_resume(definition.folder, communicator);
      if (numbering_text(other.parameters, definition.folder) !=
          numbering_text(run.scene.all_parameters, run.scene.file))
        throw InputError(definition.path + "/Folder = " + definition.folder +
                         ": that run has another lattice, other joints, rigid "
                         "parts or another mesh. Compute it again with those "
                         "of this scene");
      const GeometryOffsets displacements =
        offsets_of(saved_displacement(run.equations, other.records), run);
      const double largest = displacements.largest();
      if (largest == 0)
        throw InputError(definition.path + "/Folder = " + definition.folder +
                         ": nothing has moved in that run");
      offsets.add(definition.amplitude / largest, displacements);
    }

    void add_results(const RunPlan   &plan,
                     const MPI_Comm   communicator,
                     GeometryOffsets &offsets)
    {
      RunPlan designed           = plan;
      designed.has_imperfections = false;
      const LatticeRun run(designed, communicator);
      for (const ImperfectionDefinition &definition : plan.scene.imperfections)
        if (is_result(definition))
          add_result(definition, run, communicator, offsets);
    }
  } // namespace

  Lattice imperfect_lattice(const RunPlan &plan, const MPI_Comm communicator)
  {
    const Scene &scene = plan.scene;
    if (!plan.has_imperfections)
      return designed_lattice(scene);
    const auto has = [&scene](bool (*kind)(const ImperfectionDefinition &)) {
      return std::any_of(scene.imperfections.begin(),
                         scene.imperfections.end(),
                         kind);
    };
    if (!has(is_computed))
      return build_lattice(scene);
    GeometryOffsets offsets = given_offsets(scene, designed_lattice(scene));
    if (has(is_mode))
      add_modes(scene, communicator, offsets);
    if (has(is_result))
      add_results(plan, communicator, offsets);
    return build_lattice(scene, &offsets);
  }
} // namespace auxfem
