#ifndef auxfem_output_memory_recorder_h
#define auxfem_output_memory_recorder_h

#include <auxfem/output/history.h>
#include <auxfem/output/output_times.h>
#include <auxfem/output/recorder.h>

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
    void start(const Solution &solution) override;
    void resume(const Solution &solution, const Records &records) override;
    void save(Records &records) const override;
    std::optional<double> next_time(double time) const override;
    void                  between(const Solution &solution) override;
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
