#ifndef auxfem_algebra_long_messages_h
#define auxfem_algebra_long_messages_h

#include <mpi.h>

#include <algorithm>
#include <cstddef>

namespace auxfem
{
  /** More do not fit into the int of one message. */
  inline constexpr std::size_t bytes_of_message = 1 << 30;

  /** Sends @p n values to the first rank, which calls receive(). */
  template <typename T>
  void send_to_first(const T          *values,
                     const std::size_t n,
                     const MPI_Comm    communicator)
  {
    const char *const bytes = reinterpret_cast<const char *>(values);
    for (std::size_t at = 0; at < n * sizeof(T); at += bytes_of_message)
      MPI_Send(bytes + at,
               std::min(bytes_of_message, n * sizeof(T) - at),
               MPI_BYTE,
               0,
               0,
               communicator);
  }

  /** What the rank @p from has sent by send_to_first(). */
  template <typename T>
  void receive(T                 *values,
               const std::size_t  n,
               const unsigned int from,
               const MPI_Comm     communicator)
  {
    char *const bytes = reinterpret_cast<char *>(values);
    for (std::size_t at = 0; at < n * sizeof(T); at += bytes_of_message)
      MPI_Recv(bytes + at,
               std::min(bytes_of_message, n * sizeof(T) - at),
               MPI_BYTE,
               from,
               0,
               communicator,
               MPI_STATUS_IGNORE);
  }
} // namespace auxfem

#endif
