#ifndef auxfem_tests_verification_space_scene_h
#define auxfem_tests_verification_space_scene_h

#include <auxfem/elements/beam_3d.h>

#include <support/scene_run.h>
#include <verification/space_text.h>

#include <array>
#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /** Expressions in t for x, y, z. */
    using SpaceTexts = std::array<std::string, 3>;

    /** @p vector times the expression @p factor. */
    inline SpaceTexts times(const SpaceVector &vector,
                            const std::string &factor)
    {
      SpaceTexts texts;
      for (unsigned int c = 0; c < 3; ++c)
        texts[c] = text(vector[c]) + " * (" + factor + ")";
      return texts;
    }

    /** The `.prm` text of a static scene in space; see StaticScene. */
    class SpaceScene : public StaticScene
    {
    public:
      SpaceScene()
      {
        set("Dimension", 3);
      }

      SpaceScene(const std::string &joints, const std::string &struts)
        : StaticScene(joints, struts)
      {
        set("Dimension", 3);
      }

      /** A section of all struts by its stiffnesses; E = G = 1 Pa makes them
       * areas. */
      SpaceScene &section(const Beam3D::Stiffness &stiffness)
      {
        const std::string path = "Sections/all/";
        set(path + "Shape", "given");
        set(path + "Young's modulus", "1");
        set(path + "Poisson's ratio", "-0.5");
        set(path + "Area", stiffness.axial);
        set(path + "Shear area", stiffness.shear_2);
        set(path + "Shear area 3", stiffness.shear_3);
        set(path + "Torsion constant", stiffness.torsion);
        set(path + "Second moment of area 2", stiffness.bending_2);
        set(path + "Second moment of area", stiffness.bending_3);
        return *this;
      }

      /** Force and moment on each joint. */
      SpaceScene &load(const std::string &name,
                       const std::string &joints,
                       const SpaceTexts  &force,
                       const SpaceTexts  &moment)
      {
        const std::string path = "Loads/" + name + "/";
        set(path + "Joints", joints);
        set_components(path + "Force ", force);
        set_components(path + "Moment ", moment);
        return *this;
      }

      /** Displacement and rotation: an expression in t, or `free`. */
      SpaceScene &prescribe(const std::string &name,
                            const std::string &joints,
                            const SpaceTexts  &displacement,
                            const SpaceTexts  &rotation)
      {
        const std::string path = "Supports/" + name + "/";
        support(name, joints, "prescribed");
        set_components(path + "Displacement ", displacement);
        set_components(path + "Rotation ", rotation);
        return *this;
      }

    private:
      void set_components(const std::string &begin, const SpaceTexts &values)
      {
        for (unsigned int c = 0; c < 3; ++c)
          set(begin + "xyz"[c], values[c]);
      }
    };

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

      /** Where a joint is now. */
      SpaceVector position(const unsigned int joint) const
      {
        return lattice.joints[joint] + displacement(joint);
      }

      /** Of a joint since rest. */
      const Quaternion &rotation(const unsigned int joint) const
      {
        const DofNumbering &numbering = model.numbering;
        return state.rotations.at(numbering.rotations().with(
          numbering.joint_unknown(joint, first_rotation)));
      }

      /** Of a support on the lattice. */
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
