#ifndef auxfem_parameters_registry_h
#define auxfem_parameters_registry_h

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>
#include <vector>

namespace auxfem
{
  struct SceneContext;

  /** `Model`: what a scene is a scene of. */
  enum class Model
  {
    lattice,     ///< beams, joints and connectors as finite elements
    reduced_cell ///< one cell of rigid parts with two unknowns
  };

  /**
   * One line of the explicit table of a kind (connector laws, cells, loads,
   * time schemes): everything the program needs to offer a choice to the
   * user. The parameter reference in doc/ is generated from these tables.
   */
  template <class Product>
  struct RegistryEntry
  {
    /** The word the user writes, e.g. `kelvin-voigt`. */
    std::string name;

    /** One sentence for the parameter reference. */
    std::string description;

    /** Declares the parameters of this choice in the current subsection. */
    void (*declare)(dealii::ParameterHandler &prm);

    /**
     * Makes the object from the values of the current subsection. Throws
     * InputError for values that are each allowed but contradict each other.
     */
    std::unique_ptr<Product> (*make)(dealii::ParameterHandler &prm,
                                     const SceneContext       &context);
  };

  template <class Product>
  using Registry = std::vector<RegistryEntry<Product>>;

  /** What a maker may need of the scene besides its own subsection. */
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
  };

  /**
   * Absolute name of @p file, which may be relative to the folder of the
   * parameter file. Recorded in `parameters.prm`, which lies in another folder.
   */
  std::string absolute_file(const std::string  &file,
                            const SceneContext &context);
} // namespace auxfem

#endif
