#ifndef auxfem_time_stopwatch_h
#define auxfem_time_stopwatch_h

#include <chrono>

namespace auxfem
{
  /** Adds the wall time of its own life (s) to a sum. */
  class Stopwatch
  {
  public:
    explicit Stopwatch(double &sum)
      : sum(sum)
      , start(std::chrono::steady_clock::now())
    {}

    ~Stopwatch()
    {
      sum +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
          .count();
    }

    Stopwatch(const Stopwatch &)            = delete;
    Stopwatch &operator=(const Stopwatch &) = delete;

  private:
    double                                     &sum;
    const std::chrono::steady_clock::time_point start;
  };
} // namespace auxfem

#endif
