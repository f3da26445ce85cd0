#ifndef auxfem_parameters_scene_context_h
#define auxfem_parameters_scene_context_h

#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** `Model`: what a scene is a scene of. */
  enum class Model
  {
    lattice,     ///< beams, joints and connectors as finite elements
    reduced_cell ///< one cell of rigid parts with two unknowns
  };

  /** What a reader may need of the scene besides its own subsection. */
  struct SceneContext
  {
    /** Folder of the parameter file; relative file names start from it. */
    std::string directory = ".";

    /** Constants for expressions, `name -> value`, as the scene defines them.
     */
    std::vector<std::pair<std::string, double>> constants;

    /** Path of the subsection in work, e.g. `Connectors/damper`, for messages.
     */
    std::string path;

    /** Dimension of space: 2 or 3. */
    unsigned int dimension = 2;

    Model model = Model::lattice;
  };

  /**
   * Absolute name of @p file, which may be relative to the folder of the
   * parameter file. Recorded in `parameters.prm`, which lies in another folder.
   */
  std::string absolute_file(const std::string  &file,
                            const SceneContext &context);
} // namespace auxfem

#endif
