#include <auxfem/output/energy_judgement.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/reduced_cell/cell_output.h>
#include <auxfem/reduced_cell/cell_run.h>
#include <auxfem/time/interruption.h>

#include <iostream>

namespace auxfem
{
  RunResult run_reduced_cell(const Scene &scene, CellRecorder &recorder)
  {
    const std::unique_ptr<CellScheme> scheme = make_cell_scheme(scene);
    RunResult                         result;
    EnergyJudgement judgement(EnergyJudgement::Kind::reduced_cell);
    const auto      record = [&](const CellSample &sample) {
      result.time = sample.time;
      judgement.add(sample.energies, sample.time);
      recorder.sample(sample);
    };
    const auto finish = [&](const std::string &exit_state) {
      result.exit_state      = exit_state;
      result.work.iterations = scheme->work();
      for (const Finding &finding : judgement.findings())
        result.findings.push_back(finding);
      recorder.finish(result);
    };
    recorder.begin();
    try
      {
        const CellSample at_start = scheme->start();
        judgement.start(at_start.energies);
        record(at_start);
        for (; result.work.steps < scene.time.n_steps(); ++result.work.steps)
          {
            end_if_interrupted(MPI_COMM_SELF);
            record(scheme->advance());
          }
      }
    catch (const std::exception &failure)
      {
        result.findings = {result.work.steps == 0
                             ? nothing_computed(result.time)
                             : incomplete(result.time)};
        finish(failure.what());
        throw;
      }
    finish("completed");
    return result;
  }

  void check_reduced_cell(const Scene &scene)
  {
    // Finds loads that are no numbers.
    make_cell_scheme(scene)->start();
    std::cout << cell_overview_text(scene) << std::flush;
  }

  CellHistory compute_history(const Scene &scene)
  {
    CellHistory history;
    try
      {
        run_reduced_cell(scene, history);
      }
    catch (const InputError &error)
      {
        history.exit_state = error.what();
      }
    catch (const ComputationError &)
      {
        // The history knows why.
      }
    return history;
  }
} // namespace auxfem
