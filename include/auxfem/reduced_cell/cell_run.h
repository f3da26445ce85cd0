#ifndef auxfem_reduced_cell_cell_run_h
#define auxfem_reduced_cell_cell_run_h

#include <auxfem/output/recorder.h>
#include <auxfem/reduced_cell/cell_scheme.h>

namespace auxfem
{
  /** Receives the samples of a run of the reduced cell. */
  class CellRecorder
  {
  public:
    virtual ~CellRecorder() = default;

    /** Before the first sample. */
    virtual void begin()
    {}

    /** Samples in order, from the one at t = 0. */
    virtual void sample(const CellSample &sample) = 0;

    /** After the last sample, also after a failure. */
    virtual void finish(const RunResult & /*result*/)
    {}
  };

  /**
   * Computes the reduced cell on the calling rank. Throws InputError or
   * ComputationError; @p recorder has then received all samples.
   */
  RunResult run_reduced_cell(const Scene &scene, CellRecorder &recorder);

  /** The dry run of --check: prints what is simulated, writes nothing. */
  void check_reduced_cell(const Scene &scene);

  /** Keeps the time history of a cell in memory. */
  struct CellHistory : public CellRecorder
  {
    void sample(const CellSample &sample) override
    {
      samples.push_back(sample);
    }

    void finish(const RunResult &result) override
    {
      exit_state = result.exit_state;
    }

    std::vector<CellSample> samples;
    /** `completed`, or why it ended early. */
    std::string exit_state;
  };

  /** Computes @p scene and writes nothing; failures are in the exit state. */
  CellHistory compute_history(const Scene &scene);
} // namespace auxfem

#endif
