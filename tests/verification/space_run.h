#ifndef auxfem_tests_verification_space_run_h
#define auxfem_tests_verification_space_run_h

#include <support/scene_run.h>
#include <verification/space_text.h>

#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /** @p vector times the expression @p factor. */
    inline SpaceTexts times(const SpaceVector &vector,
                            const std::string &factor)
    {
      SpaceTexts texts;
      for (unsigned int c = 0; c < 3; ++c)
        texts[c] = text(vector[c]) + " * (" + factor + ")";
      return texts;
    }

    /** A scene in space computed in this process; see SceneRun. */
    class SpaceRun : public SceneRun
    {
    public:
      using SceneRun::SceneRun;

      SpaceVector displacement(const unsigned int joint) const
      {
        return SpaceVector(
          {motion(joint, 0), motion(joint, 1), motion(joint, 2)});
      }

      /** Present position of a joint (m). */
      SpaceVector position(const unsigned int joint) const
      {
        return lattice.joints[joint] + displacement(joint);
      }

      /** Rotation of a joint since rest. */
      const Quaternion &rotation(const unsigned int joint) const
      {
        const DofNumbering &numbering = model.numbering;
        return state.rotations.at(numbering.rotations().with(
          numbering.joint_unknown(joint, first_rotation)));
      }

      /** Force of a support on the lattice (N). */
      SpaceVector force(const std::string &support) const
      {
        return reactions(support, 0);
      }

      SpaceVector moment(const std::string &support) const
      {
        return reactions(support, first_rotation);
      }

    private:
      SpaceVector reactions(const std::string &support,
                            const unsigned int first) const
      {
        return SpaceVector({reaction(support, first),
                            reaction(support, first + 1),
                            reaction(support, first + 2)});
      }
    };
  } // namespace testing_support
} // namespace auxfem

#endif
