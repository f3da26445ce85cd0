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
    /** Of all local unknowns; rotations as vectors in the global frame. */
    Vector real, imaginary;
  };

  /** Steady vibration at one frequency. */
  struct HarmonicVibration
  {
    HarmonicValues displacement;
    /** Of supports on the lattice, in owned prescribed rows (N, N m). */
    HarmonicValues reaction;
    /** What is left of the equations in free rows, over the loads. */
    double residual = 0;
  };

  /**
   * Small steady vibrations of a lattice about an equilibrium under harmonic
   * loads and motions of supports, with all damping: what the load factor of
   * the state multiplies are the amplitudes. All functions are collective.
   */
  class HarmonicResponse
  {
  public:
    /**
     * @param solver must outlive the object.
     * Throws InputError where no load acts.
     */
    HarmonicResponse(TangentSolver &solver, const State &equilibrium);

    /** At the angular frequency @p omega (rad/s). Throws ComputationError if
     * the equations are not solved. */
    HarmonicVibration at(double omega);

  private:
    TangentSolver       &solver;
    const UnknownLayout &layout;
    const ModeSpace      space;
    DynamicStiffness     stiffness;
    /** Owned rows; amplitudes in prescribed ones. */
    Vector loads;
  };

  /**
   * `Analysis = frequency response`: amplitudes and phases of probes and
   * reactions over the band, into Output/Directory (frequency_response.csv,
   * summary.json) and, the largest, onto the screen. Throws InputError,
   * ComputationError; rows until then are kept. Collective.
   */
  RunResult run_frequency_response(const Scene         &scene,
                                   MPI_Comm             communicator,
                                   const FolderOptions &options);

  /** The dry run: builds everything, prints counts and effects. Collective. */
  void check_frequency_response(const Scene &scene, MPI_Comm communicator);

  /** What such runs write beside log.txt and summary.json. */
  FolderContents frequency_response_contents();
} // namespace auxfem

#endif
