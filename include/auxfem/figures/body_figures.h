#ifndef auxfem_figures_body_figures_h
#define auxfem_figures_body_figures_h

#include <auxfem/figures/recorded_table.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Choices in the evaluation of histories, see FiguresDefinition. */
  struct FigureOptions
  {
    /** Channel frequency class (Hz); empty: no filter. */
    std::optional<double> channel_class;
    /** Part of the peak at which a pulse begins and ends. */
    double pulse_threshold = 0.05;
    /** Part of the whole change within which a motion has settled. */
    double settling_band = 0.05;
    /** Whether forces and motions depend on time, not only on its order. */
    bool in_time = true;
  };

  /** The value farthest from zero in a history, and its time (s). */
  struct Peak
  {
    double value = 0;
    double time  = 0;
  };

  Peak peak_of(const RecordedHistory &history);

  /** Integrals of a force over time, by the trapezoidal rule. */
  struct PulseFigures
  {
    double impulse = 0; ///< N s, over the whole history
    /** Time (s) from the first to the last crossing of the threshold; the
     * force between changes linearly. */
    double duration = 0;
    double mean     = 0; ///< N, over the pulse
  };

  /** Figures of a force history. */
  struct ForceFigures
  {
    Peak                        peak;          ///< N
    std::optional<Peak>         filtered_peak; ///< N; empty: not filtered
    std::optional<PulseFigures> pulse;         ///< empty without time
  };

  ForceFigures force_figures(const RecordedHistory &force,
                             const FigureOptions   &options);

  /** Figures of the velocity along an axis of a body that was thrown. */
  struct ReboundFigures
  {
    double initial_velocity = 0; ///< m/s
    /** Largest velocity against the initial one (m/s), with its sign; empty if
     * the motion does not reverse. */
    std::optional<double> rebound_velocity;

    /** Coefficient of restitution: |rebound / initial velocity|. */
    std::optional<double> restitution() const;
  };

  ReboundFigures rebound_figures(const RecordedHistory &velocity);

  /**
   * Last time (s) at which @p motion is farther from its last value than @p
   * band times the change from its first to its last value, by linear
   * interpolation, measured from its first time. Empty without a change, and
   * if this time is in the last tenth of the history: then the last value is
   * not known to be the final one.
   */
  std::optional<double> settling_time(const RecordedHistory &motion,
                                      double                 band);

  /** Figures of a body along one axis; those that it does not have are empty.
   */
  struct BodyFigures
  {
    std::string                 body;
    std::string                 axis; ///< x, y or z
    std::optional<ForceFigures> force;
    /** Acceleration (m/s2). */
    std::optional<Peak> acceleration, filtered_acceleration;
    /** Displacement from the start (m) farthest along the initial velocity, or
     * without one farthest in any direction. */
    std::optional<Peak>           stroke;
    std::optional<ReboundFigures> rebound;
    std::optional<double>         settling_time; ///< s
  };

  /**
   * Figures of @p body along all axes on which it has columns in @p history:
   * `BODY.fx` or else `BODY.rx` for forces, `BODY.ux`, `BODY.vx`, `BODY.ax` for
   * motions. An axis is left out if nothing but round-off happens on it.
   */
  std::vector<BodyFigures> figures_of_body(const std::string   &body,
                                           const RecordedTable &history,
                                           const FigureOptions &options);
} // namespace auxfem

#endif
