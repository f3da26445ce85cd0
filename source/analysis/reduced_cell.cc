#include <auxfem/analysis/analysis.h>
#include <auxfem/output/first_rank.h>
#include <auxfem/reduced_cell/cell_run.h>

namespace auxfem
{
  namespace
  {
    RunResult run_on_first_rank(const Scene   &scene,
                                const MPI_Comm communicator,
                                Recorder      &recorder)
    {
      RunResult result;
      on_first_rank(communicator,
                    [&]() { result = run_reduced_cell(scene, recorder); });
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
              return scene.context.model == Model::reduced_cell;
            },
            run_on_first_rank,
            check_on_first_rank};
  }
} // namespace auxfem
