#ifndef auxfem_analysis_third_difference_h
#define auxfem_analysis_third_difference_h

#include <auxfem/model/unknown_records.h>

#include <deque>
#include <optional>

namespace auxfem
{
  /**
   * Third difference of a vector that is known at the ends of steps of any
   * lengths: dt^3 times the third derivative of the cubic polynomial through
   * the last four values. Of steps of equal length it is
   *
   * @code
   * x_{n+1} - 3 x_n + 3 x_{n-1} - x_{n-2}
   * @endcode
   *
   * and so no more than eight amplitudes of an oscillation, however fast.
   */
  class ThirdDifference
  {
  public:
    /** That of @p now at @p time (s) and the three values before, for a step of
     * the length @p dt (s); nothing if there are fewer. */
    std::optional<Vector> with(double time, const Vector &now, double dt) const;

    /** The next value, at @p time (s). */
    void add(double time, const Vector &value);

    /** Whether there is a value yet. */
    bool has_begun() const
    {
      return !before.empty();
    }

    /** Begins anew. */
    void forget()
    {
      before.clear();
    }

    /** @name Of values at unknowns.
     * @param name begins the names of the records */
    ///@{
    void save(const std::string    &name,
              const UnknownRecords &unknowns,
              Records              &records) const;
    void resume(const std::string    &name,
                const UnknownRecords &unknowns,
                const Records        &records);
    ///@}

  private:
    struct Sample
    {
      double time; ///< s
      Vector value;
    };

    std::deque<Sample> before; ///< the oldest first
  };
} // namespace auxfem

#endif
