#include <auxfem/time/schemes.h>
#include <auxfem/time/static.h>

namespace auxfem
{
  namespace
  {
    const std::string word = "static";

    void put_at_rest(const State &from, State &to)
    {
      to.displacement = from.displacement;
      if (to.velocity)
        to.velocity->assign(to.velocity->size(), 0.);
      if (to.acceleration)
        to.acceleration->assign(to.acceleration->size(), 0.);
    }

    std::unique_ptr<TimeScheme> make_static(dealii::ParameterHandler & /*prm*/,
                                            const SceneContext & /*context*/)
    {
      return std::make_unique<QuasiStatic>();
    }
  } // namespace

  QuasiStatic::QuasiStatic() : ImplicitScheme(word)
  {}

  void
  QuasiStatic::predict(const State &from, const double /*dt*/, State &to) const
  {
    put_at_rest(from, to);
  }

  TangentFactors QuasiStatic::factors(const double dt) const
  {
    return {1., 1 / dt, 0.};
  }

  void QuasiStatic::correct(const State & /*from*/,
                            const Vector &increment,
                            const double  dt,
                            State        &trial) const
  {
    add_multiple(1., increment, trial.displacement);
    if (trial.velocity)
      add_multiple(1 / dt, increment, *trial.velocity);
  }

  bool QuasiStatic::is_dynamic() const
  {
    return false;
  }



  Equilibrium::Equilibrium() : ImplicitScheme("static equilibrium")
  {}

  void
  Equilibrium::predict(const State &from, const double /*dt*/, State &to) const
  {
    put_at_rest(from, to);
  }

  TangentFactors Equilibrium::factors(const double /*dt*/) const
  {
    return {1., 0., 0.};
  }

  void Equilibrium::correct(const State & /*from*/,
                            const Vector &increment,
                            const double /*dt*/,
                            State &trial) const
  {
    add_multiple(1., increment, trial.displacement);
  }

  bool Equilibrium::is_dynamic() const
  {
    return false;
  }



  TimeSchemeEntry static_entry()
  {
    return {{word,
             "equilibrium at every step, time is a load parameter",
             nullptr,
             &make_static},
            {Model::lattice}};
  }
} // namespace auxfem
