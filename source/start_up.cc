#include <auxfem/start_up.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <stdlib.h>
#include <unistd.h>

#if defined(__SSE3__) || defined(__x86_64__)
#  include <pmmintrin.h>
#  include <xmmintrin.h>
#endif

namespace auxfem
{
  double seconds_since_process_start()
  {
    std::ifstream stream("/proc/self/stat");
    std::string   text;
    std::getline(stream, text);
    // The second entry, the program's name in parentheses, may hold anything.
    const std::size_t  name_end = text.rfind(')');
    std::istringstream entries(
      name_end == std::string::npos ? "" : text.substr(name_end + 1));
    constexpr unsigned int n_between = 22 - 3;
    std::string            skipped;
    for (unsigned int i = 0; i < n_between; ++i)
      entries >> skipped;
    double ticks = 0;
    if (!(entries >> ticks))
      return 0;
    timespec since_boot{};
    clock_gettime(CLOCK_BOOTTIME, &since_boot);
    return std::max(0.,
                    since_boot.tv_sec + 1e-9 * since_boot.tv_nsec -
                      ticks / sysconf(_SC_CLK_TCK));
  }

  std::optional<std::string> missing_instructions()
  {
#if defined(__AVX2__) && defined(__GNUC__)
    if (!__builtin_cpu_supports("avx2"))
      return "This auxfem was compiled for processors with the vector "
             "instructions AVX2, which this one has not. Compile it here, or "
             "with -DAUXFEM_VECTOR_INSTRUCTIONS=OFF for any.";
#endif
    return std::nullopt;
  }

  bool has_mpi_launcher()
  {
    const char *const variables[] = {"OMPI_COMM_WORLD_SIZE",
                                     "PMIX_RANK",
                                     "PMI_RANK",
                                     "SLURM_PROCID",
                                     "ALPS_APP_PE"};
    return std::any_of(std::begin(variables),
                       std::end(variables),
                       [](const char *name) {
                         return std::getenv(name) != nullptr;
                       });
  }

  void prepare_mpi_for_one_process()
  {
    constexpr int keep_the_users = 0;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", keep_the_users);
    setenv("OMPI_MCA_orte_create_session_dirs", "0", keep_the_users);
    setenv("OMPI_MCA_pml", "ob1", keep_the_users);
    setenv("OMPI_MCA_btl", "self,vader", keep_the_users);
  }

  void flush_denormals_to_zero()
  {
#if defined(__SSE3__) || defined(__x86_64__)
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
#endif
  }
} // namespace auxfem
