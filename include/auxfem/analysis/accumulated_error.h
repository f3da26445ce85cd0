#ifndef auxfem_analysis_accumulated_error_h
#define auxfem_analysis_accumulated_error_h

#include <auxfem/time/checkpoint_archive.h>

#include <map>
#include <optional>
#include <string>

namespace auxfem
{
  /** Local error of one step of displacements (m) or rotations (rad). */
  struct LocalError
  {
    /** The oscillation that dominates the error. */
    struct Oscillation
    {
      double frequency; ///< angular, 1/s
      double amplitude; ///< m or rad
    };

    double size = 0;
    /** Part of it in motions that the scene's steps resolve; at most size. */
    double                     slow        = 0;
    std::optional<Oscillation> oscillation = {};
    /** Factor by which the scheme damps errors of earlier steps. */
    double amplification = 1;
  };

  /**
   * Error of all steps. Local errors add up, as they do in an undamped
   * oscillation. But an oscillation of the amplitude A cannot err by more than
   * 2 A, however long it lasts: a small fast vibration, of a stiff contact for
   * instance, need not be followed to its end. Errors are therefore summed by
   * octaves of frequency, each up to that bound.
   */
  class AccumulatedError
  {
  public:
    void add(const LocalError &step);

    /** The smaller of the plain sum and the bounded one (m or rad). */
    double total() const;

    /** The largest total so far. */
    double largest_total() const
    {
      return largest;
    }

    /** @param name of its record */
    void serialize(const std::string &name, CheckpointArchive &archive);

  private:
    struct Octave
    {
      double error = 0, largest_amplitude = 0;
    };

    double                sum = 0, slow = 0, unbounded = 0, largest = 0;
    std::map<int, Octave> octaves; ///< by the binary logarithm of frequency
  };
} // namespace auxfem

#endif
