#include <auxfem/algebra/unknowns.h>

#include <cmath>

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

  OwnedRows Unknowns::owned_rows() const
  {
    OwnedRows rows;
    for (unsigned int i = 0; i < layout->n_owned(); ++i)
      if (kinds[i] == UnknownKind::multiplier)
        rows.multipliers.push_back(i);
      else if (kinds[i] == UnknownKind::prescribed)
        (is_rotation[i] ? rows.prescribed_rotations
                        : rows.prescribed_translations)
          .push_back(i);
      else
        (is_rotation[i] ? rows.free_rotations : rows.free_translations)
          .push_back(i);
    return rows;
  }

  unsigned int Unknowns::n_free() const
  {
    double mine = 0;
    for (unsigned int i = 0; i < layout->n_owned(); ++i)
      mine += (kinds[i] == UnknownKind::translation ||
               kinds[i] == UnknownKind::rotation);
    return std::lround(layout->sum(mine));
  }
} // namespace auxfem
