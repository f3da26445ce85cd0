#ifndef auxfem_study_sweep_table_h
#define auxfem_study_sweep_table_h

#include <auxfem/output/verdict.h>
#include <auxfem/parameters/text.h>
#include <auxfem/study/sweep.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** Name and value of a result. */
  using NamedResults = std::vector<std::pair<std::string, double>>;

  /**
   * Numbers of the analysis in the @p summary of a run, in its order: names are
   * paths such as `effective_properties.constants.nu12`, with numbers from 1
   * for elements of lists.
   */
  NamedResults results_in(const Json &summary);

  /** Names without their paths where they stay unique. */
  std::vector<std::string> short_names(const std::vector<std::string> &paths);

  /** The summary of the run in @p folder; null if it is missing or damaged. */
  Json summary_in(const std::string &folder);

  /** Table of the cases of a sweep with their results, on one rank. */
  class SweepTable
  {
  public:
    /** @param sweep scene of the sweep; must outlive the object */
    explicit SweepTable(const Scene &sweep) : scene(sweep)
    {}

    /** Adds the results of a case from its folder.
     * @param failure reason why there are none; empty: it is computed */
    void add(const SweepCase &one, const std::string &failure);

    /** Writes sweep.csv with its reference. Throws InputError for a requested
     * result that no case has.
     * @param cases those that were added */
    void write(const std::vector<SweepCase> &cases) const;

    /** Findings on cases that failed or are not sound. */
    std::vector<Finding> findings() const;

    /** Files that write() leaves. */
    static std::vector<std::string> files();

  private:
    /** Results and state of a case after its run. */
    struct Row
    {
      std::map<std::string, double> results; ///< by path
      std::string                   verdict, exit_state;
    };

    std::vector<std::size_t>
    chosen_results(const std::vector<std::string> &names) const;

    const Scene             &scene;
    std::vector<std::string> paths; ///< of results, in order of appearance
    std::set<std::string>    known;
    std::vector<Row>         rows;
  };
} // namespace auxfem

#endif
