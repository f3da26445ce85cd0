#ifndef auxfem_tests_verification_deep_arch_h
#define auxfem_tests_verification_deep_arch_h

#include <support/scene_text.h>

#include <cmath>

#include <support/pi.h>

namespace auxfem
{
  namespace testing_support
  {
    /** DaDeppo & Schmidt 1975: a circular arch of 215 degrees with a radius of
     * 100, EI = 1e6, clamped left, hinged right; joint 1 is its crown. */
    inline SceneText deep_arch()
    {
      constexpr double  radius = 100, half = 107.5 / 180 * pi;
      const std::string x    = text(radius * std::sin(half)),
                        y    = text(radius * std::cos(half)),
                        rise = text(radius * (1 - std::cos(half / 2)));
      return SceneText()
        .frame("-" + x + " " + y + "; 0 100; " + x + " " + y,
               "0 1 " + rise + "; 1 2 " + rise)
        .section({1e8, 1e8, 1e6})
        .support("clamp", "0", "clamp")
        .support("hinge", "2", "pin")
        .set("Lattice/Struts may cross", "true");
    }
  } // namespace testing_support
} // namespace auxfem

#endif
