#ifndef auxfem_start_up_h
#define auxfem_start_up_h

namespace auxfem
{
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
   * network adapters: 0.3 s, more than a small scene takes. It is told by
   * environment variables (`OMPI_MCA_...`), which other implementations of MPI
   * ignore; those that the user has set stay as they are.
   */
  void prepare_mpi_for_one_process();
} // namespace auxfem

#endif
