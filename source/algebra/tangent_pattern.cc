#include <auxfem/algebra/tangent_pattern.h>

namespace auxfem
{
  TangentPattern::TangentPattern(const Unknowns &unknowns)
    : all(&unknowns)
    , first(1, 0)
  {}

  void TangentPattern::reset(const Unknowns &unknowns)
  {
    all = &unknowns;
    of_blocks.clear();
    first.assign(1, 0);
    ++changes;
  }

  std::size_t TangentPattern::register_block(const int         *unknowns,
                                             const unsigned int n)
  {
    of_blocks.insert(of_blocks.end(), unknowns, unknowns + n);
    first.push_back(of_blocks.size());
    ++changes;
    return n_blocks() - 1;
  }
} // namespace auxfem
