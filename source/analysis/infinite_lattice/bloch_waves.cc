#include <auxfem/analysis/infinite_lattice/bloch_waves.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  BlochWaves::BlochWaves(LatticeRun &run) : lattice(run.lattice)
  {
    const PeriodUnknowns unknowns(run.model);
    const UnknownLayout &layout  = run.model.numbering.layout();
    EvaluationResults    results = run.equations.make_results();
    const State          rest    = run.solution.state;
    const Evaluation     at_rest =
      Evaluation::equilibrium(rest, run.solution.state);
    TangentSolver &solver = run.solver();
    solver.residual(at_rest, results);
    const auto period_matrix = [&](const TangentMatrix &assembled) {
      PeriodMatrix matrix(unknowns.size());
      for (const MatrixEntry &entry : entries_on_first_rank(assembled, layout))
        matrix.add(unknowns[entry.row], unknowns[entry.column], entry.value);
      return matrix;
    };
    const auto assembled = [&](const TangentFactors &factors) {
      solver.assemble(at_rest, results, factors);
      return period_matrix(solver.matrix());
    };
    mass      = assembled({0., 0., 1.});
    stiffness = assembled({1., 0., 0.});
    TangentMatrix matrix(run.equations.pattern());
    for (const double time : run.equations.relaxation_times())
      {
        run.equations.relaxing_stiffness(at_rest, results, time, matrix);
        relaxing.emplace_back(time, period_matrix(matrix));
      }
    // At the angular frequency 1 dashpots have their coefficient, to which
    // Maxwell elements add.
    TangentMatrix real(run.equations.pattern());
    run.equations.dynamic_stiffness(at_rest, results, {0., 1.}, real, matrix);
    damping = period_matrix(matrix);
    for (const auto &[time, elements] : relaxing)
      damping.add_multiple(-time / (1 + time * time), elements);

    const std::vector<double> masses      = mass.diagonal(),
                              stiffnesses = stiffness.diagonal();
    // A typical squared frequency: it separates the lowest from zero.
    double least = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < unknowns.size(); ++i)
      {
        if (!(masses[i] > 0))
          throw InputError(
            "Analysis = dispersion: some motions have no mass. Give all "
            "sections a Density, and joints between massless struts a mass.");
        least = std::min(least, stiffnesses[i] / masses[i]);
      }
    shift   = 1e-4 * least;
    shifted = stiffness;
    shifted.add_multiple(shift, mass);
  }

  RitzPairs BlochWaves::quotients(const WavePhases  &phases,
                                  const unsigned int n) const
  {
    return independent_pairs(mass.at(phases),
                             shifted.at(phases),
                             2 * std::min<unsigned int>(n, mass.size()));
  }

  double BlochWaves::squared_frequency(const double quotient) const
  {
    return std::max(0., 1 / quotient - shift);
  }

  std::vector<double> BlochWaves::frequencies(const WavePhases  &phases,
                                              const unsigned int n) const
  {
    const std::vector<double> values = quotients(phases, 0).values;
    std::vector<double>       result;
    for (unsigned int j = 0; j + 1 < values.size() && result.size() < n; j += 2)
      result.push_back(std::sqrt(squared_frequency(values[j])));
    return result;
  }

  std::vector<BlochWave> BlochWaves::waves(const WavePhases  &phases,
                                           const unsigned int n) const
  {
    const RitzPairs pairs     = quotients(phases, n);
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
    const auto                              mass_now = mass.at(phases);
    std::vector<dealii::FullMatrix<double>> slopes_K, slopes_M;
    const unsigned int                      dimension = lattice.dimension;
    for (unsigned int d = 0; d < dimension; ++d)
      {
        slopes_K.push_back(stiffness.at(phases, d));
        slopes_M.push_back(mass.at(phases, d));
      }
    for (unsigned int i = 0; i < result.size(); ++i)
      {
        if (!is_alone(i))
          continue;
        dealii::Vector<double> x(mass_now.m());
        for (unsigned int k = 0; k < x.size(); ++k)
          x[k] = pairs.coefficients(k, 2 * i);
        const double w = result[i].angular_frequency,
                     m = mass_now.matrix_norm_square(x);
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
