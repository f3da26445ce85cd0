#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/reduced_cell/cell_run.h>
#include <auxfem/output/output_folder.h>

namespace auxfem
{
  namespace
  {
    /** Passes samples to a recorder as rows of the history. */
    class CellRows : public CellRecorder
    {
    public:
      explicit CellRows(Recorder &recorder) : recorder(recorder)
      {}

      void begin() override
      {
        constexpr unsigned int n_angles_and_rises = 2;
        recorder.begin_rows(cell_columns(), n_angles_and_rises);
      }

      void sample(const CellSample &sample) override
      {
        energies.add(sample.energies);
        recorder.row(cell_values(sample, energies));
      }

    private:
      Recorder    &recorder;
      EnergyRecord energies;
    };

    RunResult run_in_folder(const Scene         &scene,
                            const MPI_Comm       communicator,
                            const FolderOptions &options)
    {
      RunResult result;
      on_first_rank(communicator,
                    [&]() { result = run_reduced_cell(scene, options); });
      return result;
    }

    RunResult
    observe(const Scene &scene, const MPI_Comm communicator, Recorder &recorder)
    {
      RunResult result;
      on_first_rank(communicator, [&]() {
        CellRows rows(recorder);
        result = run_reduced_cell(scene, rows);
      });
      return result;
    }

    void check_on_first_rank(const Scene &scene, const MPI_Comm communicator)
    {
      on_first_rank(communicator, [&]() { check_reduced_cell(scene); });
    }
  } // namespace

  AnalysisEntry reduced_cell_entry()
  {
    return {"reduced cell",
            "Motion of one star cell of six rigid parts by its two equations.",
            [](const Scene &scene) {
              return scene.analysis == Analysis::simulation &&
                scene.context.model == Model::reduced_cell;
            },
            run_in_folder,
            observe,
            check_on_first_rank,
            {}};
  }
} // namespace auxfem
