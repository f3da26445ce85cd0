#ifndef auxfem_analysis_run_statistics_h
#define auxfem_analysis_run_statistics_h

#include <auxfem/time/checkpoint_archive.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Something that happens to a part of a structure. */
  struct Occurrence
  {
    double       size;      ///< how far it goes
    double       time;      ///< s
    unsigned int number;    ///< of the strut or joint
    unsigned int group = 0; ///< of the connector, or what else it is with
  };

  /** What happens during a run, each rank seeing its own parts: the first and
   * the largest are kept. */
  class Occurrences
  {
  public:
    explicit Occurrences(const MPI_Comm communicator)
      : communicator(communicator)
    {}

    /** In the order of time. */
    void add(const Occurrence &occurrence);

    /** The largest of this rank. */
    const std::optional<Occurrence> &largest_here() const
    {
      return largest_one;
    }

    /** @name Of all ranks, the same on each; collective. */
    ///@{
    std::optional<Occurrence> first() const;
    std::optional<Occurrence> largest() const;
    ///@}

    /** Collective. */
    void serialize(const std::string &name, CheckpointArchive &archive);

  private:
    const MPI_Comm            communicator;
    std::optional<Occurrence> first_one, largest_one;
  };

  /**
   * What the watches of a run have found so far: all that they keep in a
   * checkpoint. Each watch has references to entries of its own, which begin
   * with its name. All but occurrences are the same on all ranks.
   */
  class RunStatistics
  {
  public:
    explicit RunStatistics(const MPI_Comm communicator)
      : communicator(communicator)
    {}

    RunStatistics(const RunStatistics &)            = delete;
    RunStatistics &operator=(const RunStatistics &) = delete;

    /** @name The entry of this name, which is made when first asked for. */
    ///@{
    double &number(const std::string &name, const double initial = 0)
    {
      return numbers.try_emplace(name, initial).first->second;
    }

    LargestInTime &largest(const std::string &name)
    {
      return maxima[name];
    }

    Occurrences &occurrences(const std::string &name)
    {
      return all_occurrences.try_emplace(name, communicator).first->second;
    }

    std::vector<double> &list(const std::string &name)
    {
      return lists[name];
    }

    std::string &text(const std::string &name)
    {
      return texts[name];
    }
    ///@}

    /** Collective. */
    void serialize(CheckpointArchive &archive);

  private:
    const MPI_Comm                             communicator;
    std::map<std::string, double>              numbers;
    std::map<std::string, LargestInTime>       maxima;
    std::map<std::string, Occurrences>         all_occurrences;
    std::map<std::string, std::vector<double>> lists;
    std::map<std::string, std::string>         texts;
  };
} // namespace auxfem

#endif
