#ifndef auxfem_tests_verification_schemes_h
#define auxfem_tests_verification_schemes_h

#include <verification/frame_text.h>

#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /** A time integrator: its name in tables and its entries in Time. */
    struct Scheme
    {
      std::string name, entries;

      /** Entries of the subsection Time for steps of @p dt to @p end (s). */
      std::string steps(const double dt, const double end) const
      {
        return entries + "  set Time step = " + text(dt) +
          "\n  set End time = " + text(end) + "\n";
      }
    };

    /** The average-acceleration rule. */
    inline Scheme newmark()
    {
      return {"Newmark 1/4, 1/2", "  set Scheme = newmark\n"};
    }

    inline Scheme hht(const std::string &alpha)
    {
      return {"HHT " + alpha,
              "  set Scheme = hht\n  set HHT alpha = " + alpha + "\n"};
    }

    inline Scheme generalized_alpha(const std::string &radius)
    {
      return {"generalized-alpha " + radius,
              "  set Scheme = generalized-alpha\n  set Spectral radius = " +
                radius + "\n"};
    }
  } // namespace testing_support
} // namespace auxfem

#endif
