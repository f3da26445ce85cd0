#ifndef auxfem_mesh_position_function_h
#define auxfem_mesh_position_function_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/registry.h>

#include <deal.II/base/point.h>

#include <memory>
#include <string>

namespace auxfem
{
  /** Text of a position for messages: `(x, y) m` for @p dimension 2, otherwise
   * `(x, y, z) m`. */
  std::string position_text(const dealii::Point<3> &position,
                            unsigned int            dimension);

  /** Lowest and highest coordinates of the joints of @p lattice without plates
   * (m). */
  std::array<dealii::Point<3>, 2> bounding_box(const Lattice &lattice);

  /**
   * A scalar function of position: an Expression in `x`, `y`, `z` (m) and the
   * bounds `xmin`, `xmax`, ... of the lattice's joints.
   */
  class PositionFunction
  {
  public:
    /**
     * Throws InputError naming @p path and @p text if it cannot be parsed.
     * @param noun name of the text in messages, e.g. `condition`
     * @param hint last sentence of these messages
     */
    PositionFunction(const std::string  &text,
                     const std::string  &noun,
                     const std::string  &hint,
                     const Lattice      &lattice,
                     const SceneContext &context,
                     const std::string  &path);
    ~PositionFunction();

    /** Value at @p position (m). Throws InputError if it is not a number. */
    double value_at(const dealii::Point<3> &position);

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation;
  };

  /** Whether @p text is a condition, not a name or list: it has a comparison,
   * brackets or a logical operator. */
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

    /** Whether the condition holds at @p position (m). Throws InputError if its
     * value is not a number. */
    bool holds_at(const dealii::Point<3> &position)
    {
      return function.value_at(position) != 0.;
    }

  private:
    PositionFunction function;
  };
} // namespace auxfem

#endif
