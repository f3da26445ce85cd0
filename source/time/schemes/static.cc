#include <auxfem/time/schemes/static.h>
#include <auxfem/time/schemes/time_scheme.h>

namespace auxfem
{
  namespace
  {
    const std::string static_name = "static";

    /** Sets @p to to the position of @p from, without motion. */
    void put_at_rest(const State &from, State &to)
    {
      to.displacement = from.displacement;
      if (to.velocity)
        to.velocity->assign(to.velocity->size(), 0.);
      if (to.acceleration)
        to.acceleration->assign(to.acceleration->size(), 0.);
    }

    std::unique_ptr<TimeScheme> make_static(ParameterValues & /*values*/)
    {
      return std::make_unique<QuasiStatic>();
    }
  } // namespace

  BackwardDifference::BackwardDifference(const State &from, const double dt)
    : now(1 / dt)
    , before(0)
  {
    if (!from.before)
      return;
    const double dt_before = from.before->dt;
    const double part      = dt / (dt + dt_before);
    now += part / dt;
    before = part / dt_before;
  }

  QuasiStatic::QuasiStatic() : ImplicitScheme(static_name)
  {}

  void QuasiStatic::predict(const State &from, const double dt, State &to) const
  {
    put_at_rest(from, to);
    if (to.velocity && from.before)
      {
        const double weight = BackwardDifference(from, dt).before;
        add_multiple(-weight, from.displacement, *to.velocity);
        add_multiple(weight, from.before->displacement, *to.velocity);
      }
    to.before = {time_of_loads(from), dt, from.displacement, from.residual};
  }

  TangentFactors QuasiStatic::factors(const State &from, const double dt) const
  {
    return {1., from.velocity ? BackwardDifference(from, dt).now : 0., 0.};
  }

  void QuasiStatic::correct(const State  &from,
                            const Vector &increment,
                            const double  dt,
                            State        &trial) const
  {
    add_multiple(1., increment, trial.displacement);
    if (trial.velocity)
      add_multiple(BackwardDifference(from, dt).now,
                   increment,
                   *trial.velocity);
  }

  Equilibrium::Equilibrium() : ImplicitScheme("static equilibrium")
  {}

  void
  Equilibrium::predict(const State &from, const double /*dt*/, State &to) const
  {
    put_at_rest(from, to);
  }

  void Equilibrium::correct(const State & /*from*/,
                            const Vector &increment,
                            const double /*dt*/,
                            State &trial) const
  {
    add_multiple(1., increment, trial.displacement);
  }

  TimeSchemeEntry static_entry()
  {
    return {{static_name,
             "equilibrium at every step, time is a load parameter",
             {},
             make_static},
            {Model::lattice}};
  }
} // namespace auxfem
