#ifndef auxfem_tests_fuzz_mutator_h
#define auxfem_tests_fuzz_mutator_h

#include <random>
#include <string>

namespace auxfem
{
  /** Damages texts in the ways that people and disks do, repeatably. */
  class Mutator
  {
  public:
    explicit Mutator(unsigned int seed);

    /** @p text after one to three changes. */
    std::string mutated(std::string text);

    /** A number below @p n, which is not zero. */
    std::size_t below(std::size_t n);

  private:
    std::string change(const std::string &text);
    std::string change_word(const std::string &text);
    std::string change_line(const std::string &text);
    std::string change_byte(std::string text);

    std::mt19937 generator;
  };
} // namespace auxfem

#endif
