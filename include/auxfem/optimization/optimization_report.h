#ifndef auxfem_optimization_optimization_report_h
#define auxfem_optimization_optimization_report_h

#include <auxfem/optimization/optimization.h>
#include <auxfem/output/verdict.h>
#include <auxfem/parameters/text.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** @name Files of an optimization in its folder */
  ///@{
  inline const std::string design_table_file = "optimization.csv",
                           front_table_file  = "front.csv",
                           best_scene_file   = "best.prm";
  ///@}

  /** Name of @p design: its folder below that of all designs. */
  std::string name_of(const Design &design);

  /** The part of the path of variable @p v that columns show: the last one, if
   * it is that of no other variable. */
  std::string short_name(const OptimizationDefinition &optimization,
                         std::size_t                   v);

  /** Files that write_optimization() may leave. */
  std::vector<std::string> optimization_files();

  /** One line on @p design: its folder, values and goals. */
  std::string
  line_of(const Scene &scene, const Goals &goals, const Design &design);

  /** Notes on objectives and results with an upper limit that begin below zero:
   * minimized forces, e.g., then grow in size. */
  std::vector<std::string> notes_on_signs(const Goals &goals);

  /**
   * Gain of the first objective from the first to the best design: decrease, or
   * increase if it is maximized.
   */
  struct Gain
  {
    double value; ///< of the finer discretization if it is known
    /** Difference between both discretizations; none if one is unknown. */
    std::optional<double> error;
  };

  Gain gain_of(const OptimizationResult &result, const Goals &goals);

  /** Findings on the best design and on how it was found. */
  std::vector<Finding> findings_of(const Scene              &scene,
                                   const OptimizationResult &result,
                                   const Goals              &goals);

  /** Tables and the best scene in the folder of @p scene. */
  void write_designs(const Scene              &scene,
                     const OptimizationResult &result,
                     const Goals              &goals);

  /** As write_designs(), with summary.json. */
  void write_optimization(const Scene                &scene,
                          const OptimizationResult   &result,
                          const Goals                &goals,
                          const std::vector<Finding> &findings);

  /** Closing lines for the screen. */
  std::string closing_text(const Scene              &scene,
                           const OptimizationResult &result,
                           const Goals              &goals);
} // namespace auxfem

#endif
