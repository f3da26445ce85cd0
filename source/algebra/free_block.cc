#include <auxfem/algebra/free_block.h>

#include <deal.II/base/exceptions.h>

namespace auxfem
{
  namespace
  {
    std::vector<bool> is_free(const Unknowns &unknowns)
    {
      std::vector<bool> free;
      for (const UnknownKind kind : unknowns.kinds)
        free.push_back(kind != UnknownKind::prescribed);
      return free;
    }

    SparseAssembly make_assembly(const TangentPattern   &pattern,
                                 const UnknownSelection &free)
    {
      std::vector<std::size_t> first(1, 0);
      std::vector<int>         unknowns;
      for (std::size_t b = 0; b < pattern.n_blocks(); ++b)
        {
          for (const int *i = pattern.begin(b); i != pattern.end(b); ++i)
            unknowns.push_back(*i < 0 ? -1 : free.number[*i]);
          first.push_back(unknowns.size());
        }
      return SparseAssembly(free.layout, first, unknowns);
    }
  } // namespace

  FreeBlock::FreeBlock(const TangentMatrix &matrix)
    : free(matrix.pattern().unknowns().layout,
           is_free(matrix.pattern().unknowns()))
    , assembly(make_assembly(matrix.pattern(), free))
    , version(matrix.version())
  {
    assemble(matrix);
  }

  void FreeBlock::assemble(const TangentMatrix &matrix)
  {
    Assert(matrix.version() == version,
           dealii::ExcMessage("The pattern of the matrix has changed."));
    assembly.reset(Symmetry::none);
    for (std::size_t b = 0; b < matrix.pattern().n_blocks(); ++b)
      assembly.add(b, matrix.values(b));
    if (!matrix.added_diagonal().empty())
      for (unsigned int i = 0; i < free.layout.n_owned(); ++i)
        assembly.add_to_diagonal(i, matrix.added_diagonal()[free.unknowns[i]]);
  }
} // namespace auxfem
