#ifndef auxfem_mesh_condition_h
#define auxfem_mesh_condition_h

#include <auxfem/mesh/position_function.h>

namespace auxfem
{
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
