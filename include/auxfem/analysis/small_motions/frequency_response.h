#ifndef auxfem_analysis_small_motions_frequency_response_h
#define auxfem_analysis_small_motions_frequency_response_h

#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/scene/scene.h>

#include <mpi.h>

namespace auxfem
{
  /** Values that vary as the real part of (real + i imaginary) e^(i omega t).
   */
  struct HarmonicValues
  {
    /**
     * Values of all local unknowns; rotations as vectors in the global frame.
     */
    Vector real, imaginary;
  };

  /** Steady vibration at one frequency. */
  struct HarmonicVibration
  {
    HarmonicValues displacement;
    /** Support reactions on the lattice, in owned prescribed rows (N, N m). */
    HarmonicValues reaction;
    /** Residual norm in free rows over the norm of the loads. */
    double residual = 0;
  };

  /**
   * Steady small vibrations about an equilibrium under harmonic loads and
   * support motions, with all damping. The amplitudes are the loads and motions
   * that the load factor of the state multiplies. All functions are collective.
   */
  class HarmonicResponse
  {
  public:
    /**
     * @param solver must outlive the object. Throws InputError if no load acts.
     */
    HarmonicResponse(TangentSolver &solver, const State &equilibrium);

    /**
     * Vibration at the angular frequency @p omega (rad/s). Throws
     * ComputationError if the linear solver fails.
     */
    HarmonicVibration at(double omega);

  private:
    TangentSolver       &solver;
    const UnknownLayout &layout;
    const ModeSpace      space;
    DynamicStiffness     stiffness;
    /** Load amplitudes in owned rows; motion amplitudes in prescribed ones. */
    Vector loads;
    Vector load_derivative; ///< of the residual, also in prescribed rows
  };

  /**
   * Runs `Analysis = frequency response`. Writes amplitudes and phases of
   * probes and reactions over the band to Output/Directory
   * (frequency_response.csv, summary.json), and prints the largest. Throws
   * InputError or ComputationError; rows written before remain. Collective.
   */
  RunResult run_frequency_response(const Scene         &scene,
                                   MPI_Comm             communicator,
                                   const FolderOptions &options);

  /** The dry run: builds everything, prints counts and effects. Collective. */
  void check_frequency_response(const Scene &scene, MPI_Comm communicator);

  /** Files that these runs write besides log.txt and summary.json. */
  FolderContents frequency_response_contents();
} // namespace auxfem

#endif
