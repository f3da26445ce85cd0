#include <auxfem/parameters/errors.h>
#include <auxfem/reduced_cell/cell_output.h>
#include <auxfem/reduced_cell/cell_run.h>

#include <functional>
#include <iostream>

namespace auxfem
{
  namespace
  {
    /** Gives every sample of @p scheme to @p use, from the start to the end. */
    void follow(const Scene                                   &scene,
                CellScheme                                    &scheme,
                const std::function<void(const CellSample &)> &use)
    {
      use(scheme.start());
      for (unsigned long step = 0; step < scene.time.n_steps(); ++step)
        use(scheme.advance());
    }
  } // namespace

  void run_reduced_cell(const Scene &scene, const StartTimes &start)
  {
    CellOutput                        output(scene, start);
    const std::unique_ptr<CellScheme> scheme =
      cell_scheme_entry(scene).make(scene);
    output.begin();
    try
      {
        follow(scene, *scheme, [&output](const CellSample &sample) {
          output.write(sample);
        });
      }
    catch (const std::exception &failure)
      {
        output.finish(failure.what(), scheme->work());
        throw;
      }
    output.finish("completed", scheme->work());
  }

  void check_reduced_cell(const Scene &scene)
  {
    cell_scheme_entry(scene).make(scene);
    std::cout << cell_overview_text(scene) << std::flush;
  }

  CellCourse compute_course(const Scene &scene)
  {
    CellCourse course;
    try
      {
        const std::unique_ptr<CellScheme> scheme =
          cell_scheme_entry(scene).make(scene);
        follow(scene, *scheme, [&course](const CellSample &sample) {
          course.samples.push_back(sample);
        });
        course.exit_state = "completed";
      }
    catch (const InputError &error)
      {
        course.exit_state = error.what();
      }
    catch (const ComputationError &error)
      {
        course.exit_state = error.what();
      }
    return course;
  }
} // namespace auxfem
