#ifndef auxfem_tests_support_no_more_memory_h
#define auxfem_tests_support_no_more_memory_h

#include <cstdlib>
#include <vector>

#include <sys/resource.h>

namespace auxfem::testing_support
{
  /** During its lifetime malloc() and new provide small pieces only. */
  class NoMoreMemory
  {
  public:
    NoMoreMemory()
    {
      blocks.reserve(1 << 20);
      getrlimit(RLIMIT_AS, &former);
      // Memory in use stays valid; new allocations fail.
      const rlimit limit{0, former.rlim_max};
      setrlimit(RLIMIT_AS, &limit);
      for (std::size_t size = 1 << 26; size >= 1 << 13; size /= 2)
        while (blocks.size() < blocks.capacity())
          {
            void *const block = std::malloc(size);
            if (block == nullptr)
              break;
            blocks.push_back(block);
          }
    }

    ~NoMoreMemory()
    {
      setrlimit(RLIMIT_AS, &former);
      for (void *const block : blocks)
        std::free(block);
    }

    NoMoreMemory(const NoMoreMemory &)            = delete;
    NoMoreMemory &operator=(const NoMoreMemory &) = delete;

  private:
    rlimit              former{};
    std::vector<void *> blocks;
  };
} // namespace auxfem::testing_support

#endif
