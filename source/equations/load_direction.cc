#include <auxfem/equations/load_direction.h>
#include <auxfem/equations/prescribed_motion.h>

namespace auxfem
{
  Vector load_direction(const Equations  &equations,
                        const Evaluation &evaluation)
  {
    Vector loads = equations.load_derivative(evaluation);
    scale(-1., loads);
    const Unknowns &unknowns = equations.unknowns();
    for (unsigned int i = 0; i < unknowns.layout.n_owned(); ++i)
      if (unknowns.kinds[i] == UnknownKind::prescribed)
        loads[i] = 0;
    find_motion_derivative(equations.model(), evaluation, loads.data());
    return loads;
  }
} // namespace auxfem
