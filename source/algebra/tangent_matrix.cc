#include <auxfem/algebra/tangent_matrix.h>

#include <deal.II/base/exceptions.h>

#include <cmath>

namespace auxfem
{
  TangentPattern::TangentPattern(const Unknowns &unknowns)
    : all(&unknowns)
    , first(1, 0)
  {}

  void TangentPattern::reset(const Unknowns &unknowns)
  {
    all = &unknowns;
    block_unknowns.clear();
    first.assign(1, 0);
    ++changes;
  }

  std::size_t TangentPattern::register_block(const int         *unknowns,
                                             const unsigned int n)
  {
    block_unknowns.insert(block_unknowns.end(), unknowns, unknowns + n);
    first.push_back(block_unknowns.size());
    ++changes;
    return n_blocks() - 1;
  }

  TangentMatrix::TangentMatrix(const TangentPattern &pattern)
    : tangent_pattern(pattern)
  {
    reset();
  }

  void TangentMatrix::reset()
  {
    further_diagonal.clear();
    if (first.empty() || built_version != tangent_pattern.version())
      {
        first.assign(1, 0);
        first.reserve(tangent_pattern.n_blocks() + 1);
        for (std::size_t b = 0; b < tangent_pattern.n_blocks(); ++b)
          first.push_back(first.back() +
                          std::size_t(tangent_pattern.size(b)) *
                            tangent_pattern.size(b));
        // Free the old memory first, so that both do not coexist.
        if (entries.capacity() < first.back())
          entries = std::vector<double>();
        entries.resize(first.back());
        built_version = tangent_pattern.version();
      }
    std::fill(entries.begin(), entries.end(), 0.);
  }

  void TangentMatrix::release()
  {
    entries = std::vector<double>();
    first   = std::vector<std::size_t>();
  }

  void TangentMatrix::add(const std::size_t block, const double *values)
  {
    const std::size_t begin = first[block], end = first[block + 1];
    for (std::size_t i = begin; i < end; ++i)
      entries[i] += values[i - begin];
  }

  /** Calls action(unknowns, n, values) for each block. */
  template <class Action>
  void TangentMatrix::for_each_block(const Action &action) const
  {
    Assert(built_version == tangent_pattern.version(),
           dealii::ExcMessage("The pattern has changed; reset the matrix."));
    for (std::size_t b = 0; b + 1 < first.size(); ++b)
      action(tangent_pattern.begin(b), tangent_pattern.size(b), values(b));
  }

  void TangentMatrix::transpose()
  {
    for (std::size_t b = 0; b + 1 < first.size(); ++b)
      {
        const unsigned int n      = tangent_pattern.size(b);
        double *const      values = entries.data() + first[b];
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < i; ++j)
            std::swap(values[i * n + j], values[j * n + i]);
      }
  }

  void TangentMatrix::symmetrize_blocks()
  {
    for (std::size_t b = 0; b + 1 < first.size(); ++b)
      {
        const unsigned int n      = tangent_pattern.size(b);
        double *const      values = entries.data() + first[b];
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < i; ++j)
            values[i * n + j] = values[j * n + i] =
              (values[i * n + j] + values[j * n + i]) / 2;
      }
  }

  void TangentMatrix::add_multiple(const double         factor,
                                   const TangentMatrix &other)
  {
    const auto add = [factor](const std::vector<double> &from,
                              std::vector<double>       &to) {
      to.resize(std::max(from.size(), to.size()), 0.);
      for (std::size_t i = 0; i < from.size(); ++i)
        to[i] += factor * from[i];
    };
    add(other.entries, entries);
    add(other.further_diagonal, further_diagonal);
  }

  void TangentMatrix::add_to_diagonal(const std::vector<double> &values)
  {
    const Unknowns &unknowns = tangent_pattern.unknowns();
    further_diagonal.resize(unknowns.layout.n_owned(), 0.);
    for (unsigned int i = 0; i < further_diagonal.size(); ++i)
      if (unknowns.kinds[i] != UnknownKind::prescribed)
        further_diagonal[i] += values[i];
  }

  std::vector<double> TangentMatrix::diagonal() const
  {
    const Unknowns     &unknowns = tangent_pattern.unknowns();
    const int           n_owned  = unknowns.layout.n_owned();
    std::vector<double> sums     = further_diagonal;
    sums.resize(n_owned, 0.);
    for_each_block([&](const int         *block_unknowns,
                       const unsigned int n,
                       const double      *block) {
      // An unknown may occur in several rows of a block.
      for (unsigned int i = 0; i < n; ++i)
        if (block_unknowns[i] >= 0 && block_unknowns[i] < n_owned)
          for (unsigned int j = 0; j < n; ++j)
            if (block_unknowns[j] == block_unknowns[i])
              sums[block_unknowns[i]] += block[i * n + j];
    });
    for (int i = 0; i < n_owned; ++i)
      if (unknowns.kinds[i] == UnknownKind::prescribed)
        sums[i] = 1;
    return sums;
  }

  void TangentMatrix::set_diagonal(const std::vector<double> &values)
  {
    std::vector<double> difference = diagonal();
    for (unsigned int i = 0; i < difference.size(); ++i)
      difference[i] = values[i] - difference[i];
    add_to_diagonal(difference);
  }

  std::vector<double> TangentMatrix::row_sizes() const
  {
    const Unknowns     &unknowns = tangent_pattern.unknowns();
    const int           n_owned  = unknowns.layout.n_owned();
    std::vector<double> sizes    = further_diagonal;
    sizes.resize(n_owned, 0.);
    for (double &size : sizes)
      size = std::abs(size);
    for_each_block([&](const int         *block_unknowns,
                       const unsigned int n,
                       const double      *block) {
      for (unsigned int i = 0; i < n; ++i)
        if (block_unknowns[i] >= 0 && block_unknowns[i] < n_owned)
          for (unsigned int j = 0; j < n; ++j)
            if (block_unknowns[j] >= 0)
              sizes[block_unknowns[i]] =
                std::max(sizes[block_unknowns[i]], std::abs(block[i * n + j]));
    });
    for (int i = 0; i < n_owned; ++i)
      if (unknowns.kinds[i] == UnknownKind::prescribed)
        sizes[i] = 1;
    return sizes;
  }

  void TangentMatrix::multiply_blocks(const double  *x,
                                      double        *y,
                                      const Symmetry symmetry) const
  {
    const Unknowns     &unknowns = tangent_pattern.unknowns();
    const int           n_owned  = unknowns.layout.n_owned();
    const bool          enforced = symmetry == Symmetry::enforced;
    std::vector<double> block_x, block_x_free;
    std::fill(y, y + n_owned, 0.);
    for_each_block([&](const int         *block_unknowns,
                       const unsigned int n,
                       const double      *block) {
      block_x.assign(n, 0.);
      for (unsigned int j = 0; j < n; ++j)
        if (block_unknowns[j] >= 0)
          block_x[j] = x[block_unknowns[j]];
      if (enforced)
        {
          // (B x + B^T x_free + B x_prescribed)/2
          block_x_free = block_x;
          for (unsigned int j = 0; j < n; ++j)
            if (block_unknowns[j] >= 0 &&
                unknowns.kinds[block_unknowns[j]] == UnknownKind::prescribed)
              {
                block_x_free[j] = 0;
                block_x[j] *= 2;
              }
        }
      for (unsigned int i = 0; i < n; ++i)
        {
          if (block_unknowns[i] < 0 || block_unknowns[i] >= n_owned)
            continue;
          double sum = 0;
          for (unsigned int j = 0; j < n; ++j)
            sum += block[i * n + j] * block_x[j];
          if (enforced)
            {
              for (unsigned int j = 0; j < n; ++j)
                sum += block[j * n + i] * block_x_free[j];
              sum /= 2;
            }
          y[block_unknowns[i]] += sum;
        }
    });
    for (std::size_t i = 0; i < further_diagonal.size(); ++i)
      y[i] += further_diagonal[i] * x[i];
  }

  void TangentMatrix::multiply(const double  *x,
                               double        *y,
                               const Symmetry symmetry) const
  {
    multiply_blocks(x, y, symmetry);
    const Unknowns &unknowns = tangent_pattern.unknowns();
    for (unsigned int i = 0; i < unknowns.layout.n_owned(); ++i)
      if (unknowns.kinds[i] == UnknownKind::prescribed)
        y[i] = x[i];
  }

  double TangentMatrix::asymmetry() const
  {
    const Unknowns     &unknowns = tangent_pattern.unknowns();
    std::vector<double> weights(unknowns.layout.n_local(), 0.), block_weights;
    for (unsigned int i = 0; i < weights.size(); ++i)
      if (unknowns.kinds[i] != UnknownKind::prescribed)
        weights[i] = unknowns.unit(i) * unknowns.unit(i);
    double difference = 0, size = 0;
    for_each_block([&](const int         *block_unknowns,
                       const unsigned int n,
                       const double      *block) {
      block_weights.resize(n);
      for (unsigned int i = 0; i < n; ++i)
        block_weights[i] =
          block_unknowns[i] >= 0 ? weights[block_unknowns[i]] : 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double entry   = block[i * n + i];
          double       row_sum = block_weights[i] * entry * entry, off_pair = 0;
          for (unsigned int j = 0; j < i; ++j)
            {
              const double lower = block[i * n + j], upper = block[j * n + i];
              off_pair += block_weights[j] * (lower - upper) * (lower - upper);
              row_sum += block_weights[j] * (lower * lower + upper * upper);
            }
          difference += block_weights[i] * 2 * off_pair;
          size += block_weights[i] * row_sum;
        }
    });
    const std::vector<double> sums =
      unknowns.layout.sum(std::vector<double>{difference, size});
    return sums[1] > 0 ? std::sqrt(sums[0] / sums[1]) : 0.;
  }

  double TangentMatrix::asymmetry_of_sum() const
  {
    const Unknowns      &unknowns = tangent_pattern.unknowns();
    const UnknownLayout &layout   = unknowns.layout;
    std::vector<double>  x(layout.n_local(), 0.), product(layout.n_owned()),
      symmetric_product(layout.n_owned());
    for (unsigned int i = 0; i < x.size(); ++i)
      if (unknowns.kinds[i] != UnknownKind::prescribed)
        x[i] = unknowns.unit(i) * std::cos(1. + 3. * layout.global(i));
    multiply(x.data(), product.data());
    multiply(x.data(), symmetric_product.data(), Symmetry::enforced);
    std::vector<double> sums = {0., 0.};
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (unknowns.kinds[i] != UnknownKind::prescribed)
        {
          const double unit = unknowns.unit(i);
          sums[0] +=
            std::pow(2 * unit * (product[i] - symmetric_product[i]), 2);
          sums[1] += std::pow(unit * product[i], 2);
        }
    sums = layout.sum(sums);
    return sums[1] > 0 ? std::sqrt(sums[0] / sums[1]) : 0.;
  }

  bool TangentMatrix::is_symmetric() const
  {
    // Relative imbalance of moments that Newton's tolerance leaves.
    constexpr double moment_imbalance = 1e-6;
    const double     block_asymmetry  = asymmetry();
    return !(block_asymmetry > symmetric_to_round_off) ||
      asymmetry_of_sum() <=
      std::max(symmetric_to_round_off, moment_imbalance * block_asymmetry);
  }
} // namespace auxfem
