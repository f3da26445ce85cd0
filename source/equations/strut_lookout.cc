#include <auxfem/algebra/shared_work.h>
#include <auxfem/equations/strut_lookout.h>

#include <algorithm>

namespace auxfem
{
  std::optional<std::array<unsigned int, 2>>
  StrutLookout::first_to_touch(const State &from, const State &to)
  {
    const UnknownLayout &layout = model.numbering.layout();
    if (!is_following)
      proximity.follow(by_global_number(from.displacement, layout, room));
    is_following = true;
    if (++n_unseen < distance && to.velocity && !proximity.may_touch())
      return {};

    const std::vector<double> &end =
      by_global_number(to.displacement, layout, room);
    const double way   = proximity.way_to(end);
    const auto   found = proximity.first_too_near(proximity.last_look(),
                                                end,
                                                /*allowed=*/0,
                                                way);
    proximity.follow(end, way);
    set_distance(way);
    if (!found)
      return {};
    const std::vector<ContactAxis> &axes = curves.list();
    return {{{axes[(*found)[0]].strut, axes[(*found)[1]].strut}}};
  }

  void StrutLookout::set_distance(const double way)
  {
    constexpr double most = 8, safety = 2;
    n_steps += n_unseen;
    n_unseen          = 0;
    const double left = proximity.unseen_motion();
    distance          = std::clamp(left * n_steps / (safety * way), 1., most);
    if (way >= left)
      n_steps = 0;
  }
} // namespace auxfem
