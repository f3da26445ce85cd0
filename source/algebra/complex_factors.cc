#include <auxfem/algebra/complex_factors.h>
#include <auxfem/algebra/shared_work.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <numeric>

#include <klu.h>

namespace auxfem
{
  namespace
  {
    std::vector<std::size_t> begins(const TangentPattern &pattern)
    {
      std::vector<std::size_t> first(1, 0);
      for (std::size_t block = 0; block < pattern.n_blocks(); ++block)
        first.push_back(first.back() + pattern.size(block));
      return first;
    }

    /** Of all blocks; what is prescribed has no part in the determinant. */
    std::vector<int> free_unknowns(const TangentPattern &pattern)
    {
      const auto      &kinds = pattern.unknowns().kinds;
      std::vector<int> all;
      for (std::size_t block = 0; block < pattern.n_blocks(); ++block)
        for (const int *i = pattern.begin(block); i != pattern.end(block); ++i)
          all.push_back(*i >= 0 && kinds[*i] == UnknownKind::prescribed ? -1
                                                                        : *i);
      return all;
    }

    bool is_odd(const int *permutation, const std::size_t n)
    {
      std::vector<bool> is_done(n, false);
      bool              odd = false;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = permutation[i]; !is_done[i] && k != i;
             k             = permutation[k])
          {
                        is_done[k] = true;
                        odd        = !odd;
          }
      return odd;
    }
  } // namespace

  /** KLU goes by columns: it is given the transpose. */
  class ComplexFactors::Klu
  {
  public:
    /** @param columns global numbers, row by row */
    Klu(const std::vector<int> &row_lengths, std::vector<int> columns_of_rows)
      : n(row_lengths.size())
      , offsets(n + 1, 0)
      , columns(std::move(columns_of_rows))
    {
      std::partial_sum(row_lengths.begin(),
                       row_lengths.end(),
                       offsets.begin() + 1);
      klu_defaults(&common);
      common.btf = 0;
      symbolic   = klu_analyze(n, offsets.data(), columns.data(), &common);
    }

    ~Klu()
    {
      klu_z_free_numeric(&numeric, &common);
      klu_free_symbolic(&symbolic, &common);
    }

    Klu(const Klu &)            = delete;
    Klu &operator=(const Klu &) = delete;

    /** @param entries real and imaginary part one after the other */
    bool factorize(std::vector<double> &entries)
    {
      klu_z_free_numeric(&numeric, &common);
      if (symbolic != nullptr)
        numeric = klu_z_factor(offsets.data(),
                               columns.data(),
                               entries.data(),
                               symbolic,
                               &common);
      return numeric != nullptr;
    }

    /** Of P R^-1 A Q = L U, where scales R are positive, L has ones on its
     * diagonal. */
    std::complex<double> log_determinant() const
    {
      std::complex<double> sum = 0;
      const auto *const    pivots =
        static_cast<const std::complex<double> *>(numeric->Udiag);
      for (int i = 0; i < n; ++i)
        sum += std::log(pivots[i]) + std::log(numeric->Rs[i]);
      if (is_odd(numeric->Pnum, n) != is_odd(symbolic->Q, n))
        sum += std::complex<double>(0, dealii::numbers::PI);
      return sum;
    }

    void solve(std::vector<double> &pairs, const Side side)
    {
      if (side == Side::right)
        klu_z_tsolve(symbolic, numeric, n, 1, pairs.data(), 0, &common);
      else
        klu_z_solve(symbolic, numeric, n, 1, pairs.data(), &common);
    }

  private:
    const int        n;
    std::vector<int> offsets, columns;
    klu_common       common;
    klu_symbolic    *symbolic = nullptr;
    klu_numeric     *numeric  = nullptr;
  };

  ComplexFactors::ComplexFactors(const TangentPattern &pattern)
    : layout(pattern.unknowns().layout)
    , pattern(pattern)
    , assembly(layout, begins(pattern), free_unknowns(pattern))
  {
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      is_prescribed.push_back(pattern.unknowns().kinds[i] ==
                              UnknownKind::prescribed);
    const SparseMatrix &matrix = assembly.matrix();
    std::vector<int>    lengths, columns;
    for (unsigned int row = 0; row < layout.n_owned(); ++row)
      lengths.push_back(matrix.first[row + 1] - matrix.first[row]);
    for (const int column : matrix.columns)
      columns.push_back(layout.global(column));
    klu = std::make_unique<Klu>(of_all_ranks(lengths, layout.communicator()),
                                of_all_ranks(columns, layout.communicator()));
  }

  ComplexFactors::~ComplexFactors() = default;

  std::vector<double> ComplexFactors::gather(const TangentMatrix &part,
                                             const double         of_prescribed)
  {
    assembly.reset(Symmetry::none);
    for (std::size_t block = 0; block < pattern.n_blocks(); ++block)
      assembly.add(block, part.values(block));
    const std::vector<double> &diagonal = part.added_diagonal();
    for (unsigned int i = 0; i < diagonal.size(); ++i)
      assembly.add_to_diagonal(i, diagonal[i]);
    for (unsigned int i = 0; i < is_prescribed.size(); ++i)
      if (is_prescribed[i])
        assembly.add_to_diagonal(i, of_prescribed);
    return of_all_ranks(assembly.matrix().entries, layout.communicator());
  }

  bool ComplexFactors::factorize(const TangentMatrix &real,
                                 const TangentMatrix &imaginary)
  {
    const std::vector<double> of_real      = gather(real, 1.),
                              of_imaginary = gather(imaginary, 0.);
    std::vector<double> pairs(2 * of_real.size());
    for (std::size_t i = 0; i < of_real.size(); ++i)
      {
        pairs[2 * i]     = of_real[i];
        pairs[2 * i + 1] = of_imaginary[i];
      }
    return klu->factorize(pairs);
  }

  std::complex<double> ComplexFactors::log_determinant() const
  {
    return klu->log_determinant();
  }

  void ComplexFactors::solve(std::vector<double> &x, const Side side) const
  {
    const unsigned int  n = layout.n_owned();
    std::vector<double> pairs(2 * std::size_t(layout.n_global()), 0.);
    for (unsigned int i = 0; i < n; ++i)
      if (!is_prescribed[i])
        {
          pairs[2 * layout.global(i)]     = x[i];
          pairs[2 * layout.global(i) + 1] = x[n + i];
        }
    pairs = layout.sum(pairs);
    klu->solve(pairs, side);
    for (unsigned int i = 0; i < n; ++i)
      {
        x[i]     = pairs[2 * layout.global(i)];
        x[n + i] = pairs[2 * layout.global(i) + 1];
      }
  }
} // namespace auxfem
