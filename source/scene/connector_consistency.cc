#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene.h>

#include <string>

namespace auxfem
{
  namespace
  {
    /** Refuses forces that depend on their history where the program assumes
     * others.
     * @param what parameter and its meaning, e.g. `Connectors/brake/Law:
     *   friction` */
    void check_history_dependence(const Scene       &scene,
                                  const std::string &what,
                                  Mistakes          &mistakes)
    {
      const auto refuse = [&](const std::string &why) {
        mistakes.add(scene.file + ": " + what + " is not possible with " + why);
      };
      const auto *scheme =
        dynamic_cast<const ImplicitScheme *>(scene.time.scheme.get());
      if (scheme != nullptr && scheme->stages() != nullptr)
        refuse("Time/Scheme = " + scheme->name() +
               ", whose stages would slip or break by themselves. Choose "
               "newmark, generalized-alpha or energy-momentum");
      if (scene.analysis == Analysis::static_path ||
          scene.analysis == Analysis::buckling)
        refuse("Analysis = " + name_of(scene.analysis) +
               ", which assumes forces that depend on the configuration alone. "
               "Prescribe a motion in load steps with Analysis = simulation "
               "and Scheme = static");
    }
  } // namespace

  void check_connectors(const Scene &scene, Mistakes &mistakes)
  {
    for (const ConnectorDefinition &connector : scene.connectors)
      {
        if (connector.law->slips())
          check_history_dependence(scene,
                                   connector.path + "/Law: friction",
                                   mistakes);
        if (connector.limits.force || connector.limits.extension)
          check_history_dependence(scene,
                                   connector.path +
                                     "/Failure force, Failure extension: a "
                                     "connector that breaks",
                                   mistakes);
      }
    for (const JointDefinition &joint : scene.joints)
      if (joint.law && joint.law->slips())
        check_history_dependence(scene,
                                 joint.path + "/Type: friction",
                                 mistakes);
  }
} // namespace auxfem
