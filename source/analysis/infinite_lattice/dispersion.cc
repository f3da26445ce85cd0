#include <auxfem/analysis/infinite_lattice/dispersion.h>
#include <auxfem/analysis/small_motions/mesh_error_estimate.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/output/console.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/overview.h>

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

    /** Waves at rest with all inertia and no damping. */
    RunPlan plan_of_waves(const Scene &scene)
    {
      RunPlan plan(scene);
      plan.effects.large_rotation = Switch::off;
      plan.effects.rotary_inertia = Switch::on;
      plan.effects.contact        = Switch::off;
      plan.time.static_start      = false;
      return plan;
    }

    /** Waves along the path, one row for each wave vector. */
    class WaveTable
    {
    public:
      WaveTable(const Scene &scene, const Periodicity &periodicity)
        : n_bands(scene.dispersion.bands)
        , reciprocal(periodicity.reciprocal_vectors())
        , table(scene.output.directory + "/dispersion.csv", columns())
      {
        write_column_reference(scene.output.directory + "/dispersion.units.csv",
                               columns());
      }

      void add(const WaveVector &at, const std::vector<BlochWave> &waves)
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
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
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

    private:
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
            for (std::size_t d = 0; d < reciprocal.size(); ++d)
              list.push_back({"velocity_" + band + "_" + "xyz"[d],
                              "m/s",
                              "group velocity; nan where bands meet"});
          }
        return list;
      }

      const unsigned int                      n_bands;
      const std::vector<dealii::Tensor<1, 3>> reciprocal;
      CsvTable                                table;
      bool                                    has_rows = false;
      double                                  path     = 0; ///< rad/m
      dealii::Tensor<1, 3>                    last;
    };

    std::vector<double> frequencies_of(const std::vector<BlochWave> &waves)
    {
      std::vector<double> frequencies;
      for (const BlochWave &wave : waves)
        frequencies.push_back(wave.angular_frequency);
      return frequencies;
    }

    /** Largest relative change of each band at the corners of the path with
     * finer elements. */
    MeshErrors errors_of(const LatticeRun &run, const BlochWaves &waves)
    {
      const DispersionDefinition &dispersion = run.scene.dispersion;
      LatticeRun                  finer(with_finer_elements(run.model.plan),
                       run.model.numbering.layout().communicator());
      const BlochWaves            finer_waves(finer);
      MeshErrors                  errors;
      errors.relative.assign(dispersion.bands, 0.);
      for (const WaveVector &corner : dispersion.path)
        {
          const WavePhases phases = phases_of(corner);
          const auto       here   = waves.frequencies(phases, dispersion.bands),
                     there = finer_waves.frequencies(phases, dispersion.bands);
          for (std::size_t i = 0; i < std::min(here.size(), there.size()); ++i)
            if (there[i] > 1e-6 * there.back())
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

    Json json_of(const std::vector<BandGap> &gaps)
    {
      Json list = Json::array();
      for (const BandGap &gap : gaps)
        list.push_back({{"below", gap.below},
                        {"lowest_hertz", gap.lowest / turn},
                        {"highest_hertz", gap.highest / turn}});
      return {{"band_gaps", list}};
    }

    RunResult run_on_one_rank(const Scene &scene, const FileRules &rules)
    {
      const DispersionDefinition      &dispersion = scene.dispersion;
      LatticeRun                       run(plan_of_waves(scene), MPI_COMM_SELF);
      const BlochWaves                 waves(run);
      RunReport                        report(scene,
                       run.equations,
                       rules,
                       {{"dispersion.csv", "dispersion.units.csv"}, {}});
      WaveTable                        table(scene, *run.lattice.periodicity);
      std::vector<std::vector<double>> bands;
      for (const WaveVector &at : dispersion.points_of_path())
        {
          end_if_interrupted(MPI_COMM_SELF);
          const auto found = waves.waves(phases_of(at), dispersion.bands);
          table.add(at, found);
          bands.push_back(frequencies_of(found));
        }
      for (const WaveVector &at :
           dispersion.points_of_zone(scene.context.dimension))
        {
          end_if_interrupted(MPI_COMM_SELF);
          bands.push_back(waves.frequencies(phases_of(at), dispersion.bands));
        }
      const std::vector<BandGap> gaps   = band_gaps(bands);
      const MeshErrors           errors = errors_of(run, waves);
      RunResult                  result;
      result.exit_state = "completed";
      result.work       = run.work();
      result.findings   = mesh_findings(run.model.plan, errors, "frequencies");
      report.print(text_of(gaps));
      report.print(mesh_text(run.model.plan, errors));
      report.finish(json_of(gaps), result.findings);
      return result;
    }
  } // namespace

  std::vector<BandGap> band_gaps(const std::vector<std::vector<double>> &bands)
  {
    constexpr double     round_off = 1e-9;
    std::vector<BandGap> gaps;
    std::size_t          n = bands.empty() ? 0 : bands.front().size();
    for (const auto &band : bands)
      n = std::min(n, band.size());
    for (std::size_t i = 0; i + 1 < n; ++i)
      {
        double below = 0, above = std::numeric_limits<double>::infinity();
        for (const auto &band : bands)
          {
            below = std::max(below, band[i]);
            above = std::min(above, band[i + 1]);
          }
        if (above > below * (1 + round_off))
          gaps.push_back({static_cast<unsigned int>(i + 1), below, above});
      }
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
