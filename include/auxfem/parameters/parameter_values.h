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
  /** Parameter `Model`: kind of discretization. */
  enum class Model
  {
    lattice,     ///< beams, joints and connectors as finite elements
    reduced_cell ///< one cell of rigid parts with two unknowns
  };

  /** Properties of the scene that the reader of a subsection may need. */
  struct SceneContext
  {
    /** Folder of the parameter file, base of relative file names. */
    std::string directory = ".";

    /** Constants of the scene for expressions, `name -> value`. */
    std::vector<std::pair<std::string, double>> constants;

    /**
     * Path of the current subsection, e.g. `Connectors/damper`, for messages.
     */
    std::string path;

    /** Spatial dimension: 2 or 3. */
    unsigned int dimension = 2;

    Model model = Model::lattice;
  };

  /**
   * Absolute name of @p file, which may be relative to the folder of the
   * parameter file. `parameters.prm` lies in another folder and records this
   * name.
   */
  std::string absolute_file(const std::string  &file,
                            const SceneContext &context);

  /** Valid values of one subsection: those of the user, else the defaults. */
  class ParameterValues
  {
  public:
    /** Sets all parameters to their defaults. */
    explicit ParameterValues(const Parameters   &parameters,
                             const SceneContext &context  = {},
                             const FileLocation &location = {});

    /** Sets the parameter @p name to the valid value @p text. */
    void set(const std::string &name, const std::string &text);

    /** Text of @p parameter as the user wrote it, without surrounding blanks;
     * it may refer to constants. */
    const std::string &text(const Parameter &parameter) const
    {
      return texts.at(parameter.name);
    }

    /** Value of @p parameter in its own type; quantities in SI. */
    template <class Typed>
    auto operator[](const Typed &parameter) const
    {
      return parameter.value(number_texts.at(parameter.name));
    }

    /** As operator[], but @p automatic if the value is a word. */
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
     * Throws InputError: the value of @p parameter does not fit this scene. @p
     * reason explains it and names the remedy.
     */
    [[noreturn]] void refuse(const Parameter   &parameter,
                             const std::string &reason) const;

    /** Throws InputError for the subsection as a whole. */
    [[noreturn]] void refuse(const std::string &reason) const;

    /** The user's name of the subsection or entry: last part of its path. */
    std::string name() const
    {
      return context.path.substr(context.path.find('/') + 1);
    }

    /** The parameters in the order of their declaration. */
    const Parameters parameters;
    /** The scene and the path of this subsection. */
    const SceneContext context;
    /** Position of the subsection in the file. */
    const FileLocation location;

    /** Files that the scene reads because of these values. */
    std::vector<std::string> files;

  private:
    /** By name: as given, and with numbers in place of constants. */
    std::map<std::string, std::string> texts, number_texts;
  };

  /** @name Values that depend on the spatial dimension */
  ///@{
  /**
   * Throws InputError if the scene is planar and @p parameter, which applies in
   * space only, is not at its default. @p remedy tells the user what to do.
   */
  void require_space(const ParameterValues &values,
                     const Parameter       &parameter,
                     const std::string     &remedy = "Remove it");

  /**
   * Vector of two or three components (SI). Throws InputError if it leaves the
   * plane of a planar scene.
   */
  dealii::Tensor<1, 3> vector_of(const ParameterValues &values,
                                 const QuantityList    &parameter);

  /**
   * Unit vector along two or three numbers. Throws InputError if they are zero.
   */
  dealii::Tensor<1, 3> unit_vector_of(const ParameterValues &values,
                                      const QuantityList    &parameter);

  /**
   * Principal moments of inertia about x, y, z at rest (kg m2) from three
   * numbers, or from one for all axes. A planar scene has the moment about z
   * alone. Throws InputError for two numbers.
   */
  dealii::Tensor<1, 3> moments_of_inertia_of(const ParameterValues &values,
                                             const QuantityList    &parameter);
  ///@}
} // namespace auxfem

#endif
