#include <auxfem/algebra/eigen_solver.h>
#include <auxfem/analysis/natural_modes.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Shifts below the lowest eigenvalue, over
     * Vibration::scale(): of what
     * flies freely K itself is singular. The first is so small that it costs no
     * digits; rigid parts that hardly anything holds need a larger one.
     */
    constexpr std::array<double, 4> relative_shifts = {
      {1e-10, 1e-7, 1e-4, 1e-1}};

    /** Of eigenvalues, over the shift; what lies below has no stiffness. */
    constexpr double round_off = 1e-4;

    /** Round-off of a symmetric matrix, see TangentMatrix::asymmetry(). */
    constexpr double symmetric = 1e-10;

    /** Further modes, between which a gap is looked for to count them. */
    constexpr unsigned int n_guards = 4;

    /** Each time with twice as many. */
    constexpr unsigned int n_attempts = 4;

    /** Matrices of a state at rest, and what is done with them. */
    class Vibration
    {
    public:
      Vibration(TangentSolver &solver, const State &state)
        : solver(solver)
        , equations(solver.equations())
        , layout(equations.unknowns().layout)
        , at_rest(state)
        , now(state)
        , evaluation(Evaluation::equilibrium(at_rest, now))
        , results(equations.make_results())
        , mass(equations.pattern())
        , stiffness(equations.pattern())
      {
        solver.residual(evaluation, results);
        equations.tangent(evaluation, results, {0, 0, 1}, mass);
        equations.tangent(evaluation, results, {1, 0, 0}, stiffness);
        if (stiffness.asymmetry() > symmetric)
          throw InputError(
            "Analysis = modes: the stiffness is not symmetric, since loads "
            "follow their joints. Natural modes are computed for loads that "
            "keep their directions: set Direction = fixed, or leave these loads "
            "out.");
      }

      /** K - sigma M becomes the matrix of the solver. Returns whether it can
       * be factorized. */
      bool factorize(const double shift)
      {
        solver.assemble(evaluation, results, {1, 0, -shift});
        return solver.factorize();
      }

      /** Eigenvalues below the shift of factorize(). */
      std::optional<unsigned long> n_below()
      {
        const std::optional<Inertia> inertia = solver.new_inertia();
        if (!inertia)
          return std::nullopt;
        const unsigned long of_constraints =
          solver.model().numbering.constraints().n_multipliers();
        return inertia->negative - std::min(inertia->negative, of_constraints);
      }

      /** Those nearest to the shift of factorize(). */
      Eigenpairs nearest(const double shift, const unsigned int n)
      {
        const ShiftedEigenproblem problem = {
          layout,
          shift,
          [this](const double *x, double *y) { multiply_mass(x, y); },
          [this](double *x) { return solve(x); },
          n_with_mass()};
        return nearest_eigenpairs(problem, n);
      }

      /** How many finite eigenvalues there are, at most. Collective. */
      unsigned int n_with_mass() const
      {
        const std::vector<double> masses = mass.diagonal();
        std::vector<double>       n      = {0., 0.};
        for (unsigned int i = 0; i < masses.size(); ++i)
          if (is_free(i))
            {
              ++n[0];
              if (masses[i] > 0)
                ++n[1];
            }
        n = layout.sum(n);
        const unsigned long n_constraints =
          solver.model().numbering.constraints().n_multipliers();
        return std::max(0., std::min(n[0] - n_constraints, n[1]));
      }

      /**
       * Size of eigenvalues (1/s2): the largest K_ii / M_ii, where no row has
       * both the largest entry over the largest mass; 1 without stiffness.
       * Collective.
       */
      double scale() const
      {
        const std::vector<double> masses  = mass.diagonal(),
                                  springs = stiffness.diagonal();
        double ratio = 0, spring = 0, of_masses = 0;
        for (const int i : solver.model().rows.free_translations)
          {
            spring    = std::max(spring, springs[i]);
            of_masses = std::max(of_masses, masses[i]);
            if (masses[i] > 0)
              ratio = std::max(ratio, springs[i] / masses[i]);
          }
        ratio     = layout.largest(ratio);
        spring    = layout.largest(spring);
        of_masses = layout.largest(of_masses);
        return ratio > 0           ? ratio
          : spring * of_masses > 0 ? spring / of_masses
                                   : 1.;
      }

      NaturalMode mode(const Eigenpair &pair, const double shift) const
      {
        NaturalMode mode{0., 0., Vector(layout.n_local(), 0.), {}};
        std::copy(pair.vector.begin(), pair.vector.end(), mode.shape.begin());
        layout.update_ghosts(mode.shape.data());
        turn_up(mode.shape);
        std::vector<double> forces(layout.n_owned()), inertia(layout.n_owned());
        stiffness.multiply(mode.shape.data(), forces.data());
        multiply_mass(mode.shape.data(), inertia.data());
        // Rayleigh's quotient: the solution has lost digits, which count twice.
        double energy = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          energy += mode.shape[i] * forces[i];
        mode.eigenvalue = layout.sum(energy);
        if (std::abs(mode.eigenvalue) <= round_off * -shift)
          mode.eigenvalue = 0;
        double left = 0, all = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          if (!is_prescribed(i))
            {
              left += std::pow(forces[i] - mode.eigenvalue * inertia[i], 2);
              all += std::pow((mode.eigenvalue - shift) * inertia[i], 2);
            }
        mode.residual = std::sqrt(layout.sum(left) / layout.sum(all));
        for (unsigned int d = 0; d < 3; ++d)
          mode.participation[d] = participation(mode.shape, d);
        return mode;
      }

    private:
      bool is_prescribed(const unsigned int i) const
      {
        return equations.unknowns().kinds[i] == UnknownKind::prescribed;
      }

      bool is_free(const unsigned int i) const
      {
        return !is_prescribed(i) &&
          equations.unknowns().kinds[i] != UnknownKind::multiplier;
      }

      /** @p y = M x of owned rows: without the rows and columns of constraints,
       * which every tangent has, and of what is prescribed. */
      void multiply_mass(const double *x, double *y) const
      {
        Vector all(layout.n_local(), 0.);
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          if (is_free(i))
            all[i] = x[i];
        layout.update_ghosts(all.data());
        mass.multiply(all.data(), y);
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          if (!is_free(i))
            y[i] = 0;
      }

      bool solve(double *x)
      {
        Vector values(layout.n_local(), 0.);
        std::copy_n(x, layout.n_owned(), values.begin());
        if (!solver.solve(values))
          return false;
        std::copy_n(values.begin(), layout.n_owned(), x);
        return true;
      }

      /** The largest entry becomes positive, of equal ones the first. */
      void turn_up(Vector &shape) const
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
        const double of_all = layout.largest(first);
        double       sign   = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          if (1. + layout.n_global() - layout.global(i) == of_all)
            sign = shape[i] < 0 ? -1 : 1;
        sign = layout.sum(sign);
        for (double &value : shape)
          value *= sign;
      }

      /** x.M r in free rows. Collective. */
      double participation(const Vector &shape, const unsigned int d) const
      {
        const Vector        along = translation(d);
        std::vector<double> inertia(layout.n_owned());
        mass.multiply(along.data(), inertia.data());
        double sum = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          if (is_free(i))
            sum += shape[i] * inertia[i];
        return layout.sum(sum);
      }

      /** All local unknowns, supports too. */
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
      const Equations     &equations;
      const UnknownLayout &layout;
      const State          at_rest;
      State                now;
      const Evaluation     evaluation;
      EvaluationResults    results;
      TangentMatrix        mass, stiffness;
    };

    /** Of the last pairs, how many lie before the widest gap; at least @p n. */
    unsigned int before_widest_gap(const std::vector<Eigenpair> &pairs,
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

    /** Eigenvalues below @p limit. */
    unsigned long n_below(const std::vector<Eigenpair> &pairs,
                          const double                  limit)
    {
      return std::count_if(pairs.begin(),
                           pairs.end(),
                           [limit](const Eigenpair &pair) {
                             return pair.value < limit;
                           });
    }

    [[noreturn]] void fail(const std::string &why)
    {
      throw ComputationError("Analysis = modes: " + why + '.');
    }

    /** The smallest shift with which a factorization succeeds, that is done. */
    double factorized_shift(Vibration &vibration, const TangentSolver &solver)
    {
      const double scale = vibration.scale();
      for (const double relative : relative_shifts)
        if (vibration.factorize(-relative * scale))
          return -relative * scale;
      fail("the stiffness cannot be factorized: " + solver.why());
    }
  } // namespace

  double NaturalMode::angular_frequency() const
  {
    return eigenvalue > 0 ? std::sqrt(eigenvalue) : 0.;
  }

  double NaturalMode::growth_rate() const
  {
    return eigenvalue < 0 ? std::sqrt(-eigenvalue) : 0.;
  }

  NaturalModes
  natural_modes(TangentSolver &solver, const State &state, const unsigned int n)
  {
    Vibration          vibration(solver, state);
    const unsigned int n_with_mass = vibration.n_with_mass(),
                       wanted      = std::min(n, n_with_mass);
    if (n_with_mass == 0)
      fail("nothing that can move has a mass");
    NaturalModes found;
    found.shift = factorized_shift(vibration, solver);
    for (unsigned int attempt = 0; attempt < n_attempts; ++attempt)
      {
        if (attempt > 0 && !vibration.factorize(found.shift))
          fail(solver.why());
        const auto         n_below_shift = vibration.n_below();
        const unsigned int n_asked =
          std::min((wanted << attempt) + n_guards, n_with_mass);
        const Eigenpairs near = vibration.nearest(found.shift, n_asked);
        if (near.pairs.empty() || !near.why.empty())
          fail(near.why.empty() ? "no motion has a mass" : near.why);
        const unsigned int counted =
          before_widest_gap(near.pairs,
                            std::min<unsigned int>(wanted, near.pairs.size()),
                            found.shift);
        // All there are need no count.
        bool is_complete = true;
        found.is_counted = n_asked == n_with_mass;
        if (n_below_shift && counted < near.pairs.size())
          {
            const double limit =
              (near.pairs[counted - 1].value + near.pairs[counted].value) / 2;
            const auto n_all =
              vibration.factorize(limit) ? vibration.n_below() : std::nullopt;
            is_complete = n_all &&
              *n_all - *n_below_shift ==
                counted - n_below(near.pairs, found.shift);
            found.is_counted = is_complete;
          }
        if (!is_complete)
          continue;
        for (unsigned int i = 0;
             i < std::min<std::size_t>(wanted, near.pairs.size());
             ++i)
          found.modes.push_back(vibration.mode(near.pairs[i], found.shift));
        if (n_below_shift)
          found.n_further_negative =
            *n_below_shift - n_below(near.pairs, found.shift);
        return found;
      }
    fail("the count of modes by the inertia of the stiffness is another than "
         "the number that was found");
  }
} // namespace auxfem
