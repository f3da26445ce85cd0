#ifndef auxfem_tests_verification_schemes_h
#define auxfem_tests_verification_schemes_h

#include <support/scene_text.h>

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
        return entries + " | Time step = " + text(dt) +
          " | End time = " + text(end);
      }
    };

    /** The average-acceleration rule. */
    inline Scheme newmark()
    {
      return {"Newmark 1/4, 1/2", "Scheme = newmark"};
    }

    inline Scheme hht(const std::string &alpha)
    {
      return {"HHT " + alpha, "Scheme = hht | HHT alpha = " + alpha};
    }

    inline Scheme generalized_alpha(const std::string &radius)
    {
      return {"generalized-alpha " + radius,
              "Scheme = generalized-alpha | Spectral radius = " + radius};
    }
  } // namespace testing_support
} // namespace auxfem

#endif
