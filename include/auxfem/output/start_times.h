#ifndef auxfem_output_start_times_h
#define auxfem_output_start_times_h

namespace auxfem
{
  /** What the operating system and MPI took before the run could begin (s). */
  struct StartTimes
  {
    double program = 0; ///< wall time of loading the program and its libraries
    double mpi     = 0; ///< wall time of MPI_Init
    double cpu     = 0; ///< processor time of both
  };
} // namespace auxfem

#endif
