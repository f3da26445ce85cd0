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
   * libraries took. 0 where the system does not tell (proc(5)).
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
   * all such processes of a user would also share one temporary folder, which
   * one removes while another starts. It is told by environment variables
   * (`OMPI_MCA_...`), which other implementations of MPI ignore; those that the
   * user has set stay as they are.
   */
  void prepare_mpi_for_one_process();

  /**
   * Has numbers below 2.2e-308 in size count as zero in what this thread, and
   * threads it starts, compute from now on. To be called on every rank.
   *
   * In struts that a wave has hardly reached motions are that small, and the
   * processor takes many times longer to multiply such numbers. Nothing is
   * lost: they are far below the round-off of all they are added to. Only x86
   * processors are told, as the language has no means for it.
   */
  void flush_denormals_to_zero();
} // namespace auxfem

#endif
