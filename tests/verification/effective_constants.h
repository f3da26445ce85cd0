#ifndef auxfem_tests_verification_effective_constants_h
#define auxfem_tests_verification_effective_constants_h

#include <auxfem/model/build_lattice.h>

#include <deal.II/base/symmetric_tensor.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <string>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** Elastic constants of a periodic planar lattice as a continuum. */
    struct EffectiveConstants
    {
      double E1, E2, nu12, nu21, G12;
    };

    /**
     * A part of a periodic lattice, cut through the middles of struts that are
     * centres of symmetry of the lattice (a turn by 180 degrees leaves it as it
     * is). Under uniform strain such a centre moves with the mean strain and
     * transmits no moment: it is a pin.
     */
    struct LatticePart
    {
      SceneText scene = static_scene(); ///< linear, without supports
      std::vector<unsigned int> cuts;   ///< joints at the centres
      double                    area;   ///< its share of the plane (m2)
    };

    using PlaneTensor = dealii::SymmetricTensor<2, 2>;

    /**
     * Mean stress of @p part under the mean @p strain: the sum of the dyads of
     * force and position over the cuts, by area.
     */
    inline PlaneTensor mean_stress(const LatticePart &part,
                                   const PlaneTensor &strain)
    {
      const Lattice lattice =
        build_lattice(read_scene_from_text(part.scene.str(), "part.prm", {}));
      const auto name = [](const unsigned int joint) {
        return "cut " + std::to_string(joint);
      };
      SceneText scene = part.scene;
      for (const unsigned int joint : part.cuts)
        {
          std::array<std::string, 3> motion = {{"0", "0", "free"}};
          for (unsigned int a = 0; a < 2; ++a)
            motion[a] = text(strain[a][0] * lattice.joints[joint][0] +
                             strain[a][1] * lattice.joints[joint][1]);
          scene.prescribe(name(joint), std::to_string(joint), motion);
        }
      SceneRun run(scene.str());
      run.run();

      PlaneTensor stress;
      for (const unsigned int joint : part.cuts)
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int b = a; b < 2; ++b)
            stress[a][b] +=
              (run.reaction(name(joint), a) * lattice.joints[joint][b] +
               run.reaction(name(joint), b) * lattice.joints[joint][a]) /
              2 / part.area;
      return stress;
    }

    inline EffectiveConstants effective_constants(const LatticePart &part)
    {
      const auto stress = [&part](const unsigned int a, const unsigned int b) {
        PlaneTensor strain;
        strain[a][b] = 1;
        return mean_stress(part, strain);
      };
      const PlaneTensor along_x = stress(0, 0), along_y = stress(1, 1);
      const double      C11 = along_x[0][0], C22 = along_y[1][1];
      const double      C12 = along_x[1][1];
      // Reciprocity; round-off of the linear system
      EXPECT_NEAR(along_y[0][0], C12, 1e-9 * C11);
      const double determinant = C11 * C22 - C12 * C12;
      return {determinant / C22,
              determinant / C11,
              C12 / C22,
              C12 / C11,
              stress(0, 1)[0][1] / 2};
    }
  } // namespace testing_support
} // namespace auxfem

#endif
