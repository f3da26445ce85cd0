#ifndef auxfem_elements_strut_order_h
#define auxfem_elements_strut_order_h

namespace auxfem
{
  /** Largest polynomial order of struts in the plane, and in space. */
  constexpr int largest_plane_order = 6, largest_space_order = 4;

  /** The same by the dimension. */
  constexpr unsigned int highest_strut_order(const unsigned int dimension)
  {
    return dimension == 2 ? largest_plane_order : largest_space_order;
  }

  /** With Order = auto: linear elements never pay. */
  constexpr unsigned int lowest_chosen_order = 2;
} // namespace auxfem

#endif
