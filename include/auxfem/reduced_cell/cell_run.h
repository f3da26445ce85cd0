#ifndef auxfem_reduced_cell_cell_run_h
#define auxfem_reduced_cell_cell_run_h

#include <auxfem/output/recorder.h>
#include <auxfem/reduced_cell/cell_scheme.h>

namespace auxfem
{
  /**
   * One run of the reduced cell, of which @p recorder is told, on the calling
   * rank. Throws InputError or ComputationError; the recorder has then been
   * told of all that was computed.
   */
  RunResult run_reduced_cell(const Scene &scene, Recorder &recorder);

  /** The dry run of --check: prints what is simulated, writes nothing. */
  void check_reduced_cell(const Scene &scene);

  /** Keeps the time history of a cell in memory. */
  struct CellHistory : public Recorder
  {
    void cell(const CellSample &sample) override
    {
      samples.push_back(sample);
    }

    void finish_cell(const RunResult &result) override;

    std::vector<CellSample> samples;
    /** `completed`, or why it ended early. */
    std::string exit_state;
  };

  /** Computes @p scene and writes nothing; failures are in the exit state. */
  CellHistory compute_history(const Scene &scene);
} // namespace auxfem

#endif
