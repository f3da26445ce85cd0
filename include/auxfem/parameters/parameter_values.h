#ifndef auxfem_parameters_parameter_values_h
#define auxfem_parameters_parameter_values_h

#include <auxfem/parameters/parameter.h>
#include <auxfem/parameters/parameter_file.h>

#include <deal.II/base/tensor.h>

#include <map>
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

  /**
   * The values of one subsection, each allowed by its Parameter: what the user
   * gave, else the default.
   */
  class ParameterValues
  {
  public:
    /** All parameters at their defaults. */
    explicit ParameterValues(const Parameters   &parameters,
                             const SceneContext &context  = {},
                             const FileLocation &location = {});

    /**
     * Gives the parameter @p name the value @p text, which must be allowed.
     */
    void set(const std::string &name, const std::string &text);

    /** The text of @p parameter, without blanks around it. */
    const std::string &text(const Parameter &parameter) const
    {
      return texts.at(parameter.name);
    }

    /** Value of @p parameter in its own type, quantities in SI. */
    template <class Typed>
    auto operator[](const Typed &parameter) const
    {
      return parameter.value(text(parameter));
    }

    /** As operator[], with @p automatic in place of a word. */
    template <class Typed>
    auto
    value_or(const Typed                                    &parameter,
             const decltype(parameter.value(std::string())) &automatic) const
    {
      return is_word(parameter) ? automatic : (*this)[parameter];
    }

    /** Whether the value is one of the parameter's words. */
    bool is_word(const Parameter &parameter) const
    {
      return parameter.is_word(text(parameter));
    }

    bool is_default(const Parameter &parameter) const
    {
      return text(parameter) == parameter.default_value;
    }

    /**
     * Throws InputError: the value of @p parameter is wrong in this scene,
     * because of @p reason, which tells what to do.
     */
    [[noreturn]] void refuse(const Parameter   &parameter,
                             const std::string &reason) const;

    /** The same for the subsection as a whole. */
    [[noreturn]] void refuse(const std::string &reason) const;

    /** The user's name of the subsection or entry, the last part of its path.
     */
    std::string name() const
    {
      return context.path.substr(context.path.find('/') + 1);
    }

    /** The parameters in the order of their declaration. */
    const Parameters parameters;
    /** The scene, and the path of this subsection in it. */
    const SceneContext context;
    /** Where in the file the subsection begins. */
    const FileLocation location;

    /** Files that the scene is read from because of these values. */
    std::vector<std::string> files;

  private:
    std::map<std::string, std::string> texts;
  };

  /** @name Values that depend on the dimension of space */
  ///@{
  /**
   * Throws InputError if the scene lies in the plane and @p parameter, which
   * has a meaning in space only, is not at its default; @p remedy is what to
   * do about it.
   */
  void require_space(const ParameterValues &values,
                     const Parameter       &parameter,
                     const std::string     &remedy = "Remove it");

  /**
   * The vector of two or three numbers (SI). Throws InputError if it leaves the
   * plane of a scene in the plane.
   */
  dealii::Tensor<1, 3> vector_of(const ParameterValues &values,
                                 const QuantityList    &parameter);

  /**
   * The unit vector along the two or three numbers. Throws InputError if they
   * are zero.
   */
  dealii::Tensor<1, 3> unit_vector_of(const ParameterValues &values,
                                      const QuantityList    &parameter);

  /**
   * Moments of inertia about x, y, z at rest (kg m2): these three, or one, the
   * same about every axis. In the plane there is that about z alone. Throws
   * InputError for two numbers.
   */
  dealii::Tensor<1, 3> moments_of_inertia_of(const ParameterValues &values,
                                             const QuantityList    &parameter);
  ///@}
} // namespace auxfem

#endif
