#include <auxfem/algebra/shared_work.h>
#include <auxfem/equations/strut_lookout.h>

namespace auxfem
{
  std::optional<std::array<unsigned int, 2>>
  StrutLookout::first_to_touch(const State &from, const State &to)
  {
    const UnknownLayout &layout = model.numbering.layout();
    // What is at `before` already need not be brought from all ranks again.
    const bool                 is_known = is_following && layout.n_ranks() > 1;
    const std::vector<double> &begin =
      is_known ? before : by_global_number(from.displacement, layout, before);
    const std::vector<double> &end =
      by_global_number(to.displacement, layout, after);
    if (!is_following)
      proximity.follow(begin);
    is_following = true;

    const double way = proximity.way_to(end);
    const auto found = proximity.first_too_near(begin, end, /*allowed=*/0, way);
    proximity.follow(end, way);
    before.swap(after);
    if (!found)
      return {};
    const std::vector<ContactAxis> &axes = curves.list();
    return {{{axes[(*found)[0]].strut, axes[(*found)[1]].strut}}};
  }
} // namespace auxfem
