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
   * bounds `xmin`, `xmax`, ... of the lattice's joints, with random numbers of
   * items if these are given.
   */
  class PositionFunction
  {
  public:
    enum class Random
    {
      refused,
      allowed
    };

    /**
     * Throws InputError naming @p path and @p text if it cannot be parsed.
     * @param noun name of the text in messages, e.g. `condition`
     * @param hint last sentence of these messages
     * @param random whether the text may have random numbers
     */
    PositionFunction(const std::string  &text,
                     const std::string  &noun,
                     const std::string  &hint,
                     const Lattice      &lattice,
                     const SceneContext &context,
                     const std::string  &path,
                     Random              random = Random::refused);
    ~PositionFunction();

    /** Value at @p position (m). Throws InputError if it is not a number.
     * @param item number of the joint or strut there, for random numbers */
    double value_at(const dealii::Point<3> &position, unsigned int item = 0);

    /** Whether the text has random numbers, so that items at the same place may
     * have different values. */
    bool is_random() const;

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
