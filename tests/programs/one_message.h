#ifndef auxfem_tests_programs_one_message_h
#define auxfem_tests_programs_one_message_h

#include <support/run_program.h>

#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /** How often @p part is in @p text. */
    inline unsigned int count(const std::string &text, const std::string &part)
    {
      unsigned int n = 0;
      for (std::size_t position = text.find(part);
           position != std::string::npos;
           position = text.find(part, position + 1))
        ++n;
      return n;
    }

    /** The message is there, once, and the run ends with @p exit_code. */
    inline void expect_one_message(const ProgramRun  &run,
                                   const int          exit_code,
                                   const std::string &message)
    {
      EXPECT_EQ(run.exit_code, exit_code) << run.errors;
      EXPECT_EQ(count(run.errors, message), 1u) << run.errors;
      EXPECT_EQ(count(run.errors, "auxfem: "), 1u) << run.errors;
      expect_without(run.errors, {"Stacktrace", "internal error"});
    }
  } // namespace testing_support
} // namespace auxfem

#endif
