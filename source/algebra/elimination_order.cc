#include <auxfem/algebra/elimination_order.h>

#include <algorithm>
#include <limits>
#include <new>

#include <cholmod.h>

namespace auxfem
{
  namespace
  {
    /** CHOLMOD's settings, from beginning to end. */
    struct Session
    {
      Session()
      {
        cholmod_start(&common);
        common.print = 0;
      }
      ~Session()
      {
        cholmod_finish(&common);
      }
      Session(const Session &)            = delete;
      Session &operator=(const Session &) = delete;

      cholmod_common common;
    };
  } // namespace

  bool fits_narrow_offsets(const SparseMatrix &matrix)
  {
    return matrix.columns.size() <=
      static_cast<std::size_t>(std::numeric_limits<int>::max());
  }

  std::vector<int> narrow_offsets(const SparseMatrix &matrix)
  {
    return std::vector<int>(matrix.first.begin(), matrix.first.end());
  }

  std::vector<int> elimination_order(const SparseMatrix    &matrix,
                                     const EliminationOrder kind)
  {
    std::vector<int> offsets = narrow_offsets(matrix);
    std::vector<int> columns = matrix.columns;
    std::vector<int> order(matrix.layout->n_owned());
    if (order.empty())
      return order;

    cholmod_sparse pattern = {};
    pattern.nrow = pattern.ncol = order.size();
    pattern.nzmax               = columns.size();
    pattern.p                   = offsets.data();
    pattern.i                   = columns.data();
    pattern.stype               = 1;
    pattern.itype               = CHOLMOD_INT;
    pattern.xtype               = CHOLMOD_PATTERN;
    pattern.dtype               = CHOLMOD_DOUBLE;
    pattern.sorted              = 1;
    pattern.packed              = 1;

    Session    session;
    const bool is_done = kind == EliminationOrder::nested_dissection
      ? cholmod_metis(&pattern, nullptr, 0, 1, order.data(), &session.common)
      : cholmod_amd(&pattern, nullptr, 0, order.data(), &session.common);
    if (!is_done)
      throw std::bad_alloc();
    return order;
  }
} // namespace auxfem
