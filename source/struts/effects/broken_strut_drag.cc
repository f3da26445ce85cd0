#include <auxfem/struts/effects/broken_strut_drag.h>

namespace auxfem
{
  BrokenStrutDrag::BrokenStrutDrag(const unsigned int n_nodes,
                                   const unsigned int n_components)
    : n_nodes(n_nodes)
    , n_components(n_components)
    , n_translations(n_components == 3 ? 2 : 3)
  {}

  template <class Action>
  void BrokenStrutDrag::for_each_pair(const Action &action) const
  {
    for (unsigned int node = 0; node + 1 < n_nodes; ++node)
      for (unsigned int c = 0; c < n_translations; ++c)
        action(n_components * node + c, n_components * (node + 1) + c);
  }

  void BrokenStrutDrag::add_force(const double  c,
                                  const int    *unknowns,
                                  const double *v,
                                  double       *residual) const
  {
    for_each_pair([&](const unsigned int i, const unsigned int j) {
      const double force = c * (v[unknowns[i]] - v[unknowns[j]]);
      residual[unknowns[i]] += force;
      residual[unknowns[j]] -= force;
    });
  }

  void BrokenStrutDrag::add_block(const double c, double *block) const
  {
    const unsigned int n = n_components * n_nodes;
    for_each_pair([&](const unsigned int i, const unsigned int j) {
      block[i * n + i] += c;
      block[j * n + j] += c;
      block[i * n + j] -= c;
      block[j * n + i] -= c;
    });
  }

  double BrokenStrutDrag::power(const int    *unknowns,
                                const double *v,
                                const double *w) const
  {
    double sum = 0;
    for_each_pair([&](const unsigned int i, const unsigned int j) {
      sum +=
        (v[unknowns[i]] - v[unknowns[j]]) * (w[unknowns[i]] - w[unknowns[j]]);
    });
    return sum;
  }
} // namespace auxfem
