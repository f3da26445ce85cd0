#include <auxfem/algebra/shared_work.h>
#include <auxfem/equations/first_contact_detector.h>

namespace auxfem
{
  std::optional<std::array<unsigned int, 2>>
  FirstContactDetector::find(const State &from, const State &to)
  {
    const UnknownLayout &layout = model.numbering.layout();
    if (!is_following)
      proximity.follow(by_global_number(from.displacement, layout, room));
    is_following = true;
    const std::vector<double> &end =
      by_global_number(to.displacement, layout, room);
    const double way   = proximity.way_to(end);
    const auto   found = proximity.first_too_near(proximity.last_look(),
                                                end,
                                                /*allowed=*/0,
                                                way);
    proximity.follow(end, way);
    if (!found)
      return {};
    const std::vector<ContactAxis> &axes = curves.list();
    return {{{axes[(*found)[0]].strut, axes[(*found)[1]].strut}}};
  }
} // namespace auxfem
