#ifndef auxfem_analysis_infinite_lattice_wave_stability_h
#define auxfem_analysis_infinite_lattice_wave_stability_h

#include <auxfem/analysis/infinite_lattice/period_tangent.h>
#include <auxfem/scene/dispersion_definition.h>
#include <auxfem/state/checkpoint_archive.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** The state at which an infinite lattice loses stability against a motion.
   */
  struct StabilityLoss
  {
    enum class Kind
    {
      long_wave, ///< far longer than the period
      wave,
      strut ///< motion between the joints, alike in all periods
    };
    Kind kind;
    /** Direction of a long wave; wave vector as parts of the reciprocal vectors
     * of the period. */
    std::array<double, 3> wave;
    double                time;   ///< s
    std::vector<double>   values; ///< of the caller's quantities
  };

  /** Name for users: `long wave`, `wave`, `strut`. */
  const char *name_of(StabilityLoss::Kind kind);

  /** Stiffness of an infinite lattice against waves over that at the start. */
  struct WaveStiffness
  {
    double               long_waves;
    dealii::Tensor<1, 3> direction; ///< of the least stable long wave
    /** The least of the wave vectors; nan if struts of different periods
     * touch. */
    double                waves;
    std::array<double, 3> wave; ///< its parts of the reciprocal vectors
  };

  /**
   * Follows the stability of an infinite lattice from step to step: against
   * long waves, waves of a grid of wave vectors, and motions inside of struts.
   */
  class WaveStability
  {
  public:
    /** @param n wave vectors along each reciprocal vector */
    WaveStability(unsigned int n, unsigned int dimension);

    /**
     * Records the stability at @p time (s), later than before. Each wave is lost
     * once, at the zero of the cubic through the last four stiffnesses.
     * @param tangent at that time, on the first rank
     * @param values further quantities, to be interpolated. Collective.
     */
    WaveStiffness record(double                     time,
                         const PeriodTangent       &tangent,
                         const std::vector<double> &values,
                         MPI_Comm                   communicator);

    /** All losses so far, by time. */
    const std::vector<StabilityLoss> &losses() const
    {
      return loss_list;
    }

    void serialize(CheckpointArchive &archive);

  private:
    using WaveVector = DispersionDefinition::WaveVector;

    /** A recorded state. */
    struct Sample
    {
      double              time;
      std::vector<double> values;
      /** Over those at the start: long waves, then by wave vector. */
      std::vector<double> stiffnesses;
    };

    void find_losses(const dealii::Tensor<1, 3> &direction);

    const std::vector<WaveVector> waves;
    std::vector<double>           at_start; ///< stiffnesses
    std::vector<Sample>           samples;  ///< the last four
    std::vector<double>           is_lost;  ///< 0 or 1, as stiffnesses
    bool                          strut_is_lost = false;
    std::vector<StabilityLoss>    loss_list;
  };
} // namespace auxfem

#endif
