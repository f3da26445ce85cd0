#include <auxfem/analysis/infinite_lattice/effective_response.h>
#include <auxfem/analysis/infinite_lattice/harmonic_moduli.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/model/mean_stress.h>
#include <auxfem/output/overview.h>
#include <auxfem/output/response_files.h>
#include <auxfem/output/run_output.h>
#include <auxfem/time/schemes/static.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  RunPlan plan_of_response(const Scene &scene)
  {
    RunPlan plan(scene);
    plan.time.scheme            = std::make_shared<QuasiStatic>();
    plan.effects.inertia        = Switch::automatic;
    plan.effects.large_rotation = Switch::on;
    plan.has_initial_velocities = false;
    return plan;
  }

  std::vector<double> mean_strains_and_stresses(const LatticeModel &model,
                                                const State        &state)
  {
    const Lattice       &lattice = model.lattice;
    const UnknownLayout &layout  = model.numbering.layout();
    std::vector<double>  values;
    for (unsigned int i = 0; i < lattice.dimension; ++i)
      for (unsigned int j = 0; j < lattice.dimension; ++j)
        {
          const int unknown =
            model.numbering.joint_unknown(lattice.joint_of_axis(j), i);
          values.push_back(layout.is_owned(unknown)
                             ? state.displacement[unknown] /
                               lattice.periodicity->length()
                             : 0.);
        }
    for (unsigned int i = 0; i < lattice.dimension; ++i)
      for (unsigned int j = 0; j < lattice.dimension; ++j)
        values.push_back(sum_of_owned(mean_stress_terms(model, i, j),
                                      state.displacement.data()));
    return layout.sum(values);
  }

  std::optional<UniaxialTangent>
  uniaxial_tangent(const dealii::FullMatrix<double> &moduli,
                   const std::vector<bool>          &is_held,
                   const unsigned int                i)
  {
    const unsigned int dimension = moduli.m() == 4 ? 2 : 3,
                       driven    = dimension * i + i;
    if (is_held[driven])
      return std::nullopt;
    std::vector<unsigned int> adapting;
    for (unsigned int c = 0; c < moduli.m(); ++c)
      if (c != driven && !is_held[c])
        adapting.push_back(c);
    const unsigned int         n = adapting.size();
    dealii::FullMatrix<double> among(n, n);
    dealii::Vector<double>     forces(n), change(n);
    for (unsigned int a = 0; a < n; ++a)
      {
        forces[a] = -moduli(adapting[a], driven);
        for (unsigned int b = 0; b < n; ++b)
          among(a, b) = moduli(adapting[a], adapting[b]);
      }
    if (n > 0)
      try
        {
          among.gauss_jordan();
          among.vmult(change, forces);
        }
      catch (const dealii::ExceptionBase &)
        {
          return std::nullopt;
        }
    UniaxialTangent result{moduli(driven, driven), {}};
    for (unsigned int a = 0; a < n; ++a)
      {
        result.modulus += moduli(driven, adapting[a]) * change[a];
        if (adapting[a] % (dimension + 1) == 0)
          result.poissons_ratios[adapting[a] / (dimension + 1)] = -change[a];
      }
    return result;
  }

  namespace
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();

    /** Whether forces depend on the deformation alone. */
    bool is_elastic(const SimulatedEffects &simulated)
    {
      return !simulated.plasticity && !has_damping(simulated);
    }

    /** Passes everything on to another recorder, and computes the tangent of
     * the infinite lattice at each step. */
    class ResponseRecorder : public Recorder
    {
    public:
      ResponseRecorder(const LatticeRun                 &run,
                       Recorder                         &recorder,
                       const std::optional<std::string> &directory)
        : model(run.model)
        , recorder(recorder)
        , directory(directory)
        , dimension(run.lattice.dimension)
        , communicator(run.model.numbering.layout().communicator())
        , mean(run.scene.mean_deformation)
        , stability(mean.stability_waves, dimension)
      {}

      void begin(const Equations &begun) override
      {
        recorder.begin(begun);
        equations = &begun;
        if (!directory || model.numbering.layout().rank() != 0 ||
            restart_checkpoint() != nullptr)
          return;
        open(std::nullopt);
      }

      void start(const Solution &solution) override
      {
        recorder.start(solution);
        add(solution.state);
      }

      const CheckpointData *restart_checkpoint() const override
      {
        return recorder.restart_checkpoint();
      }

      void store_checkpoint(CheckpointData checkpoint) override
      {
        recorder.store_checkpoint(std::move(checkpoint));
      }

      void keep_checkpoint() override
      {
        recorder.keep_checkpoint();
      }

      void serialize(const Solution    &solution,
                     CheckpointArchive &archive) override
      {
        stability.serialize(archive);
        double length = table ? table->length() : 0;
        length        = dealii::Utilities::MPI::max(length, communicator);
        archive.values("response: length of the table", length);
        // It releases the checkpoint that it restores.
        recorder.serialize(solution, archive);
        if (!archive.is_saving() && directory &&
            model.numbering.layout().rank() == 0)
          open(length);
      }

      std::optional<double> next_time(const double time) const override
      {
        return recorder.next_time(time);
      }

      void row(const Solution &solution) override
      {
        recorder.row(solution);
      }

      void step(const Solution &solution, const StepReport &report) override
      {
        recorder.step(solution, report);
        add(solution.state);
      }

      void finish(const Solution &last, const RunResult &result) override
      {
        recorder.finish(last, result);
      }

      std::vector<Finding> findings() const
      {
        if (stability.losses().empty())
          return {};
        const StabilityLoss &first = stability.losses().front();
        std::ostringstream   text;
        text.precision(4);
        text << "The lattice loses stability at t = " << first.time << " s ("
             << strains_text(first.values) << ") against ";
        if (first.kind == StabilityLoss::Kind::strut)
          text << "bending of struts between their joints";
        else
          {
            text << (first.kind == StabilityLoss::Kind::long_wave
                       ? "waves far longer than the period along ("
                       : "a wave with these parts of the reciprocal vectors: "
                         "(");
            for (unsigned int d = 0; d < dimension; ++d)
              text << (d > 0 ? ", " : "") << first.wave[d];
            text << ')';
          }
        text
          << ". Later results hold only for motions that all periods make "
             "alike. stability.csv has all losses; take more Cells to follow "
             "one.";
        return {{Verdict::doubtful, text.str(), first.time, ""}};
      }

    private:
      std::string strains_text(const std::vector<double> &values) const
      {
        std::ostringstream text;
        text.precision(4);
        for (unsigned int i = 0; i < dimension; ++i)
          text << (i > 0 ? ", " : "") << "strain_" << component_name(i, i)
               << " = " << values[(dimension + 1) * i];
        return text.str();
      }

      /** Opens the files; continues a table of @p length bytes. */
      void open(const std::optional<double> &length)
      {
        const auto        columns = response_columns(dimension);
        const std::string name    = *directory + "/response";
        if (length)
          table.emplace(name + ".csv", columns, *length);
        else
          table.emplace(name + ".csv", columns);
        write_column_reference(name + ".units.csv", columns);
        write_column_reference(*directory + "/stability.units.csv",
                               stability_columns(dimension));
        write_losses();
      }

      void write_losses() const
      {
        CsvTable losses(*directory + "/stability.csv",
                        stability_columns(dimension));
        for (const StabilityLoss &loss : stability.losses())
          {
            std::vector<std::string> row = {name_of(loss.kind),
                                            text_of_cell(loss.time)};
            for (unsigned int d = 0; d < dimension; ++d)
              row.push_back(text_of_cell(loss.wave[d]));
            for (const double value : loss.values)
              row.push_back(text_of_cell(value));
            losses.append_text(row);
          }
      }

      std::vector<bool> held_strains() const
      {
        std::vector<bool> is_held;
        for (unsigned int i = 0; i < dimension; ++i)
          for (unsigned int j = 0; j < dimension; ++j)
            is_held.push_back(mean.component(i, j).is_strain_given &&
                              mean.component(i, j).strain.is_constant());
        return is_held;
      }

      void add(const State &state)
      {
        const std::vector<double> values =
          mean_strains_and_stresses(model, state);
        std::vector<double> row = {state.time};
        const unsigned int  n   = dimension * dimension;
        row.insert(row.end(), values.begin(), values.begin() + n);
        if (!is_elastic(model.plan.simulated))
          row.resize(response_columns(dimension).size(), none);
        else
          add_tangent(state, values, row);
        if (table)
          table->append(row);
      }

      void add_tangent(const State               &state,
                       const std::vector<double> &values,
                       std::vector<double>       &row)
      {
        const PeriodTangent                         tangent(*equations, state);
        const std::vector<bool>                     is_held = held_strains();
        std::vector<std::optional<UniaxialTangent>> along(dimension);
        if (tangent.moduli())
          for (unsigned int i = 0; i < dimension; ++i)
            along[i] = uniaxial_tangent(*tangent.moduli(), is_held, i);
        for (const auto &uniaxial : along)
          row.push_back(uniaxial ? uniaxial->modulus : none);
        for (unsigned int i = 0; i < dimension; ++i)
          for (unsigned int j = 0; j < dimension; ++j)
            if (i != j)
              {
                const double length = values[(dimension + 1) * i],
                             width  = values[(dimension + 1) * j];
                row.push_back(along[i] ? along[i]->poissons_ratios[j] : none);
                row.push_back(length != 0 ? -width / length : none);
              }
        const std::size_t   n_losses = stability.losses().size();
        const WaveStiffness stiffness =
          stability.record(state.time, tangent, values, communicator);
        row.push_back(stiffness.long_waves);
        for (unsigned int d = 0; d < dimension; ++d)
          row.push_back(stiffness.direction[d]);
        row.push_back(stiffness.waves);
        for (unsigned int d = 0; d < dimension; ++d)
          row.push_back(stiffness.wave[d]);
        if (table && stability.losses().size() > n_losses)
          write_losses();
      }

      const LatticeModel              &model;
      Recorder                        &recorder;
      const std::optional<std::string> directory;
      const unsigned int               dimension;
      const MPI_Comm                   communicator;
      const MeanDeformation           &mean;
      const Equations                 *equations = nullptr;
      WaveStability                    stability;
      std::optional<CsvTable>          table; ///< on the first rank
    };
  } // namespace

  RunResult run_effective_response(const Scene   &scene,
                                   const MPI_Comm communicator,
                                   Recorder      &recorder,
                                   const std::optional<std::string> &directory)
  {
    LatticeRun       run(plan_of_response(scene), communicator);
    ResponseRecorder with_tangents(run, recorder, directory);
    return run.run(with_tangents, [&](Recorder &run_recorder) {
      run.advance_to_end(run_recorder);
      return with_tangents.findings();
    });
  }

  AnalysisEntry effective_response_entry()
  {
    return {"effective response",
            "Stress of the infinite lattice under a history of mean strain: "
            "Poisson's ratios, stability against waves.",
            [](const Scene &scene) {
              return scene.analysis == Analysis::effective_response;
            },
            [](const Scene         &scene,
               const MPI_Comm       communicator,
               const FolderOptions &options) {
              return run_effective_response(scene,
                                            communicator,
                                            *make_run_output(scene,
                                                             communicator,
                                                             options),
                                            scene.output.directory);
            },
            [](const Scene   &scene,
               const MPI_Comm communicator,
               Recorder      &recorder) {
              return run_effective_response(scene,
                                            communicator,
                                            recorder,
                                            std::nullopt);
            },
            [](const Scene &scene, const MPI_Comm communicator) {
              LatticeRun run(plan_of_response(scene), communicator);
              run.prepare();
              require_existing_columns(scene, run.lattice);
              show_lattice(scene, run.equations);
            },
            response_contents().names()};
  }
} // namespace auxfem
