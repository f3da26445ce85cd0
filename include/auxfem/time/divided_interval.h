#ifndef auxfem_time_divided_interval_h
#define auxfem_time_divided_interval_h

#include <auxfem/time/step_control.h>

#include <optional>
#include <vector>

namespace auxfem
{
  /** An interval of time that is passed in equal pieces, whose number may
   * change on the way. */
  class DividedInterval
  {
  public:
    /**
     * Length of the interval from @p time to @p target (s): @p step if it
     * differs from that by round-off only, as equal steps must have exactly
     * equal lengths to share a factorization.
     */
    static double length_between(double time, double target, double step);

    /** Begins one of length_between(), in @p pieces. */
    void start(double time, double target, double step, unsigned int pieces);

    /** Whether it is under way, and to @p target (s). */
    bool leads_to(const double other) const
    {
      return target == other;
    }

    /** Whether it is under way. */
    bool is_open() const
    {
      return target.has_value();
    }

    /** The next piece. */
    PlannedStep next() const;

    /** The next piece was passed. */
    void pass();

    /** Goes on in pieces of which @p pieces make the whole; returns whether it
     * can, because one of them begins here. */
    bool divide(unsigned int pieces);

    /** Pieces that make the whole. */
    unsigned int pieces() const
    {
      return number_of_pieces;
    }

    /** Of the whole (s). */
    double length() const
    {
      return whole;
    }

  private:
    std::optional<double> target; ///< if it is under way
    double                begin = 0, whole = 0;
    unsigned int          number_of_pieces = 1, number = 0;
  };
} // namespace auxfem

#endif
