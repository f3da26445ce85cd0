#include <auxfem/algebra/unknowns.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  Unknowns::Unknowns(const UnknownLayout &layout)
    : layout(layout)
    , kinds(layout.n_local(), UnknownKind::translation)
    , is_rotation(layout.n_local(), false)
    , strut(layout.n_local())
    , joint(layout.n_local(), 0)
    , component(layout.n_local(), 0)
  {}

  bool Unknowns::add_ghosts(const std::vector<int> &globals)
  {
    if (!layout.add_ghosts(globals))
      return false;
    const auto exchange =
      [this](auto &values, const auto &from, const auto &to) {
        std::vector<double> all(layout.n_local());
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          all[i] = from(values[i]);
        layout.update_ghosts(all.data());
        const std::size_t n_before = values.size();
        values.resize(all.size());
        for (std::size_t i = n_before; i < all.size(); ++i)
          values[i] = to(all[i]);
      };
    const auto as_number = [](const auto value) {
      return static_cast<double>(value);
    };
    exchange(kinds, as_number, [](const double value) {
      return static_cast<UnknownKind>(std::lround(value));
    });
    exchange(is_rotation, as_number, [](const double value) {
      return value > 0;
    });
    exchange(joint, as_number, [](const double value) {
      return static_cast<unsigned int>(std::lround(value));
    });
    exchange(component, as_number, [](const double value) {
      return static_cast<unsigned char>(std::lround(value));
    });
    strut.resize(layout.n_local());
    layout.update_ghosts(strut);
    return true;
  }

  OwnedRows Unknowns::owned_rows() const
  {
    OwnedRows rows;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
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
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      mine += (kinds[i] == UnknownKind::translation ||
               kinds[i] == UnknownKind::rotation);
    return std::lround(layout.sum(mine));
  }

  unsigned long Unknowns::n_of(const UnknownKind kind) const
  {
    const auto first = kinds.begin();
    return std::lround(
      layout.sum(double(std::count(first, first + layout.n_owned(), kind))));
  }
} // namespace auxfem
