#ifndef auxfem_tests_verification_one_mass_scene_h
#define auxfem_tests_verification_one_mass_scene_h

#include <support/scene_text.h>

#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /**
     * Text of a scene with one degree of freedom: joint 0 moves along x only
     * and hangs on one connector to the ground. Its extension is minus the
     * displacement of the joint. The strut a frame must have is held at both
     * ends and takes no part.
     * @param link entries of the connector, e.g. its law; see SceneText::add()
     * @param time entries of the subsection Time
     * @param more what else the scene has
     */
    inline SceneText one_mass_scene(const std::string &link,
                                    const std::string &time,
                                    const SceneText   &more = {})
    {
      return SceneText()
        .frame("0 0; 0 -1; 1 -1", "1 2")
        .circle("idle", 1e-3, {1, 1})
        .support("idle", "1, 2", "clamp")
        .support("guide", "0", "roller x")
        .add("Connectors/link",
             "Between = ground: 0 | Geometry = direction | Direction = 1 0")
        .add("Connectors/link", link)
        .mesh(1)
        .set("Effects/Large rotation", "off")
        .set("Newton/Tolerance", 1e-13)
        .add("Time", time)
        .add(more);
    }

    /** Gives joint 0 a mass (kg) and a velocity (m/s) at t = 0. */
    inline SceneText mass_and_velocity(const double mass, const double velocity)
    {
      return SceneText()
        .mass("body", "0", mass)
        .add("Initial velocities/push",
             "Joints = 0 | Velocity x = " + text(velocity));
    }
  } // namespace testing_support
} // namespace auxfem

#endif
