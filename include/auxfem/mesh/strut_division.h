#ifndef auxfem_mesh_strut_division_h
#define auxfem_mesh_strut_division_h

#include <tuple>

namespace auxfem
{
  /** The elements that a strut is divided into, all equally long. */
  struct StrutDivision
  {
    unsigned int order; ///< polynomial
    unsigned int n_elements;

    /** Nodes that are the strut's own, between its joints. */
    unsigned int n_inner_nodes() const
    {
      return order * n_elements - 1;
    }

    bool operator==(const StrutDivision &other) const
    {
      return order == other.order && n_elements == other.n_elements;
    }

    /** By order, then by number. */
    bool operator<(const StrutDivision &other) const
    {
      return std::tie(order, n_elements) <
        std::tie(other.order, other.n_elements);
    }
  };
} // namespace auxfem

#endif
