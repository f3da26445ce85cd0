#include <auxfem/algebra/unknown_selection.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    UnknownLayout layout_of(const UnknownLayout     &all,
                            const std::vector<bool> &is_selected)
    {
      const unsigned int n_owned =
        std::count(is_selected.begin(),
                   is_selected.begin() + all.n_owned(),
                   true);
      UnknownLayout layout(all.communicator(), n_owned, {});
      if (all.n_ranks() == 1)
        return layout;

      // Numbers in the selection, brought to the ghosts as values.
      std::vector<double> globals(all.n_local(), -1.);
      unsigned int        number = 0;
      for (unsigned int i = 0; i < all.n_owned(); ++i)
        if (is_selected[i])
          globals[i] = layout.global(number++);
      all.update_ghosts(globals.data());
      std::vector<int> ghosts;
      for (unsigned int i = all.n_owned(); i < all.n_local(); ++i)
        if (is_selected[i])
          ghosts.push_back(static_cast<int>(globals[i]));
      layout.add_ghosts(ghosts);
      return layout;
    }
  } // namespace

  UnknownSelection::UnknownSelection(const UnknownLayout     &all,
                                     const std::vector<bool> &is_selected)
    : layout(layout_of(all, is_selected))
    , number(all.n_local(), -1)
  {
    for (unsigned int i = 0; i < all.n_local(); ++i)
      if (is_selected[i])
        {
          number[i] = unknowns.size();
          unknowns.push_back(i);
        }
  }
} // namespace auxfem
