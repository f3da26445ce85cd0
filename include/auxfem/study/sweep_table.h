#ifndef auxfem_study_sweep_table_h
#define auxfem_study_sweep_table_h

#include <auxfem/output/verdict.h>
#include <auxfem/study/sweep.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace auxfem
{
  /** Table of the cases of a sweep with their results, on one rank. */
  class SweepTable
  {
  public:
    /** @param sweep scene of the sweep; must outlive the object */
    explicit SweepTable(const Scene &sweep) : scene(sweep)
    {}

    /** Adds the results of a case. */
    void add(const CaseResults &results);

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

    std::vector<std::size_t> chosen_results() const;

    const Scene             &scene;
    std::vector<std::string> paths; ///< of results, in order of appearance
    std::set<std::string>    known;
    std::vector<Row>         rows;
  };
} // namespace auxfem

#endif
