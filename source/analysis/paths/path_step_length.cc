#include <auxfem/analysis/paths/path_step_length.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Of the first length. */
    constexpr double smallest_part = 1e-6;

    /**
     * Deviation from the tangent, over the resolution, with which a point is
     * accepted.
     * @tuned judgement: the next step is then half as long
     */
    constexpr double largest_deviation = 4;

    /**
     * Cosine of the turn between two points beyond which the second may lie
     * on another branch.
     * @tuned judgement: 37 degrees
     */
    constexpr double smallest_turn = 0.8;

    /**
     * Iterations of Newton's method with which steps keep their length.
     * @tuned judgement
     */
    constexpr double wanted_iterations = 8;

    /** By how much a length at which a step has failed grows with every point.
     */
    constexpr double forgetting = 1.1;
  } // namespace

  PathStepLength::PathStepLength(const double resolution, const double first)
    : resolution(resolution)
    , next(first)
    , smallest(smallest_part * first)
  {}

  void PathStepLength::reached(const double distance, const double load_factor)
  {
    largest_distance = std::max(largest_distance, distance);
    largest_load     = std::max(largest_load, std::abs(load_factor));
  }

  bool PathStepLength::judge(const PathStep &step,
                             const double    distance,
                             const double    turn)
  {
    const double of_way = step.deviation / std::max(largest_distance, distance),
                 of_load = step.deviation_of_load /
      std::max(largest_load, std::abs(step.point->load_factor()));
    const double deviation = std::max(of_way, of_load) / resolution;
    // The deviation goes with the square of the length.
    const double fitting = 0.9 / std::sqrt(std::max(deviation, 1e-6));
    const bool   accepted =
      deviation <= largest_deviation && turn >= smallest_turn;
    if (!accepted)
      next *= std::clamp(fitting, 0.1, 0.5);
    else
      {
        next *=
          std::clamp(std::min(fitting, wanted_iterations / step.iterations),
                     0.3,
                     2.);
        next = std::min(next, too_long);
        too_long *= forgetting;
      }
    return accepted;
  }

  void PathStepLength::begin_anew(const double first)
  {
    next     = first;
    smallest = smallest_part * first;
    too_long = std::numeric_limits<double>::infinity();
  }

  void PathStepLength::failed()
  {
    too_long = next / 1.5;
    next /= 3;
  }

  void PathStepLength::serialize(CheckpointArchive &archive)
  {
    archive.values("path: length of steps",
                   next,
                   smallest,
                   too_long,
                   largest_distance,
                   largest_load);
  }
} // namespace auxfem
