#ifndef auxfem_scene_scene_subsections_h
#define auxfem_scene_scene_subsections_h

#include <auxfem/scene/scene.h>

#include <vector>

namespace auxfem
{
  /** A subsection of the parameter file and the place of its values. */
  struct SceneSubsection
  {
    SubsectionSchema schema;

    /**
     * Puts the values of one such subsection into the scene. Throws InputError
     * if they contradict each other.
     */
    void (*read)(ParameterValues &values, Scene &scene);
  };

  /** All subsections, in the order in which they are read and described. */
  const std::vector<SceneSubsection> &scene_subsections();

  /** Their schemas, for the reference. */
  std::vector<SubsectionSchema> scene_schemas();

  /**
   * Adds the subsections of the file that no schema allows, and those that
   * serve other models than @p model, to @p mistakes.
   */
  void check_subsection_names(const ParameterSubsection &root,
                              Model                      model,
                              Mistakes                  &mistakes);

  /** Adds contradictions between subsections of @p scene to @p mistakes. */
  void check_consistency(const Scene &scene, Mistakes &mistakes);
} // namespace auxfem

#endif
