#include <auxfem/algebra/ritz_pairs.h>
#include <auxfem/analysis/small_motions/natural_modes.h>
#include <auxfem/equations/mode_space.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Shifts below the lowest eigenvalue over Vibration::scale(), because K of
     * a free body is singular. The first costs no accuracy; weakly supported
     * rigid parts need a larger one.
     */
    constexpr std::array<double, 4> relative_shifts = {
      {1e-10, 1e-7, 1e-4, 1e-1}};

    /** Eigenvalues below this multiple of the shift count as zero. */
    constexpr double zero_over_shift = 1e-4;

    /** Eigenproblem of a rest state. */
    class Vibration
    {
    public:
      Vibration(TangentSolver      &solver,
                const State        &state,
                const StiffnessPart part)
        : solver(solver)
        , space(solver)
        , equations(solver.equations())
        , layout(equations.unknowns().layout)
        , part(part)
        , start_state(state)
        , end_state(state)
        , evaluation(Evaluation::equilibrium(start_state, end_state))
        , results(equations.make_results())
        , mass(equations.pattern())
        , stiffness(equations.pattern())
      {
        solver.residual(evaluation, results);
        equations.tangent(evaluation, results, {0, 0, 1}, mass);
        equations.tangent(evaluation, results, {1, 0, 0}, stiffness);
        if (part == StiffnessPart::symmetric)
          stiffness.symmetrize_blocks();
        else if (!stiffness.is_symmetric())
          throw InputError(
            "The stiffness is not symmetric, since loads follow their joints, "
            "so there are no natural modes: set Direction = fixed, or leave "
            "these loads out.");
      }

      /** Factorizes K - sigma M in the solver. Returns false if that fails. */
      bool factorize(const double shift)
      {
        solver.assemble(evaluation, results, {1, 0, -shift});
        if (part == StiffnessPart::symmetric)
          solver.matrix().symmetrize_blocks();
        return solver.factorize();
      }

      /** Number of eigenvalues below the shift of factorize(). */
      std::optional<unsigned long> n_below()
      {
        return space.n_negative();
      }

      /** Eigenpairs nearest to the shift of factorize(). */
      Eigenpairs nearest(const double shift, const unsigned int n)
      {
        return nearest_eigenpairs(problem(shift), n);
      }

      /**
       * Sorted eigenvalues of shapes near those of @p base; requires
       * factorize() with their shift.
       */
      std::vector<double>
      improved_eigenvalues(const std::vector<Vector> &shapes,
                           const NaturalModes        &base)
      {
        const auto products = iterated_products(problem(base.shift), shapes);
        if (!products)
          return {};
        std::vector<double> values =
          ritz_values(products->by_stiffness, products->by_mass);
        std::reverse(values.begin(), values.end());
        for (double &value : values)
          {
            value += base.shift;
            if (std::abs(value) <= zero_over_shift * -base.shift)
              value = 0;
          }
        return values;
      }

      /** Upper bound of the number of finite eigenvalues. Collective. */
      unsigned int n_with_mass() const
      {
        const std::vector<double> masses = mass.diagonal();
        double                    n      = 0;
        for (unsigned int i = 0; i < masses.size(); ++i)
          if (space.is_free(i) && masses[i] > 0)
            ++n;
        return std::min<unsigned int>(space.n_free(), layout.sum(n));
      }

      /**
       * Scale of eigenvalues (1/s2): the largest K_ii / M_ii. If no row has
       * both, the largest stiffness over the largest mass; 1 without stiffness.
       * Collective.
       */
      double scale() const
      {
        const std::vector<double> masses  = mass.diagonal(),
                                  springs = stiffness.diagonal();
        double ratio = 0, largest_spring = 0, largest_mass = 0;
        for (const int i : solver.model().rows.free_translations)
          {
            largest_spring = std::max(largest_spring, springs[i]);
            largest_mass   = std::max(largest_mass, masses[i]);
            if (masses[i] > 0)
              ratio = std::max(ratio, springs[i] / masses[i]);
          }
        ratio          = layout.largest(ratio);
        largest_spring = layout.largest(largest_spring);
        largest_mass   = layout.largest(largest_mass);
        return ratio > 0                      ? ratio
          : largest_spring * largest_mass > 0 ? largest_spring / largest_mass
                                              : 1.;
      }

      NaturalMode mode(const Eigenpair &pair, const double shift) const
      {
        NaturalMode         mode{0., 0., space.shape(pair.vector), {}};
        std::vector<double> forces(layout.n_owned()), inertia(layout.n_owned());
        stiffness.multiply(mode.shape.data(), forces.data());
        space.multiply(mass, mode.shape.data(), inertia.data());
        // The error of the Rayleigh quotient is only quadratic in that of the
        // shape.
        double energy = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          energy += mode.shape[i] * forces[i];
        mode.eigenvalue = layout.sum(energy);
        if (std::abs(mode.eigenvalue) <= zero_over_shift * -shift)
          mode.eigenvalue = 0;
        double squared_residual = 0, squared_norm = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          if (!space.is_prescribed(i))
            {
              squared_residual +=
                std::pow(forces[i] - mode.eigenvalue * inertia[i], 2);
              squared_norm +=
                std::pow((mode.eigenvalue - shift) * inertia[i], 2);
            }
        mode.residual =
          std::sqrt(layout.sum(squared_residual) / layout.sum(squared_norm));
        for (unsigned int d = 0; d < 3; ++d)
          mode.participation[d] = participation(mode.shape, d);
        return mode;
      }

    private:
      ShiftedEigenproblem problem(const double shift)
      {
        return {layout,
                shift,
                [this](const double *x, double *y) {
                  space.multiply(mass, x, y);
                },
                [this](double *x) { return space.solve(x); },
                n_with_mass()};
      }

      /** x.M r in free rows. Collective. */
      double participation(const Vector &shape, const unsigned int d) const
      {
        const Vector        along = translation(d);
        std::vector<double> inertia(layout.n_owned());
        mass.multiply(along.data(), inertia.data());
        double sum = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          if (space.is_free(i))
            sum += shape[i] * inertia[i];
        return layout.sum(sum);
      }

      /** Unit translation of all local unknowns, including supports.
       */
      Vector translation(const unsigned int d) const
      {
        const DofNumbering &numbering = solver.model().numbering;
        const Unknowns     &unknowns  = equations.unknowns();
        Vector              values(layout.n_local(), 0.);
        for (unsigned int i = 0; i < values.size(); ++i)
          if (!unknowns.strut[i] && unknowns.component[i] == d &&
              unknowns.kinds[i] != UnknownKind::multiplier)
            values[i] = 1;
        if (d < solver.model().lattice.dimension)
          for (unsigned int e = 0; e < numbering.elements().size(); ++e)
            for (unsigned int a = 0; a <= numbering.elements()[e].order; ++a)
              values[numbering.element_unknowns(
                e)[a * numbering.n_components() + d]] = 1;
        layout.update_ghosts(values.data());
        return values;
      }

      TangentSolver       &solver;
      ModeSpace            space;
      const Equations     &equations;
      const UnknownLayout &layout;
      const StiffnessPart  part;
      const State          start_state;
      State                end_state;
      const Evaluation     evaluation;
      EvaluationResults    results;
      TangentMatrix        mass, stiffness;
    };

    [[noreturn]] void throw_modes_error(const std::string &why)
    {
      throw ComputationError("Analysis = modes: " + why + '.');
    }

    /**
     * Whether the number of eigenvalues between the shift and the widest gap
     * among the last pairs equals the number found.
     * @param n minimum number of pairs before the gap
     * @param n_below_shift number of all eigenvalues below the shift
     */
    bool are_all_found(Vibration                    &vibration,
                       const std::vector<Eigenpair> &pairs,
                       const unsigned int            n,
                       const double                  shift,
                       const unsigned long           n_below_shift)
    {
      const unsigned int counted = count_before_widest_gap(pairs, n, shift);
      const double       limit =
        (pairs[counted - 1].value + pairs[counted].value) / 2;
      if (!vibration.factorize(limit))
        return false;
      const auto n_all = vibration.n_below();
      return n_all && *n_all - n_below_shift == counted - n_below(pairs, shift);
    }

    /** Factorizes with the smallest possible shift and returns it. */
    double factorized_shift(Vibration &vibration, const TangentSolver &solver)
    {
      const double scale = vibration.scale();
      for (const double relative : relative_shifts)
        if (vibration.factorize(-relative * scale))
          return -relative * scale;
      throw_modes_error("the stiffness cannot be factorized: " +
                        solver.last_failure());
    }
  } // namespace

  bool has_natural_modes(TangentSolver &solver, const State &state)
  {
    const Equations  &equations  = solver.equations();
    State             end_state  = state;
    const Evaluation  evaluation = Evaluation::equilibrium(state, end_state);
    EvaluationResults results    = equations.make_results();
    TangentMatrix     stiffness(equations.pattern());
    solver.residual(evaluation, results);
    equations.tangent(evaluation, results, {1, 0, 0}, stiffness);
    return stiffness.is_symmetric();
  }

  NaturalModes natural_modes(TangentSolver      &solver,
                             const State        &state,
                             const unsigned int  n,
                             const StiffnessPart part)
  {
    Vibration          vibration(solver, state, part);
    const unsigned int n_with_mass = vibration.n_with_mass(),
                       n_requested = std::min(n, n_with_mass);
    if (n_with_mass == 0)
      throw_modes_error("nothing that can move has a mass");
    NaturalModes found;
    found.shift = factorized_shift(vibration, solver);
    for (unsigned int attempt = 0; attempt < n_attempts_to_find_all; ++attempt)
      {
        if (attempt > 0 && !vibration.factorize(found.shift))
          throw_modes_error(solver.last_failure());
        const auto         n_below_shift = vibration.n_below();
        const unsigned int n_computed =
          std::min((n_requested << attempt) + n_guard_modes, n_with_mass);
        const Eigenpairs near = vibration.nearest(found.shift, n_computed);
        if (near.pairs.empty() || !near.failure_reason.empty())
          throw_modes_error(near.failure_reason.empty() ? "no motion has a mass"
                                                        : near.failure_reason);
        const unsigned int n_modes =
          std::min<std::size_t>(n_requested, near.pairs.size());
        // A complete set needs no count and may have no gap.
        const bool are_all = near.pairs.size() == n_with_mass,
                   can_count =
                     !are_all && n_below_shift && n_modes < near.pairs.size();
        found.count_differs = can_count &&
          !are_all_found(vibration,
                         near.pairs,
                         n_modes,
                         found.shift,
                         *n_below_shift);
        if (found.count_differs && attempt + 1 < n_attempts_to_find_all)
          continue;
        found.is_counted =
          !found.count_differs && (can_count || n_computed == n_with_mass);
        for (unsigned int i = 0; i < n_modes; ++i)
          found.modes.push_back(vibration.mode(near.pairs[i], found.shift));
        found.n_possible = n_with_mass;
        if (n_below_shift)
          found.n_further_negative = *n_below_shift -
            std::min(*n_below_shift, n_below(near.pairs, found.shift));
        break;
      }
    return found;
  }

  FinerValues nearby_eigenvalues(TangentSolver             &solver,
                                 const State               &state,
                                 const NaturalModes        &base,
                                 const std::vector<Vector> &shapes)
  {
    Vibration   vibration(solver, state, StiffnessPart::whole);
    FinerValues found;
    found.n_possible = vibration.n_with_mass();
    if (!vibration.factorize(base.shift))
      throw_modes_error(solver.last_failure());
    found.values           = vibration.improved_eigenvalues(shapes, base);
    const CountLimit known = limit_below_last(found.values, base.shift);
    if (base.is_counted && known.limit > base.shift &&
        vibration.factorize(known.limit))
      if (const auto n = vibration.n_below();
          n && *n > known.n_below + base.n_further_negative)
        found.n_missing = *n - known.n_below - base.n_further_negative;
    return found;
  }
} // namespace auxfem
