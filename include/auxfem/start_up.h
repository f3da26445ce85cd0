#ifndef auxfem_start_up_h
#define auxfem_start_up_h

#include <optional>
#include <string>

namespace auxfem
{
  /**
   * A message if this processor lacks vector instructions that the compiler was
   * allowed to use (AUXFEM_VECTOR_INSTRUCTIONS). To be called before anything
   * is computed.
   */
  std::optional<std::string> missing_instructions();

  /**
   * Wall seconds since the operating system started this process, to 10 ms: at
   * the first line of main() the time that loading deal.II and its two hundred
   * libraries took. 0 where the system does not provide it (proc(5)).
   */
  double seconds_since_process_start();

  /**
   * Whether a launcher (mpirun, srun) has started this process as a rank of a
   * run, by the variables that launchers leave in the environment.
   */
  bool has_mpi_launcher();

  /**
   * Spares MPI_Init what a process on its own does not need. To be called
   * before it, and only without a launcher.
   *
   * Open MPI would start a daemon that could start further ranks, and look for
   * network adapters: 0.3 s, more than a small scene takes. Without its daemon
   * all such processes of a user would share one temporary folder, which one
   * may remove while another starts. Environment variables (`OMPI_MCA_...`)
   * prevent both; those that the user has set stay as they are.
   */
  void prepare_mpi_for_one_process();

  /**
   * Makes this thread, and threads it starts, treat numbers below 2.2e-308 in
   * size as zero. To be called on every rank.
   *
   * Motions ahead of a wave are that small, and the processor multiplies such
   * numbers many times more slowly. They are far below the round-off of the
   * sums they enter. C++ has no means for it, so this works on x86 processors
   * only.
   */
  void flush_denormals_to_zero();
} // namespace auxfem

#endif
