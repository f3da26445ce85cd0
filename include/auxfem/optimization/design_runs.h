#ifndef auxfem_optimization_design_runs_h
#define auxfem_optimization_design_runs_h

#include <auxfem/optimization/goals.h>
#include <auxfem/parameters/text.h>
#include <auxfem/study/scene_cases.h>

#include <mpi.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Values of all design variables as parts of their ranges, from 0 to 1. */
  using DesignPoint = std::vector<double>;

  /** The point of the values of @p scene. Throws InputError for a variable
   * that is no number there or outside of its bounds. */
  DesignPoint first_design(const Scene &scene);

  /** Texts of the parameters at @p point. */
  std::vector<std::string> texts_of(const Scene       &scene,
                                    const DesignPoint &point);

  /** A design and its results. */
  struct Design
  {
    DesignPoint               point;
    std::string               folder; ///< of its run
    std::optional<GoalValues> goals;  ///< none if the run has failed
    std::string               verdict, exit_state;
    bool is_reused = false; ///< an earlier optimization has run it

    /** Whether its results are there and may be used. */
    bool is_usable() const;
  };

  Json   json_of(const Design &design);
  Design design_of(const Json &json);

  /**
   * Whether @p one is better than @p other: usable, within constraints up to
   * @p tolerance, of less merit in objective @p objective; without both being
   * within constraints, of less excess.
   */
  bool is_better(const Design &one,
                 const Design &other,
                 const Goals  &goals,
                 double        tolerance,
                 unsigned int  objective = 0);

  /** Receives a new design on the first rank of a communicator. */
  using DesignListener = std::function<void(const Design &)>;

  /** Runs designs of a scene, each once; the same on all ranks. */
  class DesignRuns
  {
  public:
    /**
     * @param parent folder for numbered folders of the runs
     * @param known designs that need no run
     * All references must outlive the object.
     */
    DesignRuns(const Scene               &scene,
               Goals                     &goals,
               MPI_Comm                   communicator,
               const FileRules           &rules,
               const std::string         &parent,
               const std::vector<Design> &known,
               DesignListener             listener);

    /** The design at @p point. Throws Interrupted. Collective. */
    const Design &at(const DesignPoint &point);

    /** Designs at @p points; new ones run side by side if there are enough.
     * Throws Interrupted. Collective. */
    std::vector<Design> at_all(const std::vector<DesignPoint> &points);

    /** Designs that this object has run, in their order. */
    const std::vector<Design> &designs() const
    {
      return list;
    }

    Goals &goals()
    {
      return goal_values;
    }

    const Scene &scene() const
    {
      return designed_scene;
    }

    MPI_Comm communicator() const
    {
      return ranks;
    }

  private:
    void run(const std::vector<DesignPoint> &points);

    const Scene      &designed_scene;
    Goals            &goal_values;
    MPI_Comm          ranks;
    const FileRules  &rules;
    const std::string parent;
    DesignListener    listener;
    /** Designs by the texts of their parameters. */
    std::map<std::vector<std::string>, Design> known;
    std::vector<Design>                        list;
  };

  /** The case of the design at @p point, without graphics and checkpoints. */
  SceneCase case_of_design(const Scene       &scene,
                           const DesignPoint &point,
                           const std::string &folder);

  /** Results of the run of @p one on all ranks. Collective. */
  CaseResults results_on_all_ranks(const Scene     &scene,
                                   const SceneCase &one,
                                   const CaseEnd   &end,
                                   MPI_Comm         communicator);
} // namespace auxfem

#endif
