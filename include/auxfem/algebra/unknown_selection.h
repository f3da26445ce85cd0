#ifndef auxfem_algebra_unknown_selection_h
#define auxfem_algebra_unknown_selection_h

#include <auxfem/algebra/unknown_layout.h>

namespace auxfem
{
  /** Some of the unknowns of a layout, with a layout of their own. */
  struct UnknownSelection
  {
    /**
     * @param is_selected by local unknown of @p all; owned and ghost copies
     *   agree. Their order stays. Collective.
     */
    UnknownSelection(const UnknownLayout     &all,
                     const std::vector<bool> &is_selected);

    UnknownLayout layout;
    /** By local unknown of all: local unknown of the selection, or -1. */
    std::vector<int> number;
    /** Local unknowns of all, in the order of the selection. */
    std::vector<int> unknowns;
  };
} // namespace auxfem

#endif
