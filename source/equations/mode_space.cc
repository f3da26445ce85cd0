#include <auxfem/equations/mode_space.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace auxfem
{
  namespace
  {
    /** Random numbers between -1 and 1, independent of the number of ranks. */
    Vector random_mode(const UnknownLayout &layout)
    {
      Vector       mode(layout.n_local());
      std::mt19937 generator(1);
      for (unsigned int global = 0; global < layout.n_global(); ++global)
        {
          const double value = 2. * generator() / generator.max() - 1;
          if (const int local = layout.local(global); local >= 0)
            mode[local] = value;
        }
      return mode;
    }
  } // namespace

  std::optional<double>
  inverse_iteration(TangentSolver                           &solver,
                    const Vector                            &weight,
                    const std::function<bool(unsigned int)> &takes_part,
                    const unsigned int                       n_iterations,
                    Vector                                  &mode,
                    const std::function<bool(unsigned int)> &is_enough)
  {
    const UnknownLayout &layout        = solver.equations().unknowns().layout;
    const auto           restrict_mode = [&]() {
      for (unsigned int i = 0; i < mode.size(); ++i)
        if (!takes_part(i))
          mode[i] = 0;
    };
    mode = random_mode(layout);
    restrict_mode();
    double growth = 0;
    bool   solved = solver.factorize();
    for (unsigned int k = 0; solved && k < n_iterations; ++k)
      {
        const double size = layout.largest(largest_size(mode));
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          mode[i] *= weight[i] / size;
        solved = solver.solve(mode);
        restrict_mode();
        growth = layout.largest(largest_size(mode));
        solved = solved && std::isfinite(growth) && growth > 0;
        if (solved && is_enough && is_enough(k + 1))
          break;
      }
    if (!solved)
      return std::nullopt;
    return growth;
  }

  namespace
  {
    constexpr unsigned int n_frequency_iterations = 8;

    /** x.A x over all ranks. */
    double quadratic_form(const TangentMatrix &matrix,
                          const Vector        &x,
                          const UnknownLayout &layout)
    {
      Vector image(layout.n_owned());
      matrix.multiply(x.data(), image.data());
      double sum = 0;
      for (unsigned int i = 0; i < layout.n_owned(); ++i)
        sum += x[i] * image[i];
      return layout.sum(sum);
    }
  } // namespace

  std::optional<double> first_frequency(TangentSolver &solver,
                                        const State   &state)
  {
    const Equations  &equations = solver.equations();
    State             now       = state;
    EvaluationResults results   = equations.make_results();
    const Evaluation  instant   = Evaluation::consistent_rates(state, now);
    solver.residual(instant, results);
    TangentMatrix mass(equations.pattern());
    equations.tangent(instant, results, {0, 0, 1}, mass);

    const Evaluation at_rest = Evaluation::equilibrium(state, now);
    solver.residual(at_rest, results);
    solver.assemble(at_rest, results, {1, 0, 0});

    const Unknowns &unknowns = equations.unknowns();
    Vector          mode;
    const auto      growth = inverse_iteration(
      solver,
      mass.diagonal(),
      [&unknowns](const unsigned int i) {
        return unknowns.kinds[i] != UnknownKind::multiplier &&
          unknowns.kinds[i] != UnknownKind::prescribed;
      },
      n_frequency_iterations,
      mode);
    if (!growth)
      return std::nullopt;
    const double stiffness =
      quadratic_form(solver.matrix(), mode, unknowns.layout);
    const double inertia = quadratic_form(mass, mode, unknowns.layout);
    if (!(stiffness > 0 && inertia > 0))
      return std::nullopt;
    return std::sqrt(stiffness / inertia);
  }

  ModeSpace::ModeSpace(TangentSolver &solver)
    : solver(solver)
    , unknowns(solver.equations().unknowns())
    , layout(unknowns.layout)
  {}

  bool ModeSpace::is_prescribed(const unsigned int i) const
  {
    return unknowns.kinds[i] == UnknownKind::prescribed;
  }

  bool ModeSpace::is_free(const unsigned int i) const
  {
    return !is_prescribed(i) && unknowns.kinds[i] != UnknownKind::multiplier;
  }

  unsigned int ModeSpace::n_free() const
  {
    double n = 0;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (is_free(i))
        ++n;
    const double n_constraints =
      solver.model().numbering.constraints().n_multipliers();
    return std::max(0., layout.sum(n) - n_constraints);
  }

  double ModeSpace::largest_free(const std::vector<double> &values) const
  {
    double mine = 0;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (is_free(i))
        mine = std::max(mine, std::abs(values[i]));
    return layout.largest(mine);
  }

  void ModeSpace::multiply(const TangentMatrix &matrix,
                           const double        *x,
                           double              *y) const
  {
    Vector all(layout.n_local(), 0.);
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (is_free(i))
        all[i] = x[i];
    layout.update_ghosts(all.data());
    matrix.multiply(all.data(), y);
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (!is_free(i))
        y[i] = 0;
  }

  bool ModeSpace::solve(double *x)
  {
    Vector values(layout.n_local(), 0.);
    std::copy_n(x, layout.n_owned(), values.begin());
    if (!solver.solve(values))
      return false;
    std::copy_n(values.begin(), layout.n_owned(), x);
    return true;
  }

  std::optional<unsigned long> ModeSpace::n_negative()
  {
    const std::optional<Inertia> inertia = solver.new_inertia();
    if (!inertia || !solver.linear_solver().is_exact())
      return std::nullopt;
    const unsigned long n_constraints =
      solver.model().numbering.constraints().n_multipliers();
    return inertia->negative - std::min(inertia->negative, n_constraints);
  }

  std::optional<int> ModeSpace::determinant_sign() const
  {
    std::optional<int> sign = solver.linear_solver().determinant_sign();
    // Each constraint adds one negative eigenvalue.
    if (sign && solver.model().numbering.constraints().n_multipliers() % 2 != 0)
      *sign *= -1;
    return sign;
  }

  Vector ModeSpace::shape(const std::vector<double> &owned) const
  {
    Vector shape(layout.n_local(), 0.);
    std::copy(owned.begin(), owned.end(), shape.begin());
    layout.update_ghosts(shape.data());
    normalize_sign(shape);
    return shape;
  }

  void ModeSpace::normalize_sign(Vector &shape) const
  {
    constexpr double as_large = 1 - 1e-6;
    double           mine     = 0;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      mine = std::max(mine, std::abs(shape[i]));
    const double largest = layout.largest(mine);
    double       first   = 0;
    for (unsigned int i = layout.n_owned(); i-- > 0;)
      if (std::abs(shape[i]) >= as_large * largest)
        first = 1 + layout.n_global() - layout.global(i);
    const double first_on_all_ranks = layout.largest(first);
    double       sign               = 0;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (1. + layout.n_global() - layout.global(i) == first_on_all_ranks)
        sign = shape[i] < 0 ? -1 : 1;
    sign = layout.sum(sign);
    for (double &value : shape)
      value *= sign;
  }

  unsigned int count_before_widest_gap(const std::vector<Eigenpair> &pairs,
                                       const unsigned int            n,
                                       const double                  shift)
  {
    unsigned int best   = n;
    double       widest = 0;
    for (unsigned int i = n; i < pairs.size(); ++i)
      if (const double gap = (pairs[i].value - pairs[i - 1].value) /
            std::abs(pairs[i].value - shift);
          gap > widest)
        {
          widest = gap;
          best   = i;
        }
    return best;
  }

  CountLimit limit_below_last(const std::vector<double> &values,
                              const double               lowest)
  {
    // Closer values may swap on finer elements.
    constexpr double equal = 1e-3, beside = 1e-2;
    for (std::size_t i = values.size(); i-- > 0;)
      {
        const double gap = values[i] - (i > 0 ? values[i - 1] : lowest);
        if (gap > equal * (values[i] - lowest))
          return {values[i] - beside * gap, i};
      }
    return {lowest, 0};
  }

  namespace
  {
    using Columns = std::vector<std::vector<double>>;

    /** Symmetrised products a.b of all pairs. */
    dealii::FullMatrix<double>
    products(const UnknownLayout &layout, const Columns &a, const Columns &b)
    {
      const unsigned int  n = a.size();
      std::vector<double> mine(std::size_t(n) * n, 0.);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int k = 0; k < layout.n_owned(); ++k)
            mine[i * n + j] += a[i][k] * b[j][k];
      const std::vector<double>  sums = layout.sum(mine);
      dealii::FullMatrix<double> result(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          result(i, j) = (sums[i * n + j] + sums[j * n + i]) / 2;
      return result;
    }
  } // namespace

  std::vector<double>
  IteratedProducts::combination(const dealii::FullMatrix<double> &coefficients,
                                const unsigned int                j) const
  {
    std::vector<double> sum(vectors.front().size(), 0.);
    for (std::size_t i = 0; i < vectors.size(); ++i)
      add_multiple(coefficients(i, j), vectors[i], sum);
    return sum;
  }

  std::optional<IteratedProducts>
  iterated_products(const ShiftedEigenproblem &problem,
                    const std::vector<Vector> &shapes,
                    const unsigned int         n_iterations)
  {
    const std::size_t n = problem.layout.n_owned(), n_shapes = shapes.size();
    Columns           inertia, iterated, iterated_inertia;
    for (std::size_t i = 0; i < n_iterations * n_shapes; ++i)
      {
        inertia.emplace_back(n);
        if (i < n_shapes)
          problem.multiply_mass(shapes[i].data(), inertia.back().data());
        else
          inertia.back() = iterated_inertia[i - n_shapes];
        iterated.push_back(inertia.back());
        if (!problem.solve(iterated.back().data()))
          return std::nullopt;
        iterated_inertia.emplace_back(n);
        problem.multiply_mass(iterated.back().data(),
                              iterated_inertia.back().data());
      }
    IteratedProducts result{products(problem.layout, iterated, inertia),
                            products(problem.layout,
                                     iterated,
                                     iterated_inertia),
                            {}};
    result.vectors = std::move(iterated);
    return result;
  }

  unsigned long n_below(const std::vector<Eigenpair> &pairs, const double limit)
  {
    return std::count_if(pairs.begin(),
                         pairs.end(),
                         [limit](const Eigenpair &pair) {
                           return pair.value < limit;
                         });
  }

  void clear_constraint_entries(TangentMatrix &matrix)
  {
    const TangentPattern &pattern = matrix.pattern();
    const auto           &kinds   = pattern.unknowns().kinds;
    std::vector<double>   values;
    for (std::size_t block = 0; block < pattern.n_blocks(); ++block)
      {
        const unsigned int n             = pattern.size(block);
        const int *const   first         = pattern.begin(block);
        const auto         is_multiplier = [&](const unsigned int i) {
          return first[i] >= 0 && kinds[first[i]] == UnknownKind::multiplier;
        };
        values.assign(matrix.values(block),
                      matrix.values(block) + std::size_t(n) * n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            if (is_multiplier(i) || is_multiplier(j))
              values[i * n + j] = 0;
        matrix.set(block, values.data());
      }
  }
} // namespace auxfem
