#include <auxfem/analysis/infinite_lattice/dispersion.h>
#include <auxfem/analysis/infinite_lattice/effective_response.h>
#include <auxfem/analysis/infinite_lattice/period_tangent.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/analysis/small_motions/mesh_error_estimate.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/output/console.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/overview.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/scene/infinite_lattice.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    using WaveVector = DispersionDefinition::WaveVector;

    constexpr double turn = 2 * dealii::numbers::PI;

    WavePhases phases_of(const WaveVector &fractions)
    {
      return {{turn * fractions[0], turn * fractions[1], turn * fractions[2]}};
    }

    /** Waves with all inertia, about rest or about the end of a deformation. */
    RunPlan plan_of_waves(const Scene &scene)
    {
      RunPlan plan(scene);
      plan.effects.large_rotation =
        scene.mean_deformation.is_given() ? Switch::on : Switch::off;
      plan.effects.rotary_inertia = Switch::on;
      if (scene.dispersion.damped)
        include_damping(plan.effects);
      plan.effects.contact   = Switch::off;
      plan.time.static_start = false;
      return plan;
    }

    [[noreturn]] void refuse_unstable(const WaveVector &at)
    {
      std::ostringstream message;
      message
        << "The infinite lattice is unstable at the end of its mean "
           "deformation: the wave with the parts "
        << at[0] << ' ' << at[1] << ' ' << at[2]
        << " of the reciprocal vectors grows, so that there are no steady "
           "waves. Reduce Mean deformation; Analysis = effective response "
           "finds the strain at which stability is lost.";
      throw ComputationError(message.str());
    }

    /** The scene that deforms the lattice before its waves. */
    Scene pressed_scene(const Scene &scene)
    {
      Scene pressed    = scene;
      pressed.analysis = Analysis::effective_response;
      prescribe_mean_deformation(pressed);
      return pressed;
    }

    /**
     * Brings @p run to the end of the mean deformation of its scene. Throws
     * ComputationError if struts touch there or the lattice is unstable against
     * a wave that is asked for.
     */
    void deform(LatticeRun &run)
    {
      const Scene scene = pressed_scene(run.scene);
      if (yields(scene.sections) && scene.effects.plasticity != Switch::off)
        throw InputError(
          "Analysis = dispersion with Mean deformation and "
          "materials that yield: waves about a yielded state are "
          "not computed. Set Effects/Plasticity = off");
      RunPlan plan                     = plan_of_response(scene);
      plan.division                    = run.model.plan.division;
      plan.effects.connector_viscosity = Switch::off;
      plan.effects.strut_damping       = Switch::off;
      plan.effects.strut_relaxation    = Switch::off;
      LatticeRun      pressed(plan, MPI_COMM_SELF);
      Recorder        nobody;
      const RunResult result = pressed.run(nobody);
      if (result.largest_penetration.value_or(0) > 0)
        throw ComputationError(
          "Struts touch each other during the mean deformation, and waves would "
          "open and close their contacts. Reduce Mean deformation, or set "
          "Effects/Contact = off to let struts pass.");
      const PeriodTangent tangent(pressed.equations, pressed.solution.state);
      std::vector<WaveVector> wave_vectors =
        wave_vectors_of_zone(scene.dispersion.zone_points,
                             scene.context.dimension);
      for (const WaveVector &at : scene.dispersion.path)
        wave_vectors.push_back(at);
      for (const WaveVector &at : wave_vectors)
        if (tangent.least_stiffness(phases_of(at)) < 0)
          refuse_unstable(at);
      // The multipliers of images come last; waves have none.
      const State &from = pressed.solution.state;
      State       &to   = run.solution.state;
      std::copy_n(from.displacement.begin(),
                  to.displacement.size(),
                  to.displacement.begin());
      to.rotations = from.rotations;
    }

    /** A run and its waves, on one rank. */
    struct WavesOfRun
    {
      explicit WavesOfRun(const RunPlan &plan) : run(plan, MPI_COMM_SELF)
      {
        if (plan.scene.mean_deformation.is_given())
          deform(run);
        waves.emplace(run);
      }

      LatticeRun                run;
      std::optional<BlochWaves> waves;
    };

    /** Waves along the path, one row for each wave vector. */
    class WaveTable
    {
    public:
      WaveTable(const Scene &scene, const Periodicity &periodicity)
        : n_bands(scene.dispersion.bands)
        , is_damped(scene.dispersion.damped)
        , reciprocal(periodicity.reciprocal_vectors())
        , table(scene.output.directory + "/dispersion.csv", columns())
      {
        write_column_reference(scene.output.directory + "/dispersion.units.csv",
                               columns());
      }

      void add(const WaveVector &at, const std::vector<BlochWave> &waves)
      {
        std::vector<double> row = position_of(at);
        for (unsigned int i = 0; i < n_bands; ++i)
          {
            const bool exists = i < waves.size();
            row.push_back(exists ? waves[i].angular_frequency / turn : none);
            for (std::size_t d = 0; d < reciprocal.size(); ++d)
              row.push_back(exists && waves[i].group_velocity
                              ? (*waves[i].group_velocity)[d]
                              : none);
          }
        table.append(row);
      }

      void add(const WaveVector &at, const std::vector<DampedWave> &waves)
      {
        std::vector<double> row = position_of(at);
        for (unsigned int i = 0; i < n_bands; ++i)
          {
            const bool exists = i < waves.size();
            row.push_back(exists ? waves[i].angular_frequency / turn : none);
            row.push_back(exists ? waves[i].decay : none);
          }
        table.append(row);
      }

    private:
      static constexpr double none = std::numeric_limits<double>::quiet_NaN();

      /** Columns of a wave vector. */
      std::vector<double> position_of(const WaveVector &at)
      {
        dealii::Tensor<1, 3> k;
        for (std::size_t d = 0; d < reciprocal.size(); ++d)
          k += turn * at[d] * reciprocal[d];
        if (has_rows)
          path += (k - last).norm();
        has_rows                = true;
        last                    = k;
        std::vector<double> row = {path};
        for (std::size_t d = 0; d < reciprocal.size(); ++d)
          row.push_back(at[d]);
        for (std::size_t d = 0; d < reciprocal.size(); ++d)
          row.push_back(k[d]);
        return row;
      }

      std::vector<Column> columns() const
      {
        std::vector<Column> list = {
          {"path", "rad/m", "length of the path of wave vectors"}};
        for (std::size_t d = 0; d < reciprocal.size(); ++d)
          list.push_back({"part_" + std::to_string(d + 1),
                          "1",
                          "part of the reciprocal vector"});
        for (std::size_t d = 0; d < reciprocal.size(); ++d)
          list.push_back({std::string("k") + "xyz"[d], "rad/m", "wave vector"});
        for (unsigned int i = 1; i <= n_bands; ++i)
          {
            const std::string band = std::to_string(i);
            list.push_back({"frequency_" + band, "Hz", "of the band"});
            if (is_damped)
              list.push_back(
                {"decay_" + band, "1/s", "rate at which the amplitude decays"});
            for (std::size_t d = 0; d < reciprocal.size() && !is_damped; ++d)
              list.push_back({"velocity_" + band + "_" + "xyz"[d],
                              "m/s",
                              "group velocity; nan where bands meet"});
          }
        return list;
      }

      const unsigned int                      n_bands;
      const bool                              is_damped;
      const std::vector<dealii::Tensor<1, 3>> reciprocal;
      CsvTable                                table;
      bool                                    has_rows = false;
      double                                  path     = 0; ///< rad/m
      dealii::Tensor<1, 3>                    last;
    };

    template <class Wave>
    std::vector<double> frequencies_of(const std::vector<Wave> &waves)
    {
      std::vector<double> frequencies;
      for (const Wave &wave : waves)
        frequencies.push_back(wave.angular_frequency);
      return frequencies;
    }

    /** Largest relative change of each band at the corners of the path with
     * finer elements. */
    MeshErrors errors_of(const LatticeRun &run, const BlochWaves &waves)
    {
      const DispersionDefinition &dispersion = run.scene.dispersion;
      const WavesOfRun            finer(with_finer_elements(run.model.plan));
      MeshErrors                  errors;
      errors.relative.assign(dispersion.bands, 0.);
      for (const WaveVector &corner : dispersion.path)
        {
          const WavePhases phases = phases_of(corner);
          const auto       here   = waves.frequencies(phases, dispersion.bands),
                     there = finer.waves->frequencies(phases, dispersion.bands);
          for (std::size_t i = 0; i < std::min(here.size(), there.size()); ++i)
            if (there[i] > 1e-3 * there.back())
              errors.relative[i] =
                std::max(errors.relative[i], std::abs(here[i] / there[i] - 1));
        }
      return errors;
    }

    std::string text_of(const std::vector<BandGap> &gaps)
    {
      std::ostringstream text;
      text.precision(6);
      for (const BandGap &gap : gaps)
        text << "\n  between bands " << gap.below << " and " << gap.below + 1
             << ": " << gap.lowest / turn << " to " << gap.highest / turn
             << " Hz";
      return gaps.empty() ? "\nThe bands leave no gap."
                          : "\nBand gaps" + text.str();
    }

    Json json_of(const std::vector<FrequencyBand> &bands,
                 const std::vector<BandGap>       &gaps)
    {
      Json all_bands = Json::array(), all_gaps = Json::array();
      for (const FrequencyBand &band : bands)
        all_bands.push_back({{"lowest_hertz", band.lowest / turn},
                             {"highest_hertz", band.highest / turn}});
      for (const BandGap &gap : gaps)
        all_gaps.push_back({{"below", gap.below},
                            {"lowest_hertz", gap.lowest / turn},
                            {"highest_hertz", gap.highest / turn}});
      return {{"bands", all_bands}, {"band_gaps", all_gaps}};
    }

    RunResult run_on_one_rank(const Scene &scene, const FileRules &rules)
    {
      const DispersionDefinition      &dispersion = scene.dispersion;
      const WavesOfRun                 computed(plan_of_waves(scene));
      const LatticeRun                &run   = computed.run;
      const BlochWaves                &waves = *computed.waves;
      RunReport                        report(scene,
                       run.equations,
                       rules,
                       {{"dispersion.csv", "dispersion.units.csv"}, {}});
      WaveTable                        table(scene, *run.lattice.periodicity);
      std::vector<std::vector<double>> frequencies;
      for (const WaveVector &at : dispersion.points_of_path())
        {
          end_if_interrupted(MPI_COMM_SELF);
          const auto add = [&](const auto &found) {
            table.add(at, found);
            frequencies.push_back(frequencies_of(found));
          };
          if (dispersion.damped)
            add(waves.damped_waves(phases_of(at), dispersion.bands));
          else
            add(waves.waves(phases_of(at), dispersion.bands));
        }
      for (const WaveVector &at : wave_vectors_of_zone(dispersion.zone_points,
                                                       scene.context.dimension))
        {
          end_if_interrupted(MPI_COMM_SELF);
          frequencies.push_back(
            dispersion.damped
              ? frequencies_of(
                  waves.damped_waves(phases_of(at), dispersion.bands))
              : waves.frequencies(phases_of(at), dispersion.bands));
        }
      const std::vector<FrequencyBand> bands  = frequency_bands(frequencies);
      const std::vector<BandGap>       gaps   = band_gaps(bands);
      const MeshErrors                 errors = errors_of(run, waves);
      RunResult                        result;
      result.exit_state = "completed";
      result.work       = run.work();
      result.findings   = mesh_findings(run.model.plan, errors, "frequencies");
      report.print(text_of(gaps));
      report.print(mesh_text(run.model.plan, errors));
      report.finish(json_of(bands, gaps), result.findings);
      return result;
    }
  } // namespace

  std::vector<FrequencyBand>
  frequency_bands(const std::vector<std::vector<double>> &frequencies)
  {
    std::vector<FrequencyBand> bands;
    if (frequencies.empty())
      return bands;
    for (const double frequency : frequencies.front())
      bands.push_back({frequency, frequency});
    for (const std::vector<double> &ascending : frequencies)
      {
        bands.resize(std::min(bands.size(), ascending.size()));
        for (std::size_t i = 0; i < bands.size(); ++i)
          {
            bands[i].lowest  = std::min(bands[i].lowest, ascending[i]);
            bands[i].highest = std::max(bands[i].highest, ascending[i]);
          }
      }
    return bands;
  }

  std::vector<BandGap> band_gaps(const std::vector<FrequencyBand> &bands)
  {
    constexpr double     round_off = 1e-9;
    std::vector<BandGap> gaps;
    for (std::size_t i = 0; i + 1 < bands.size(); ++i)
      if (bands[i + 1].lowest > bands[i].highest * (1 + round_off))
        gaps.push_back({static_cast<unsigned int>(i + 1),
                        bands[i].highest,
                        bands[i + 1].lowest});
    return gaps;
  }

  RunResult run_dispersion(const Scene         &scene,
                           const MPI_Comm       communicator,
                           const FolderOptions &options)
  {
    RunResult result;
    on_first_rank(communicator,
                  [&]() { result = run_on_one_rank(scene, options.rules); });
    return result;
  }

  AnalysisEntry dispersion_entry()
  {
    return {"dispersion",
            "Waves of the infinite lattice that repeats the cells: frequencies "
            "by wave vector, group velocities, band gaps.",
            [](const Scene &scene) {
              return scene.analysis == Analysis::dispersion;
            },
            run_dispersion,
            nullptr,
            [](const Scene &scene, const MPI_Comm communicator) {
              LatticeRun run(plan_of_waves(scene), communicator);
              show_lattice(scene, run.equations);
            },
            {"dispersion.csv", "dispersion.units.csv"}};
  }
} // namespace auxfem
