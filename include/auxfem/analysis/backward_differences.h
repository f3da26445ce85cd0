#ifndef auxfem_analysis_backward_differences_h
#define auxfem_analysis_backward_differences_h

#include <auxfem/model/unknown_records.h>
#include <auxfem/time/checkpoint_archive.h>

#include <deque>
#include <optional>

namespace auxfem
{
  /**
   * Differences of a vector over the last steps, of any lengths: the difference
   * of order k is dt^k times the k-th derivative of the polynomial of degree k
   * through the last k + 1 values. The third one for equal steps is
   *
   * @code
   * x_{n+1} - 3 x_n + 3 x_{n-1} - x_{n-2}
   * @endcode
   *
   * It is at most 2^k amplitudes of an oscillation, however fast.
   */
  class BackwardDifferences
  {
  public:
    static constexpr unsigned int largest_order = 4;

    /**
     * The difference at @p now, at @p time (s), for a step of length @p dt (s).
     * Nothing if fewer than @p order values have been added. Entries that have
     * come since the oldest of the values are left out.
     * @param order at most largest_order
     */
    std::optional<Vector> difference(unsigned int  order,
                                     double        time,
                                     const Vector &now,
                                     double        dt) const;

    /** Adds the next value, at @p time (s). */
    void add(double time, const Vector &value);

    bool is_empty() const
    {
      return samples.empty();
    }

    /** Time of the newest value (s); there must be one. */
    double latest_time() const
    {
      return samples.back().time;
    }

    void clear()
    {
      samples.clear();
    }

    /** Saves or restores values at unknowns.
     * @param name prefix of the records' names */
    void serialize(const std::string    &name,
                   const UnknownRecords &unknowns,
                   CheckpointArchive    &archive);

  private:
    struct Sample
    {
      double time; ///< s
      Vector value;
    };

    std::deque<Sample> samples; ///< the oldest first
  };
} // namespace auxfem

#endif
