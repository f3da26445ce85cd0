#ifndef auxfem_tests_verification_space_text_h
#define auxfem_tests_verification_space_text_h

#include <auxfem/mathematics/rotation.h>
#include <auxfem/mesh/lattice.h>

#include <support/scene_run.h>
#include <support/scene_text.h>

#include <string>

namespace auxfem
{
  namespace testing_support
  {
    inline SpaceVector vector(const double x, const double y, const double z)
    {
      return SpaceVector({x, y, z});
    }

    /** Components of @p v as `.prm` texts have them. */
    inline std::string text(const SpaceVector &v)
    {
      return text(v[0]) + " " + text(v[1]) + " " + text(v[2]);
    }

    /**
     * Sets the three parameters `NAME x`, `NAME y`, `NAME z` to the components
     * of @p v, times @p function of t if there is one.
     */
    inline void set_vector(SceneText         &scene,
                           const std::string &name,
                           const SpaceVector &v,
                           const std::string &function = "")
    {
      const char *const axes[] = {" x", " y", " z"};
      for (unsigned int c = 0; c < 3; ++c)
        scene.set(name + axes[c],
                  function.empty() ? text(v[c])
                                   : text(v[c]) + " * (" + function + ")");
    }

    /**
     * Entries of @p vector for the displacement of a joint or, with @p first =
     * first_rotation, for its rotation.
     */
    inline SpaceVector at_joint(const SceneRun    &run,
                                const Vector      &vector,
                                const unsigned int joint,
                                const unsigned int first = 0)
    {
      SpaceVector values;
      for (unsigned int c = 0; c < 3; ++c)
        values[c] = vector[run.model.numbering.joint_unknown(joint, first + c)];
      return values;
    }

    /** Rotation of a joint since rest. */
    inline Quaternion rotation_of_joint(const SceneRun    &run,
                                        const unsigned int joint)
    {
      const DofNumbering &dofs = run.model.numbering;
      return run.state.rotations[dofs.rotations().with(
        dofs.joint_unknown(joint, first_rotation))];
    }
  } // namespace testing_support
} // namespace auxfem

#endif
