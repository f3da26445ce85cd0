#ifndef auxfem_mesh_condition_h
#define auxfem_mesh_condition_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/registry.h>

#include <memory>

namespace auxfem
{
  /** Lowest and highest coordinates of all joints at rest (m). */
  std::array<dealii::Point<3>, 2> bounding_box(const Lattice &lattice);

  /**
   * Whether @p text is a condition and no name or list: it compares, has
   * brackets or a logical operator.
   */
  bool is_condition(const std::string &text);

  /**
   * A condition on a position: an Expression of `x`, `y`, `z` (m) and the
   * bounding box of the joints as `xmin`, `xmax`, .... True where its value is
   * not zero.
   */
  class Condition
  {
  public:
    /** Throws InputError naming @p path and @p text if it cannot be parsed. */
    Condition(const std::string  &text,
              const Lattice      &lattice,
              const SceneContext &context,
              const std::string  &path);
    ~Condition();

    /** Throws InputError if the value at @p position is not a number. */
    bool holds_at(const dealii::Point<3> &position);

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace auxfem

#endif
