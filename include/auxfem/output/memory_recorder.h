#ifndef auxfem_output_memory_recorder_h
#define auxfem_output_memory_recorder_h

#include <auxfem/output/history.h>
#include <auxfem/output/output_times.h>
#include <auxfem/output/recorder.h>
#include <auxfem/time/checkpoint_archive.h>

#include <optional>
#include <vector>

namespace auxfem
{
  /**
   * Keeps the history of a lattice in memory and writes nothing: the columns of
   * history.csv with a row for each step of the scene, or for each of the times
   * that Output/Time between rows asks for; of a resumed run for those that
   * follow. The same on all ranks.
   */
  class MemoryRecorder : public Recorder
  {
  public:
    /** @param scene must outlive the recording. */
    MemoryRecorder(const Scene &scene, MPI_Comm communicator);

    void begin(const Equations &equations) override;

    void start(const Solution &solution) override
    {
      row_list.push_back(history->values(solution));
    }

    void serialize(const Solution    &solution,
                   CheckpointArchive &archive) override
    {
      history->serialize(solution.state, archive);
    }

    std::optional<double> next_time(const double time) const override
    {
      return row_times.after(time);
    }

    void between(const Solution &solution) override
    {
      row_list.push_back(history->values(solution));
    }

    void step(const Solution &solution, const StepReport &report) override;

    const std::vector<Column> &columns() const
    {
      return column_list;
    }

    const std::vector<std::vector<double>> &rows() const
    {
      return row_list;
    }

    /** The numbers of a column, from t = 0 on. Throws InputError if there is no
     * such column. */
    std::vector<double> column(const std::string &name) const;

  private:
    const Scene                     &scene;
    const MPI_Comm                   communicator;
    const OutputTimes                row_times;
    std::optional<History>           history; ///< from begin() on
    std::vector<Column>              column_list;
    std::vector<std::vector<double>> row_list;
  };
} // namespace auxfem

#endif
