#ifndef auxfem_mesh_strut_interval_h
#define auxfem_mesh_strut_interval_h

#include <cmath>

namespace auxfem
{
  /** Where an element lies: on which strut, and between which fractions of its
   * length. */
  struct StrutInterval
  {
    unsigned int strut;
    double       begin;
    double       end;

    /** Fraction of the strut's length at @p xi in [-1, 1] of the element. */
    double at(const double xi) const
    {
      return begin + (end - begin) * (1 + xi) / 2;
    }

    /** Number of the element along its strut: all elements of a strut are
     * equally long. */
    unsigned int number() const
    {
      return std::lround(begin / (end - begin));
    }

    /** Whether @p node of the element, in the order of FE_Q, lies at a joint. */
    bool is_joint(const unsigned int node) const
    {
      return (node == 0 && begin == 0.) || (node == 1 && end == 1.);
    }
  };

  /**
   * Position along the element, 0..order, of @p node in the order of FE_Q (both
   * ends, then the inner nodes).
   */
  inline unsigned int place_along(const unsigned int node,
                                  const unsigned int order)
  {
    return node == 0 ? 0 : (node == 1 ? order : node - 1);
  }
} // namespace auxfem

#endif
