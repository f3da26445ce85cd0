#include <auxfem/algebra/strut_elements.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** Strut that an unknown of a block lies inside of; none for other blocks.
     */
    std::optional<unsigned int> strut_of(const TangentPattern &pattern,
                                         const std::size_t     block)
    {
      for (const int *i = pattern.begin(block); i != pattern.end(block); ++i)
        if (*i >= 0 && pattern.unknowns().strut[*i])
          return pattern.unknowns().strut[*i];
      return std::nullopt;
    }

    bool can_be_eliminated(const TangentPattern &pattern,
                           const unsigned int    strut,
                           const int             unknown)
    {
      const Unknowns &unknowns = pattern.unknowns();
      return unknowns.layout.is_owned(unknown) &&
        unknowns.strut[unknown] == strut &&
        unknowns.kinds[unknown] != UnknownKind::prescribed;
    }

    bool is_at_joint(const TangentPattern &pattern, const int unknown)
    {
      return unknown >= 0 && !pattern.unknowns().strut[unknown];
    }

    /** Whether the elements are as they must be; takes the eliminations. */
    bool prepare(const TangentPattern &pattern, StrutElements &elements)
    {
      const unsigned int c = elements.n_of_node, n = elements.n_of_element;
      if (n < 2 * c)
        return false;
      elements.between_nodes = inner_elimination({n - 2 * c, 2 * c});
      elements.node          = inner_elimination({c, 2 * c});
      if ((n > 2 * c && elements.between_nodes == nullptr) ||
          (elements.n_elements > 1 && elements.node == nullptr))
        return false;

      for (unsigned int e = 0; e < elements.n_elements; ++e)
        {
          const std::size_t block = elements.first_block + e;
          if (pattern.size(block) != n)
            return false;
          const int *const of_element = pattern.begin(block);
          const auto       is_inside  = [&](const int unknown) {
            return can_be_eliminated(pattern, elements.strut, unknown);
          };
          if (!std::all_of(of_element + 2 * c, of_element + n, is_inside))
            return false;
          const auto at_joint = [&](const int unknown) {
            return is_at_joint(pattern, unknown);
          };
          if (e == 0 && !std::all_of(of_element, of_element + c, at_joint))
            return false;
          const int *const last_node = of_element + c;
          if (e + 1 == elements.n_elements)
            {
              if (!std::all_of(last_node, last_node + c, at_joint))
                return false;
            }
          else if (!std::all_of(last_node, last_node + c, is_inside) ||
                   !std::equal(last_node,
                               last_node + c,
                               pattern.begin(block + 1)))
            return false;
        }
      return true;
    }

    /** Removes those whose inside other blocks act on. */
    void remove_disturbed(const TangentPattern       &pattern,
                          std::vector<StrutElements> &found)
    {
      constexpr unsigned int    nobody = -1;
      std::vector<unsigned int> eliminates(pattern.unknowns().layout.n_local(),
                                           nobody);
      for (unsigned int s = 0; s < found.size(); ++s)
        for (std::size_t b = found[s].first_block;
             b < found[s].first_block + found[s].n_elements;
             ++b)
          for (const int *i = pattern.begin(b); i != pattern.end(b); ++i)
            if (pattern.unknowns().strut[*i])
              eliminates[*i] = s;

      std::vector<bool> is_disturbed(found.size(), false);
      std::size_t       next = 0;
      for (std::size_t b = 0; b < pattern.n_blocks(); ++b)
        {
          while (next < found.size() &&
                 b >= found[next].first_block + found[next].n_elements)
            ++next;
          const unsigned int own =
            next < found.size() && b >= found[next].first_block ? next : nobody;
          for (const int *i = pattern.begin(b); i != pattern.end(b); ++i)
            if (*i >= 0 && eliminates[*i] != nobody && eliminates[*i] != own)
              is_disturbed[eliminates[*i]] = true;
        }
      std::size_t n_kept = 0;
      for (std::size_t s = 0; s < found.size(); ++s)
        if (!is_disturbed[s])
          found[n_kept++] = found[s];
      found.resize(n_kept);
    }
  } // namespace

  std::vector<StrutElements> find_strut_elements(const TangentPattern &pattern)
  {
    std::vector<StrutElements> found;
    const unsigned int         n_of_node = pattern.unknowns().components.size();
    std::size_t                block     = 0;
    while (block < pattern.n_blocks())
      {
        const std::optional<unsigned int> strut = strut_of(pattern, block);
        std::size_t                       end   = block + 1;
        if (strut)
          {
            while (end < pattern.n_blocks() && strut_of(pattern, end) == strut)
              ++end;
            StrutElements elements{*strut,
                                   block,
                                   static_cast<unsigned int>(end - block),
                                   n_of_node,
                                   pattern.size(block),
                                   nullptr,
                                   nullptr};
            if (prepare(pattern, elements))
              found.push_back(elements);
          }
        block = end;
      }
    remove_disturbed(pattern, found);
    found.shrink_to_fit();
    return found;
  }
} // namespace auxfem
