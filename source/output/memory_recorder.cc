#include <auxfem/output/memory_recorder.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/scene/step_ends.h>

#include <algorithm>

namespace auxfem
{
  MemoryRecorder::MemoryRecorder(const Scene   &scene,
                                 const MPI_Comm communicator)
    : scene(scene)
    , communicator(communicator)
    , row_times(scene.output.row_interval, nearness_of_step_ends(scene.time))
  {}

  void MemoryRecorder::begin(const Equations &equations)
  {
    history.emplace(scene, equations, communicator);
    column_list = history->columns();
    row_list.clear();
  }

  void MemoryRecorder::step(const Solution &solution,
                            const StepReport & /*report*/)
  {
    if (scene.output.row_interval)
      history->note(solution.state);
    else
      row_list.push_back(history->values(solution));
  }

  std::vector<double> MemoryRecorder::column(const std::string &name) const
  {
    const auto position = std::find_if(column_list.begin(),
                                       column_list.end(),
                                       [&name](const Column &candidate) {
                                         return candidate.name == name;
                                       });
    if (position == column_list.end())
      throw InputError("The history of " + scene.file + " has no column '" +
                       name + "'.");
    std::vector<double> numbers;
    numbers.reserve(row_list.size());
    for (const std::vector<double> &row : row_list)
      numbers.push_back(row[position - column_list.begin()]);
    return numbers;
  }
} // namespace auxfem
