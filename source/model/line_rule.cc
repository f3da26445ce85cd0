#include <auxfem/elements/beam_dispatch.h>
#include <auxfem/elements/beam_shape.h>
#include <auxfem/model/line_rule.h>

namespace auxfem
{
  LineRule::LineRule(const unsigned int order)
  {
    dispatch_order(order, [this](auto p) {
      const BeamShape<p> shape;
      integrals.assign(shape.integral, shape.integral + p + 1);
      nodes.assign(shape.node, shape.node + p + 1);
    });
  }
} // namespace auxfem
