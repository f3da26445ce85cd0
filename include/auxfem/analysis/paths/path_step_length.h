#ifndef auxfem_analysis_paths_path_step_length_h
#define auxfem_analysis_paths_path_step_length_h

#include <auxfem/analysis/paths/path_stepper.h>
#include <auxfem/time/checkpoint_archive.h>

#include <algorithm>
#include <limits>

namespace auxfem
{
  /**
   * How far the next point of a path lies: such that it is off the tangent by
   * no more than the resolution, and that Newton's method finds it soon.
   */
  class PathStepLength
  {
  public:
    /** @param resolution as PathDefinition::resolution
     * @param first length (m) */
    PathStepLength(double resolution, double first);

    double length() const ///< of the next step (m)
    {
      return next;
    }


    /** Makes the next step no longer than @p most (m). */
    void limit(const double most)
    {
      next = std::min(next, most);
    }

    /** Takes note of a point of the path: its distance from rest (m), its load
     * factor. */
    void reached(double distance, double load_factor);

    /**
     * Whether @p step, to a point at @p distance (m) from rest, is to be accepted;
     * sets the length of the next attempt either way.
     * @param turn product of the directions at both ends
     */
    bool judge(const PathStep &step, double distance, double turn);

    /** On another branch, where @p first is the next length (m). */
    void begin_anew(double first);

    /** No point was found; sets the length of the next attempt. */
    void failed();

    /** Whether the next attempt is too short to be made. */
    bool is_exhausted() const
    {
      return next < smallest;
    }

    void serialize(CheckpointArchive &archive);

  private:
    const double resolution;
    double       next, smallest;
    /** As far as is known from steps that have failed (m). */
    double too_long         = std::numeric_limits<double>::infinity();
    double largest_distance = 0, largest_load = 0;
  };
} // namespace auxfem

#endif
