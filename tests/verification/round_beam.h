#ifndef auxfem_tests_verification_round_beam_h
#define auxfem_tests_verification_round_beam_h

#include <support/scene_text.h>
#include <verification/space_text.h>

#include <algorithm>
#include <limits>
#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /**
     * A scene in space with the section of Simo & Vu-Quoc's beams (1988): EA =
     * GA = @p axial (N), EI = GJ = @p bending (N m2), 1 kg/m, rotary inertia 20
     * kg m about the axis and 10 kg m across. Lacks joints and struts.
     */
    inline SceneText round_beam(const double axial, const double bending)
    {
      return static_scene()
        .dimension(3)
        .set("Lattice/Cell", "frame")
        .given("beam", {1, 1, bending / axial}, {axial, 1, -0.5})
        .set("Sections/beam/Torsion constant", bending / axial)
        .set("Sections/beam/Rotary inertia", "20 10 10");
    }

    /** Richardson extrapolation of second-order values with halved steps. */
    inline double extrapolated(const double coarse, const double fine)
    {
      return fine + (fine - coarse) / 3;
    }

    /** Least and largest of what should be constant. */
    struct Extremes
    {
      double least   = std::numeric_limits<double>::infinity();
      double largest = -least;

      void add(const double value)
      {
        least   = std::min(least, value);
        largest = std::max(largest, value);
      }
    };
  } // namespace testing_support
} // namespace auxfem

#endif
