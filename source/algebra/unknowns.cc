#include <auxfem/algebra/unknowns.h>

namespace auxfem
{
  Unknowns::Unknowns(const UnknownLayout &layout)
    : layout(&layout)
    , kinds(layout.n_local(), UnknownKind::translation)
    , is_rotation(layout.n_local(), false)
    , strut(layout.n_local())
    , joint(layout.n_local(), 0)
    , component(layout.n_local(), 0)
  {}
} // namespace auxfem
