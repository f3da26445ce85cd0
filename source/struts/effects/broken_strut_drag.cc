#include <auxfem/struts/effects/broken_strut_drag.h>

#include <algorithm>
#include <numeric>

namespace auxfem
{
  BrokenStrutDrag::BrokenStrutDrag(const std::vector<double> &nodes,
                                   const unsigned int         n_components)
    : n_nodes(nodes.size())
    , n_components(n_components)
    , n_translations(n_components == 3 ? 2 : 3)
  {
    // The two ends come first among the nodes.
    std::vector<unsigned int> order(n_nodes);
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(),
              order.end(),
              [&](const unsigned int a, const unsigned int b) {
                return nodes[a] < nodes[b];
              });
    const double mean_distance = 2. / (n_nodes - 1);
    for (unsigned int i = 0; i + 1 < n_nodes; ++i)
      pairs.push_back(
        {order[i],
         order[i + 1],
         mean_distance / (nodes[order[i + 1]] - nodes[order[i]])});
  }

  template <class Action>
  void BrokenStrutDrag::for_each_pair(const Action &action) const
  {
    for (const Pair &pair : pairs)
      for (unsigned int c = 0; c < n_translations; ++c)
        action(n_components * pair.first + c,
               n_components * pair.second + c,
               pair.weight);
  }

  void BrokenStrutDrag::add_force(const double  c,
                                  const int    *unknowns,
                                  const double *v,
                                  double       *residual) const
  {
    for_each_pair(
      [&](const unsigned int i, const unsigned int j, const double weight) {
        const double force = c * weight * (v[unknowns[i]] - v[unknowns[j]]);
        residual[unknowns[i]] += force;
        residual[unknowns[j]] -= force;
      });
  }

  void BrokenStrutDrag::add_block(const double c, double *block) const
  {
    const unsigned int n = n_components * n_nodes;
    for_each_pair(
      [&](const unsigned int i, const unsigned int j, const double weight) {
        block[i * n + i] += c * weight;
        block[j * n + j] += c * weight;
        block[i * n + j] -= c * weight;
        block[j * n + i] -= c * weight;
      });
  }

  double BrokenStrutDrag::power(const int    *unknowns,
                                const double *v,
                                const double *w) const
  {
    double sum = 0;
    for_each_pair(
      [&](const unsigned int i, const unsigned int j, const double weight) {
        sum += weight * (v[unknowns[i]] - v[unknowns[j]]) *
          (w[unknowns[i]] - w[unknowns[j]]);
      });
    return sum;
  }
} // namespace auxfem
