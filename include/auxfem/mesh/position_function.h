#ifndef auxfem_mesh_position_function_h
#define auxfem_mesh_position_function_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/registry.h>

#include <deal.II/base/point.h>

#include <memory>
#include <string>

namespace auxfem
{
  /**
   * A position for messages, `(x, y) m` in the plane (@p dimension 2) and
   * `(x, y, z) m` in space.
   */
  std::string position_text(const dealii::Point<3> &position,
                            unsigned int            dimension);

  /** Lowest and highest coordinates of all joints of @p lattice (m). */
  std::array<dealii::Point<3>, 2> bounding_box(const Lattice &lattice);

  /**
   * A number that depends on a position: an Expression of `x`, `y`, `z` (m) and
   * the bounding box of the joints as `xmin`, `xmax`, ....
   */
  class PositionFunction
  {
  public:
    /**
     * Throws InputError naming @p path and @p text if it cannot be parsed.
     * @param noun what the text is called in messages, e.g. `condition`
     * @param hint sentence that ends these
     */
    PositionFunction(const std::string  &text,
                     const std::string  &noun,
                     const std::string  &hint,
                     const Lattice      &lattice,
                     const SceneContext &context,
                     const std::string  &path);
    ~PositionFunction();

    /** Throws InputError if it is not a number. */
    double value_at(const dealii::Point<3> &position);

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation;
  };

  /**
   * Whether @p text is a condition and no name or list: it compares, has
   * brackets or a logical operator.
   */
  bool is_condition(const std::string &text);

  /** A condition on a position: true where a PositionFunction is not zero. */
  class Condition
  {
  public:
    /** Throws InputError naming @p path and @p text if it cannot be parsed. */
    Condition(const std::string  &text,
              const Lattice      &lattice,
              const SceneContext &context,
              const std::string  &path);

    /** Throws InputError if the value at @p position is not a number. */
    bool holds_at(const dealii::Point<3> &position)
    {
      return function.value_at(position) != 0.;
    }

  private:
    PositionFunction function;
  };
} // namespace auxfem

#endif
