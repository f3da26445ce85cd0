#include <auxfem/time/schemes/step_control.h>
#include <auxfem/time/stages.h>

#include <set>

namespace auxfem
{
  namespace
  {
    /** Large rotations in space that no support prescribes as a whole. */
    std::vector<unsigned int> free_large_rotations(const LatticeModel &model)
    {
      std::set<unsigned int> known;
      for (const Support &support : model.supports)
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          if (prescribed.is_whole())
            known.insert(prescribed.rotation);
      std::vector<unsigned int> result;
      for (unsigned int i = 0; i < model.n_large_rotations(); ++i)
        if (known.count(i) == 0)
          result.push_back(i);
      return result;
    }
  } // namespace

  /** The scheme's own rule, applied to the vectors of rotations in space. */
  class Stages::Rule : public ImplicitScheme
  {
  public:
    Rule(const LatticeModel   &model,
         const ImplicitScheme &scheme,
         const Vector         &base,
         Vector               &vectors)
      : ImplicitScheme(scheme.name())
      , rotations(model.numbering)
      , free_rotations(free_large_rotations(model))
      , scheme(scheme)
      , base(base)
      , vectors(vectors)
    {}

    void predict(const State &from, const double dt, State &to) const override
    {
      scheme.predict(from, dt, to);
      const Evaluation stage = Evaluation::stage(from, to, dt, /*weight=*/0);
      for (const unsigned int i : free_rotations)
        {
          const SpaceVector at_base = rotations.values(base, i);
          const SpaceVector vector  = at_base +
            dt * inverse_tangent_operator(at_base) *
              rotations.values(*to.velocity, i);
          rotations.set_values(vector, i, vectors);
          rotations.set_material_increment(stage, i, vector);
          find_rates(stage, i);
        }
    }

    TangentFactors factors(const State &from, const double dt) const override
    {
      return scheme.factors(from, dt);
    }

    void correct(const State  &from,
                 const Vector &increment,
                 const double  dt,
                 State        &trial) const override
    {
      scheme.correct(from, increment, dt, trial);
      const Evaluation stage = Evaluation::stage(from, trial, dt, /*weight=*/0);
      for (const unsigned int i : free_rotations)
        {
          rotations.set_values(rotations.values(vectors, i) +
                                 rotations.values(increment, i),
                               i,
                               vectors);
          find_rates(stage, i);
        }
    }

  private:
    /** Rates of rotation @p i from its vector. */
    void find_rates(const Evaluation &stage, const unsigned int i) const
    {
      const SpaceVector vector = rotations.values(vectors, i);
      const SpaceVector velocity =
        angular_motion(vector,
                       (vector - rotations.values(base, i)) / stage.dt,
                       SpaceVector())
          .velocity;
      rotations.set_values(velocity, i, *stage.to.velocity);
      rotations.set_values(
        (velocity - rotations.values(*stage.from.velocity, i)) / stage.dt,
        i,
        *stage.to.acceleration);
    }

    const NodeRotations             rotations;
    const std::vector<unsigned int> free_rotations;
    const ImplicitScheme           &scheme;
    /**
     * Rotation vectors since the start of the step, at the base and now. Their
     * increments are divided by dt^2, so they must not be lost in the sum over
     * all steps, State::displacement.
     */
    const Vector &base;
    Vector       &vectors;
  };

  Stages::Stages(const Equations &equations, const ImplicitScheme &scheme)
    : equations(equations)
    , tableau(*scheme.stages())
    , rotations(equations.model().numbering)
    , multipliers(equations.model().numbering.constraints().multipliers())
    , base(equations.initial_state())
    , base_displacement(base.displacement)
    , rotation_vectors(base.displacement)
    , stage_rule(std::make_unique<Rule>(equations.model(),
                                        scheme,
                                        base_displacement,
                                        rotation_vectors))
    , slopes(tableau.n_stages())
    , kinetic_defect_terms(tableau.n_stages())
  {}

  Stages::~Stages() = default;

  unsigned int Stages::n() const
  {
    return tableau.n_stages();
  }

  const ImplicitScheme &Stages::rule() const
  {
    return *stage_rule;
  }

  void Stages::begin(const Evaluation &step, const EvaluationResults &at_start)
  {
    dt        = step.dt;
    end       = step.to.time;
    stage     = 0;
    step.to   = step.from;
    base      = step.from;
    slopes[0] = {*step.from.velocity,
                 *step.from.acceleration,
                 equations.find_internal_rates(step.from, at_start)};
    Evaluation start =
      Evaluation::stage(base, step.to, /*dt=*/0, tableau.weights[0] * dt);
    if (step.event_at_from)
      start.event_at_to = {*step.event_at_from, TimeSide::after};
    equations.account_stage(start, at_start);
    base.history     = step.to.history;
    base.energy_sums = step.to.energy_sums;
  }

  Evaluation Stages::next(const Evaluation &step)
  {
    ++stage;
    const double part = tableau.times[stage];
    step.to.time      = part == 1 ? end : step.from.time + part * dt;
    set_base(step);
    Evaluation next = Evaluation::stage(base,
                                        step.to,
                                        tableau.diagonal * dt,
                                        tableau.weights[stage] * dt);
    if (part == 1)
      next.event_at_to = step.event_at_to;
    if (stage + 1 == n())
      {
        next.ends_step            = true;
        next.kinetic_defect_terms = &kinetic_defect_terms;
      }
    return next;
  }

  void Stages::set_base(const Evaluation &step)
  {
    const State &from  = step.from;
    base_displacement  = from.displacement;
    *base.velocity     = *from.velocity;
    base.largest_force = step.to.largest_force;
    for (unsigned int i = 0; i < from.rotations.size(); ++i)
      rotations.set_values(SpaceVector(), i, base_displacement);
    for (const auto &[first, last] : equations.layout().integrated)
      std::copy(from.history.begin() + first,
                from.history.begin() + last,
                base.history.begin() + first);
    for (unsigned int j = 0; j < stage; ++j)
      {
        const double factor = tableau.factors[stage][j] * dt;
        add_multiple(factor, slopes[j].displacement, base_displacement);
        add_multiple(factor, slopes[j].velocity, *base.velocity);
        for (const auto &[first, last] : equations.layout().integrated)
          for (std::size_t i = first; i < last; ++i)
            base.history[i] += factor * slopes[j].internal[i];
      }
    // Multipliers have no rates; their last values are the best predictor.
    for (const int i : multipliers)
      base_displacement[i] = step.to.displacement[i];
    base.displacement = base_displacement;
    for (unsigned int i = 0; i < from.rotations.size(); ++i)
      rotations.set_values(rotations.values(from.displacement, i),
                           i,
                           base.displacement);
    guess_acceleration();
  }

  void Stages::guess_acceleration()
  {
    std::vector<double>         times;
    std::vector<const Vector *> values;
    for (unsigned int j = 0; j < stage; ++j)
      {
        times.push_back(tableau.times[j] * dt);
        values.push_back(&slopes[j].velocity);
      }
    // The last stage of the previous step is the start of this one.
    for (unsigned int j = 0; j + 1 < before.size(); ++j)
      {
        times.push_back((tableau.times[j] - 1) * dt_before);
        values.push_back(&before[j]);
      }
    base.acceleration->assign(base.acceleration->size(), 0.);
    for (const auto &[point, weight] :
         extrapolation(times, tableau.times[stage] * dt))
      add_multiple(weight, *values[point], *base.acceleration);
  }

  void Stages::find_slopes(const Evaluation &solved)
  {
    Slopes &now      = slopes[stage];
    now.displacement = *solved.to.velocity;
    now.velocity     = *solved.to.acceleration;
    for (unsigned int i = 0; i < solved.to.rotations.size(); ++i)
      rotations.set_values(inverse_tangent_operator(
                             rotations.material_increment(solved, i)) *
                             rotations.values(*solved.to.velocity, i),
                           i,
                           now.displacement);
    for (const int i : multipliers)
      now.displacement[i] = now.velocity[i] = 0;
    now.internal.resize(solved.to.history.size());
    for (const auto &[first, last] : equations.layout().integrated)
      for (std::size_t i = first; i < last; ++i)
        now.internal[i] = (solved.to.history[i] - base.history[i]) / solved.dt;
  }

  void Stages::solved(const Evaluation        &solved,
                      const EvaluationResults &results)
  {
    find_slopes(solved);
    if (stage + 1 == n())
      {
        find_kinetic_energy_defect();
        return;
      }
    if (solved.weight != 0)
      equations.account_stage(solved, results);
    base.history     = solved.to.history;
    base.energy_sums = solved.to.energy_sums;
  }

  void Stages::find_kinetic_energy_defect()
  {
    for (unsigned int i = 0; i < n(); ++i)
      {
        auto &[first, second] = kinetic_defect_terms[i];
        first                 = slopes[i].velocity;
        second.assign(first.size(), 0.);
        for (unsigned int j = 0; j < n(); ++j)
          add_multiple(dt * dt / 2 * tableau.missed_growth(i, j),
                       slopes[j].velocity,
                       second);
      }
  }

  void Stages::accept()
  {
    before.resize(n());
    for (unsigned int j = 0; j < n(); ++j)
      std::swap(before[j], slopes[j].velocity);
    dt_before = dt;
  }

  Stages::Difference Stages::embedded_difference() const
  {
    const Vector zero(base.displacement.size(), 0.);
    Difference   difference{zero, zero};
    for (unsigned int j = 0; j < n(); ++j)
      {
        const double factor = tableau.embedded_difference[j] * dt;
        add_multiple(factor, slopes[j].displacement, difference.displacement);
        add_multiple(factor, slopes[j].velocity, difference.velocity);
      }
    return difference;
  }
} // namespace auxfem
