#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/time/dense_output.h>

#include <algorithm>
#include <array>

namespace auxfem
{
  namespace
  {
    /** A value with its first two derivatives by time. */
    template <class Value>
    struct Motion
    {
      Value value, first, second;
    };

    /** Hermite polynomials of a step, at one time in it. */
    class QuinticHermite
    {
    public:
      /**
       * @param dt length of the step (s)
       * @param part elapsed part of it
       */
      QuinticHermite(const double dt, const double part) : dt(dt)
      {
        for (unsigned int i = 0; i < weights.size(); ++i)
          weights[i] = at(coefficients[i], part);
      }

      /** From 0 with the rates of @p start to the values of @p end. */
      template <class Value>
      Motion<Value> operator()(const Motion<Value> &start,
                               const Motion<Value> &end) const
      {
        const auto sum = [&](double Motion<double>::*derivative) {
          const auto weight = [&](const unsigned int i) {
            return weights[i].*derivative;
          };
          return weight(0) * end.value + weight(1) * dt * start.first +
            weight(2) * dt * end.first + weight(3) * dt * dt * start.second +
            weight(4) * dt * dt * end.second;
        };
        return {sum(&Motion<double>::value),
                sum(&Motion<double>::first) / dt,
                sum(&Motion<double>::second) / (dt * dt)};
      }

    private:
      /** Coefficients in ascending order. */
      using Polynomial = std::array<double, 6>;

      static Motion<double> at(const Polynomial &polynomial, const double s)
      {
        Motion<double> sum{0, 0, 0};
        for (unsigned int i = polynomial.size(); i-- > 0;)
          sum = {sum.value * s + polynomial[i],
                 sum.first * s + sum.value,
                 sum.second * s + 2 * sum.first};
        return sum;
      }

      static constexpr std::array<Polynomial, 5> coefficients = {
        {{0, 0, 0, 10, -15, 6},
         {0, 1, 0, -6, 8, -3},
         {0, 0, 0, -4, 7, -3},
         {0, 0, 0.5, -1.5, 1.5, -0.5},
         {0, 0, 0, 0.5, -1, 0.5}}};

      const double                  dt;
      std::array<Motion<double>, 5> weights;
    };

    /** The start of a step where functions of time jump. */
    std::optional<TimeLimit> after(const std::optional<double> event)
    {
      if (!event)
        return {};
      return TimeLimit{*event, TimeSide::after};
    }

    double part_of(const Evaluation &between, const State &end)
    {
      return between.dt / (end.time - between.from.time);
    }

    /** @p one + part * (other - one). */
    double chord(const double one, const double other, const double part)
    {
      return one + part * (other - one);
    }

    template <class Values>
    void chords(const Values &one,
                const Values &other,
                const double  part,
                Values       &to)
    {
      for (std::size_t i = 0; i < one.size(); ++i)
        to[i] = chord(one[i], other[i], part);
    }

    /**
     * Cubic Hermite polynomials through @p one and @p other, @p dt (s) apart.
     */
    void cubics(const std::vector<double> &one,
                const std::vector<double> &one_rate,
                const std::vector<double> &other,
                const std::vector<double> &other_rate,
                const double               dt,
                const double               s,
                std::vector<double>       &to)
    {
      for (std::size_t i = 0; i < one.size(); ++i)
        to[i] = one[i] + s * s * (3 - 2 * s) * (other[i] - one[i]) +
          dt * s * (1 - s) * ((1 - s) * one_rate[i] - s * other_rate[i]);
    }
  } // namespace

  DenseOutput::DenseOutput(const Equations      &equations,
                           const ImplicitScheme &scheme)
    : equations(equations)
    , rotations(equations.model().numbering)
    , has_stages(scheme.stages() != nullptr)
  {}

  void DenseOutput::record(const Solution                &from,
                           const Solution                &to,
                           const std::optional<double>    event_at_from,
                           const std::optional<TimeLimit> event_at_to,
                           const double                   nearness,
                           TangentSolver                 &solver,
                           Recorder                      &recorder) const
  {
    const double            begin = from.state.time, end = to.state.time;
    std::optional<double>   next = recorder.next_time(begin + nearness);
    std::optional<EndRates> end_rates;
    std::optional<Solution> start;
    for (; next && *next < end - nearness;
         next = recorder.next_time(*next + nearness))
      {
        if (has_stages && !end_rates)
          end_rates = {rates(from, after(event_at_from)),
                       rates(to, event_at_to)};
        Solution between{from.state, equations.make_results()};
        between.state.time = *next;
        Evaluation partial_step =
          Evaluation::step(from.state, between.state, *next - begin);
        partial_step.event_at_from = event_at_from;
        interpolate_motion(partial_step, to.state);
        interpolate_integrals(from.state,
                              to.state,
                              end_rates ? &*end_rates : nullptr,
                              between.state);
        const State      before = between.state;
        const Evaluation instant =
          Evaluation::consistent_rates(before, between.state);
        solver.residual(instant, between.results);
        equations.accept(instant, between.results);
        if (!is_equilibrium(from, to, between))
          {
            if (!start)
              start.emplace(evaluate_start(from, solver));
            interpolate_forces(*start, to, between);
          }
        recorder.row(between);
      }
    if (next && *next <= end + nearness)
      recorder.row(to);
  }

  Solution DenseOutput::evaluate_start(const Solution &start,
                                       TangentSolver  &solver) const
  {
    Solution instant{start.state, equations.make_results()};
    State    evaluated = start.state;
    solver.residual(Evaluation::consistent_rates(start.state, evaluated),
                    instant.results);
    return instant;
  }

  DenseOutput::Rates
  DenseOutput::rates(const Solution                &end,
                     const std::optional<TimeLimit> event) const
  {
    constexpr double one_second = 1;
    State            after      = end.state;
    Evaluation       instant =
      Evaluation::stage(end.state, after, /*dt=*/0, one_second);
    instant.event_at_to = event;
    equations.account_stage(instant, end.results);
    Rates rates{equations.find_internal_rates(end.state, end.results),
                after.energy_sums};
    for (std::size_t i = 0; i < rates.history.size(); ++i)
      rates.history[i] += after.history[i] - end.state.history[i];
    for (std::size_t i = 0; i < rates.energy_sums.size(); ++i)
      rates.energy_sums[i] -= end.state.energy_sums[i];
    return rates;
  }

  bool DenseOutput::is_equilibrium(const Solution &from,
                                   const Solution &to,
                                   const Solution &between) const
  {
    const EvaluationResults &results = between.results;
    const double moment = results.moment / equations.model().mean_strut_length;
    return between.state.acceleration &&
      std::max(results.force, moment) <= noticeable_fraction *
        std::max(from.results.force_scale, to.results.force_scale);
  }

  void DenseOutput::interpolate_forces(const Solution &from,
                                       const Solution &to,
                                       Solution       &between) const
  {
    State       &state = between.state;
    const double part =
      (state.time - from.state.time) / (to.state.time - from.state.time);
    chords(from.state.residual, to.state.residual, part, state.residual);
    chords(from.state.energies.amounts(),
           to.state.energies.amounts(),
           part,
           state.energies.amounts());
    between.forces_within = {&from, &to, part};
  }

  void DenseOutput::interpolate_motion(const Evaluation &between,
                                       const State      &end) const
  {
    const State &start = between.from;
    State       &now   = between.to;
    const double part  = part_of(between, end);
    if (!now.acceleration)
      {
        chords(start.displacement, end.displacement, part, now.displacement);
        if (now.velocity)
          chords(*start.velocity, *end.velocity, part, *now.velocity);
        rotations.follow(between);
        return;
      }
    const QuinticHermite polynomials(between.dt / part, part);
    for (std::size_t i = 0; i < now.displacement.size(); ++i)
      {
        const Motion<double> motion = polynomials(
          Motion<double>{0, (*start.velocity)[i], (*start.acceleration)[i]},
          Motion<double>{end.displacement[i] - start.displacement[i],
                         (*end.velocity)[i],
                         (*end.acceleration)[i]});
        now.displacement[i]    = start.displacement[i] + motion.value;
        (*now.velocity)[i]     = motion.first;
        (*now.acceleration)[i] = motion.second;
      }
    for (const int i : equations.model().numbering.constraints().multipliers())
      now.displacement[i] =
        chord(start.displacement[i], end.displacement[i], part);
    interpolate_rotations(between, end);
    prescribe_motion(equations.model(), between);
  }

  void DenseOutput::interpolate_rotations(const Evaluation &between,
                                          const State      &end) const
  {
    const State         &start = between.from;
    const double         part  = part_of(between, end);
    const QuinticHermite polynomials(between.dt / part, part);
    const auto value = [this](const Vector &vector, const unsigned int i) {
      return rotations.values(vector, i);
    };
    for (unsigned int i = 0; i < start.rotations.size(); ++i)
      {
        // W = T phi', W' = T phi'' + T' phi' at the end; T = 1 at the start.
        const SpaceVector vector =
          value(end.displacement, i) - value(start.displacement, i);
        const SpaceTensor inverse = inverse_tangent_operator(vector);
        const SpaceVector rate    = inverse * value(*end.velocity, i);
        const SpaceVector from_rate =
          angular_motion(vector, rate, SpaceVector()).acceleration;
        const Motion<SpaceVector> motion =
          polynomials(Motion<SpaceVector>{SpaceVector(),
                                          value(*start.velocity, i),
                                          value(*start.acceleration, i)},
                      Motion<SpaceVector>{
                        vector,
                        rate,
                        inverse * (value(*end.acceleration, i) - from_rate)});
        const AngularMotion angular =
          angular_motion(motion.value, motion.first, motion.second);
        rotations.set_material_increment(between, i, motion.value);
        rotations.set_values(angular.velocity, i, *between.to.velocity);
        rotations.set_values(angular.acceleration, i, *between.to.acceleration);
      }
    rotations.follow(between);
  }

  void DenseOutput::interpolate_integrals(const State    &from,
                                          const State    &to,
                                          const EndRates *rates,
                                          State          &between) const
  {
    const double dt   = to.time - from.time,
                 part = (between.time - from.time) / dt;
    if (rates == nullptr)
      {
        chords(from.history, to.history, part, between.history);
        chords(from.energy_sums, to.energy_sums, part, between.energy_sums);
        return;
      }
    cubics(from.history,
           rates->from.history,
           to.history,
           rates->to.history,
           dt,
           part,
           between.history);
    cubics(from.energy_sums,
           rates->from.energy_sums,
           to.energy_sums,
           rates->to.energy_sums,
           dt,
           part,
           between.energy_sums);
  }
} // namespace auxfem
