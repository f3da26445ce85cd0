#ifndef auxfem_analysis_occurrences_h
#define auxfem_analysis_occurrences_h

#include <auxfem/algebra/unknown_layout.h>
#include <auxfem/time/records.h>

#include <optional>
#include <string>

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
    /** In the order of time. */
    void add(const Occurrence &occurrence);

    /** The largest of this rank. */
    const std::optional<Occurrence> &largest_here() const
    {
      return largest;
    }

    /** @name Of all ranks, the same on each; collective. */
    ///@{
    std::optional<Occurrence> first_of_all(MPI_Comm communicator) const;
    std::optional<Occurrence> largest_of_all(MPI_Comm communicator) const;
    void                      save(Records           &records,
                                   const std::string &name,
                                   MPI_Comm           communicator) const;
    ///@}
    void resume(const Records &records, const std::string &name);

  private:
    std::optional<Occurrence> first, largest;
  };
} // namespace auxfem

#endif
