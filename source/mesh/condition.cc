#include <auxfem/mesh/condition.h>

namespace auxfem
{
  bool is_condition(const std::string &text)
  {
    return text.find_first_of("<>=!&|()?") != std::string::npos;
  }

  Condition::Condition(const std::string  &text,
                       const Lattice      &lattice,
                       const SceneContext &context,
                       const std::string  &path)
    : function(text,
               "condition",
               "Positions are best compared by \"abs(y - ymax) < 1e-6\".",
               lattice,
               context,
               path)
  {}
} // namespace auxfem
