#ifndef auxfem_output_output_times_h
#define auxfem_output_output_times_h

#include <optional>

namespace auxfem
{
  /** When to write something: at the multiples of an interval. */
  class OutputTimes
  {
  public:
    /**
     * @param interval (s); none: never.
     * @param nearness of times that are the same (s), much less
     */
    OutputTimes(std::optional<double> interval, double nearness);

    /** The first of them after @p time (s). */
    std::optional<double> after(double time) const;

    /** Whether @p time (s) is one of them. */
    bool has(double time) const;

  private:
    std::optional<double> interval;
    double                nearness;
  };
} // namespace auxfem

#endif
