#include <auxfem/analysis/simulation/imperfect_lattice.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/buckling_modes.h>
#include <auxfem/analysis/small_motions/modes.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/output/run_checkpoints.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter_file.h>
#include <auxfem/struts/effects/strut_motion.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    const std::string record       = "state",
                      before       = record + " before the last step",
                      position     = record + " on a path",
                      displacement = record + ": displacement";

    void serialize_before(const UnknownRecords &unknowns,
                          CheckpointArchive    &archive,
                          State                &state)
    {
      bool has_before = state.before.has_value();
      archive.values(before + ": whether it is kept", has_before);
      if (!has_before)
        return state.before.reset();
      if (!archive.is_saving())
        state.before.emplace();
      archive.values(before, state.before->time_of_loads, state.before->dt);
      unknowns.serialize(before + ": displacement",
                         state.before->displacement,
                         archive);
      unknowns.serialize(before + ": residual",
                         state.before->residual,
                         archive);
    }

    /** Large rotations in space are identified by their first unknown. */
    void serialize_rotations(const UnknownRecords &unknowns,
                             const DofNumbering   &numbering,
                             CheckpointArchive    &archive,
                             State                &state)
    {
      std::vector<unsigned int> items;
      std::vector<double>       components;
      for (unsigned int i = 0; i < state.rotations.size(); ++i)
        {
          const Quaternion &rotation = state.rotations[i];
          items.push_back(unknowns.serial_number(numbering.rotations()[i][0]));
          components.push_back(rotation.scalar);
          components.insert(components.end(),
                            rotation.vector.begin_raw(),
                            rotation.vector.end_raw());
        }
      archive.items(record + ": rotations", items, 4, components);
      for (unsigned int i = 0; i < state.rotations.size(); ++i)
        {
          state.rotations[i].scalar = components[4 * i];
          std::copy_n(components.begin() + 4 * i + 1,
                      3,
                      state.rotations[i].vector.begin_raw());
        }
    }

    /** Internal variables. */
    void serialize_history(const RecordLayout &layout,
                           CheckpointArchive  &archive,
                           State              &state)
    {
      for (const Record &effect_record : layout.list())
        {
          const auto first = state.history.begin() + effect_record.first;
          std::vector<double> values(first,
                                     first +
                                       effect_record.items.size() *
                                         effect_record.values_per_item);
          archive.items(record + ": " + effect_record.name,
                        effect_record.items,
                        effect_record.values_per_item,
                        values);
          std::copy(values.begin(), values.end(), first);
        }
    }

    /** Signs mark unknown values. */
    void serialize_position(CheckpointArchive &archive, PathPosition &at)
    {
      double n_negative = at.n_negative ? double(*at.n_negative) : -1.,
             sign       = at.determinant_sign.value_or(0);
      archive.values(position, at.load_factor, n_negative, sign);
      at.n_negative.reset();
      at.determinant_sign.reset();
      if (n_negative >= 0)
        at.n_negative = n_negative;
      if (sign != 0)
        at.determinant_sign = sign;
    }
  } // namespace

  void serialize_state(const Equations   &equations,
                       CheckpointArchive &archive,
                       State             &state)
  {
    const DofNumbering  &numbering = equations.model().numbering;
    const UnknownRecords unknowns(numbering);
    archive.values(record,
                   state.time,
                   state.step,
                   state.largest_force,
                   state.largest_energy);
    unknowns.serialize(displacement, state.displacement, archive);
    unknowns.serialize(record + ": residual", state.residual, archive);
    unknowns.serialize(record + ": largest forces",
                       state.largest_forces,
                       archive);
    unknowns.serialize(record + ": velocity", state.velocity, archive);
    unknowns.serialize(record + ": acceleration", state.acceleration, archive);
    unknowns.serialize(record + ": algorithmic acceleration",
                       state.algorithmic_acceleration,
                       archive);
    unknowns.serialize(record + ": compensation", state.compensation, archive);
    unknowns.serialize(record + ": unknowns without mass",
                       state.is_massless,
                       archive);
    serialize_before(unknowns, archive, state);
    if (state.path)
      serialize_position(archive, *state.path);
    serialize_rotations(unknowns, numbering, archive, state);
    serialize_history(equations.layout().history, archive, state);
    archive.list(record + ": energies", state.energies.amounts());
    archive.sums(record + ": sums of energies", state.energy_sums);
  }

  Vector saved_displacement(const Equations      &equations,
                            const CheckpointData &records)
  {
    return UnknownRecords(equations.model().numbering)
      .values(displacement, records);
  }

  double time_of_saved_state(const CheckpointData &records)
  {
    return records.values(record, 4)[0];
  }

  unsigned long step_of_saved_state(const CheckpointData &records)
  {
    return records.values(record, 4)[1];
  }

  double load_factor_of_saved_state(const CheckpointData &records)
  {
    return records.values(position, 3)[0];
  }

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

    /** Whether it needs the equations of the perfect lattice. */
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
          const StrutMotion strut_motion =
            interpolated(motion_of_strut(numbering, moved, e), {2, 1});
          for (unsigned int c = 0; c < dimension; ++c)
            values[dimension * (n_joints + element.interval.strut) + c] =
              strut_motion.displacement[numbering.n_components() + c];
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
          const GeometryOffsets mode_offsets =
            offsets_of(found.modes[definition.mode - 1].shape, run);
          offsets.add(definition.amplitude / mode_offsets.largest(),
                      mode_offsets);
        }
    }
    /** Parameters that determine the numbering of unknowns. */
    std::string numbering_text(const std::string &parameters,
                               const std::string &file)
    {
      const ParameterSubsection root = parse_parameter_text(parameters, file);
      std::string               text =
        "Dimension = " + root.find_entry("Dimension")->value + '\n';
      for (const char *name : {"Lattice",
                               "Discretization",
                               "Joints",
                               "Rigid parts",
                               "Constraints"})
        if (const ParameterSubsection *const found = root.find_subsection(name))
          text += values_text(*found, std::string(name) + "/");
      return text;
    }

    void add_result(const ImperfectionDefinition &definition,
                    const LatticeRun             &run,
                    const MPI_Comm                communicator,
                    GeometryOffsets              &offsets)
    {
      const RestartedRun other =
        find_run_to_resume(definition.folder, communicator);
      if (numbering_text(other.parameters, definition.folder) !=
          numbering_text(run.scene.all_parameters, run.scene.file))
        throw InputError(
          definition.path + "/Folder = " + definition.folder +
          ": that run has another lattice, joints, rigid parts or "
          "another mesh. Compute it again with those of this "
          "scene");
      const GeometryOffsets displacements =
        offsets_of(saved_displacement(run.equations, other.records), run);
      const double largest = displacements.largest();
      if (largest == 0)
        throw InputError(definition.path + "/Folder = " + definition.folder +
                         ": that run has no displacements");
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
