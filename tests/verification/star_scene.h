#ifndef auxfem_tests_verification_star_scene_h
#define auxfem_tests_verification_star_scene_h

#include <support/run_program.h>
#include <support/scene_text.h>

#include <string>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** Text of `prm/star-10x10.prm`. */
    inline std::string star_scene()
    {
      return prm_text("star-10x10.prm");
    }

    /** Overrides that make it @p n x @p n cells under @p load (N) on each top joint. */
    inline std::vector<std::string> star_size(const unsigned int n,
                                              const double       load)
    {
      return {"Lattice/Cells x=" + std::to_string(n),
              "Lattice/Cells y=" + std::to_string(n),
              "Constants=F0 = " + text(load) + ", t0 = 10e-3"};
    }

    inline std::vector<std::string> operator+(std::vector<std::string>        a,
                                              const std::vector<std::string> &b)
    {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
