#ifndef auxfem_elements_strut_order_h
#define auxfem_elements_strut_order_h

namespace auxfem
{
  /** Largest polynomial order of struts in the plane, and in space. */
  constexpr int largest_plane_order = 6, largest_space_order = 4;
} // namespace auxfem

#endif
