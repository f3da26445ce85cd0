#ifndef auxfem_analysis_infinite_lattice_dispersion_h
#define auxfem_analysis_infinite_lattice_dispersion_h

#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/infinite_lattice/bloch_waves.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** Frequencies of a band (rad/s). */
  struct FrequencyBand
  {
    double lowest, highest;
  };

  /** Bands over all wave vectors, as many as each has.
   * @param frequencies of each wave vector in ascending order (rad/s) */
  std::vector<FrequencyBand>
  frequency_bands(const std::vector<std::vector<double>> &frequencies);

  /** Frequencies that no wave has, between two bands. */
  struct BandGap
  {
    unsigned int below;           ///< number of the band below, from 1
    double       lowest, highest; ///< rad/s
  };

  /** Gaps between @p bands, which ascend. Gaps narrower than round-off are
   * none. */
  std::vector<BandGap> band_gaps(const std::vector<FrequencyBand> &bands);

  /**
   * Waves of the infinite lattice of @p scene along the path of `Dispersion`,
   * on one rank. Writes dispersion.csv and summary.json; prints band gaps and
   * the velocities of long waves. Throws InputError for errors of the scene.
   * Collective.
   */
  RunResult run_dispersion(const Scene         &scene,
                           MPI_Comm             communicator,
                           const FolderOptions &options);
} // namespace auxfem

#endif
