#include <auxfem/algebra/eigen_solver.h>
#include <auxfem/analysis/infinite_lattice/bloch_waves.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/model/linear_relations.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** An unknown of the finite elements by one of the period. */
    struct ReducedUnknown
    {
      unsigned int       number = invalid_index;
      std::array<int, 3> shift  = {{0, 0, 0}}; ///< in periods
    };

    /** Numbers the unknowns of the period; translations and images have none of
     * their own. Returns them by unknown of the finite elements, and sets @p
     * n_reduced to their number. */
    std::vector<ReducedUnknown> reduced_unknowns(const LatticeModel &model,
                                                 unsigned int       &n_reduced)
    {
      const Lattice              &lattice   = model.lattice;
      const DofNumbering         &numbering = model.numbering;
      std::vector<ReducedUnknown> unknowns(numbering.layout().n_local());
      std::vector<bool>           has_number(unknowns.size(), true);
      for (unsigned int d = 0; d < lattice.n_translations; ++d)
        for (unsigned int c = 0; c < lattice.dimension; ++c)
          has_number[numbering.joint_unknown(lattice.joint_of_translation(d),
                                             c)] = false;
      const auto ties = image_ties(lattice, model.releases);
      for (const ImageTie &tie : ties)
        has_number[numbering.joint_unknown(tie.image, tie.component)] = false;
      n_reduced = 0;
      for (unsigned int u = 0; u < unknowns.size(); ++u)
        if (has_number[u])
          unknowns[u].number = n_reduced++;
      for (const ImageTie &tie : ties)
        unknowns[numbering.joint_unknown(tie.image, tie.component)] = {
          unknowns[numbering.joint_unknown(tie.like, tie.component)].number,
          tie.shift};
      return unknowns;
    }

    /** Columns of a matrix. */
    std::vector<Vector> columns_of(const TangentMatrix &matrix,
                                   const unsigned int   n)
    {
      std::vector<Vector> columns(n, Vector(n));
      Vector              unit(n, 0.);
      for (unsigned int j = 0; j < n; ++j)
        {
          unit[j] = 1;
          matrix.multiply_blocks(unit.data(), columns[j].data());
          unit[j] = 0;
        }
      return columns;
    }
  } // namespace

  BlochWaves::BlochWaves(LatticeRun &run) : lattice(run.lattice)
  {
    Assert(run.model.numbering.constraints().n_multipliers() == 0,
           dealii::ExcMessage("Waves have no constraints."));
    const std::vector<ReducedUnknown> reduced =
      reduced_unknowns(run.model, n_reduced);
    EvaluationResults results = run.equations.make_results();
    const State       rest    = run.solution.state;
    const Evaluation  at_rest =
      Evaluation::equilibrium(rest, run.solution.state);
    TangentSolver &solver = run.solver();
    solver.residual(at_rest, results);
    const unsigned int n = run.model.numbering.layout().n_local();
    solver.assemble(at_rest, results, {1., 0., 0.});
    const std::vector<Vector> K = columns_of(solver.matrix(), n);
    solver.assemble(at_rest, results, {0., 0., 1.});
    const std::vector<Vector> M = columns_of(solver.matrix(), n);

    std::vector<double> mass(n_reduced, 0.);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          const ReducedUnknown &row = reduced[i], &column = reduced[j];
          if (row.number == invalid_index || column.number == invalid_index ||
              (K[j][i] == 0 && M[j][i] == 0))
            continue;
          std::array<int, 3> difference{};
          for (unsigned int d = 0; d < 3; ++d)
            difference[d] = column.shift[d] - row.shift[d];
          entries.push_back(
            {row.number, column.number, difference, K[j][i], M[j][i]});
          if (i == j)
            mass[row.number] += M[j][i];
        }
    if (std::any_of(mass.begin(), mass.end(), [](const double m) {
          return !(m > 0);
        }))
      throw InputError("Analysis = dispersion: some motions have no mass. Give "
                       "all sections a Density, and joints between massless "
                       "struts a mass.");
    // A typical squared frequency: it separates the lowest from zero.
    double least = std::numeric_limits<double>::infinity();
    for (const Entry &entry : entries)
      if (entry.row == entry.column && entry.shift == std::array<int, 3>{})
        least = std::min(least, entry.stiffness / mass[entry.row]);
    shift = 1e-4 * least;
  }

  template <class Value>
  dealii::FullMatrix<double>
  BlochWaves::real_matrix(const WavePhases  &phases,
                          const Value       &value,
                          const unsigned int derivative) const
  {
    // Re z + i Im z acts on real and imaginary parts as [Re, -Im; Im, Re].
    dealii::FullMatrix<double> matrix(2 * n_reduced, 2 * n_reduced);
    for (const Entry &entry : entries)
      {
        double phase = 0;
        for (unsigned int d = 0; d < 3; ++d)
          phase += entry.shift[d] * phases[d];
        double real = std::cos(phase), imaginary = std::sin(phase);
        if (derivative < 3)
          {
            const double cosine = real;
            real                = -entry.shift[derivative] * imaginary;
            imaginary           = entry.shift[derivative] * cosine;
          }
        const double factor = value(entry);
        const auto   add =
          [&](const unsigned int i, const unsigned int j, const double part) {
            matrix(i, j) += factor * part;
          };
        add(entry.row, entry.column, real);
        add(entry.row, n_reduced + entry.column, -imaginary);
        add(n_reduced + entry.row, entry.column, imaginary);
        add(n_reduced + entry.row, n_reduced + entry.column, real);
      }
    return matrix;
  }

  RitzPairs BlochWaves::quotients(const WavePhases &phases) const
  {
    return ritz_pairs(real_matrix(phases,
                                  [](const Entry &e) { return e.mass; }),
                      real_matrix(phases, [this](const Entry &e) {
                        return e.stiffness + shift * e.mass;
                      }));
  }

  double BlochWaves::squared_frequency(const double quotient) const
  {
    return std::max(0., 1 / quotient - shift);
  }

  std::vector<double> BlochWaves::frequencies(const WavePhases  &phases,
                                              const unsigned int n) const
  {
    const std::vector<double> values = quotients(phases).values;
    std::vector<double>       result;
    for (unsigned int j = 0; j + 1 < values.size() && result.size() < n; j += 2)
      result.push_back(std::sqrt(squared_frequency(values[j])));
    return result;
  }

  std::vector<BlochWave> BlochWaves::waves(const WavePhases  &phases,
                                           const unsigned int n) const
  {
    const RitzPairs pairs     = quotients(phases);
    const auto      square_of = [&](const unsigned int j) {
      return squared_frequency(pairs.values[j]);
    };
    std::vector<BlochWave> result;
    for (unsigned int j = 0; j + 1 < pairs.values.size() && result.size() < n;
         j += 2)
      result.push_back({std::sqrt(square_of(j)), std::nullopt});
    const auto is_alone = [&](const unsigned int i) {
      const double w       = square_of(2 * i);
      const auto   differs = [&](const unsigned int j) {
        return std::abs(square_of(j) - w) > 1e-6 * w;
      };
      return w > shift * 1e-6 && (i == 0 || differs(2 * i - 2)) &&
        (2 * i + 2 >= pairs.values.size() || differs(2 * i + 2));
    };
    const auto mass =
      real_matrix(phases, [](const Entry &e) { return e.mass; });
    std::vector<dealii::FullMatrix<double>> slopes_K, slopes_M;
    const unsigned int                      dimension = lattice.dimension;
    for (unsigned int d = 0; d < dimension; ++d)
      {
        slopes_K.push_back(real_matrix(
          phases,
          [](const Entry &e) { return e.stiffness; },
          d));
        slopes_M.push_back(real_matrix(
          phases,
          [](const Entry &e) { return e.mass; },
          d));
      }
    for (unsigned int i = 0; i < result.size(); ++i)
      {
        if (!is_alone(i))
          continue;
        dealii::Vector<double> x(2 * n_reduced);
        for (unsigned int k = 0; k < x.size(); ++k)
          x[k] = pairs.coefficients(k, 2 * i);
        const double w = result[i].angular_frequency,
                     m = mass.matrix_norm_square(x);
        // Derivative of w^2 = x.K x / x.M x by phases (Hellmann, Feynman).
        dealii::Tensor<1, 3> velocity;
        for (unsigned int d = 0; d < dimension; ++d)
          velocity += (slopes_K[d].matrix_norm_square(x) -
                       w * w * slopes_M[d].matrix_norm_square(x)) /
            (2 * w * m) * lattice.periodicity->vectors[d];
        result[i].group_velocity = velocity;
      }
    return result;
  }
} // namespace auxfem
