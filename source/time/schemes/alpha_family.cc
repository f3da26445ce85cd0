#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/state/state.h>
#include <auxfem/time/schemes/alpha_family.h>

#include <cmath>

namespace auxfem
{
  AlphaFamily::AlphaFamily(const std::string  &name,
                           const Coefficients &coefficients)
    : ImplicitScheme(name)
    , c(coefficients)
  {}

  std::optional<double> AlphaFamily::error_constant() const
  {
    const double shift = c.alpha_m - c.alpha_f;
    if (std::abs(c.gamma + shift - 0.5) > round_off)
      return {};
    return c.beta + shift / 2 - 1. / 6;
  }

  void AlphaFamily::predict(const State &from, const double dt, State &to) const
  {
    // Constant true acceleration; the auxiliary one follows from its
    // recurrence.
    const int           n  = from.displacement.size();
    const double *const u  = from.displacement.data();
    const double *const v  = from.velocity->data();
    const double *const dv = from.acceleration->data();
    const double *const a  = uses_algorithmic_acceleration()
       ? from.algorithmic_acceleration->data()
       : dv;
    // Separate loops over copied coefficients let the compiler vectorize.
    const Coefficients c     = this->c;
    const auto         a_new = [=](const int i) {
      return (dv[i] - c.alpha_m * a[i]) / (1 - c.alpha_m);
    };
    double *const u_new = to.displacement.data();
    for (int i = 0; i < n; ++i)
      u_new[i] = u[i] + dt * v[i] +
        dt * dt * ((0.5 - c.beta) * a[i] + c.beta * a_new(i));
    double *const v_new = to.velocity->data();
    for (int i = 0; i < n; ++i)
      v_new[i] = v[i] + dt * ((1 - c.gamma) * a[i] + c.gamma * a_new(i));
    if (uses_algorithmic_acceleration())
      {
        double *const algorithmic = to.algorithmic_acceleration->data();
        for (int i = 0; i < n; ++i)
          algorithmic[i] = a_new(i);
      }
    *to.acceleration = *from.acceleration;
    to.is_massless   = from.is_massless;
    settle_massless(from, dt, to);
  }

  void AlphaFamily::settle_massless(const State &from,
                                    const double dt,
                                    State       &trial) const
  {
    if (!from.is_massless)
      return;
    for (unsigned int i = 0; i < from.displacement.size(); ++i)
      if ((*from.is_massless)[i] == massless)
        {
          const double before =
                         (*from.velocity)[i] - dt / 2 * (*from.acceleration)[i],
                       now =
                         (trial.displacement[i] - from.displacement[i]) / dt;
          settle_acceleration(i, (now - before) / dt, trial);
          (*trial.velocity)[i] = now + (now - before) / 2;
        }
      else if ((*from.is_massless)[i] == massless_and_damped)
        settle_acceleration(i, 0, trial);
  }

  void AlphaFamily::settle_acceleration(const unsigned int unknown,
                                        const double       acceleration,
                                        State             &trial) const
  {
    (*trial.acceleration)[unknown] = acceleration;
    if (uses_algorithmic_acceleration())
      (*trial.algorithmic_acceleration)[unknown] = acceleration;
  }

  TangentFactors AlphaFamily::factors(const State & /*from*/,
                                      const double dt) const
  {
    const double acceleration = 1 / (c.beta * dt * dt);
    return {1.,
            c.gamma / (c.beta * dt),
            acceleration * (1 - c.alpha_m) / (1 - c.alpha_f)};
  }

  void AlphaFamily::correct(const State  &from,
                            const Vector &increment,
                            const double  dt,
                            State        &trial) const
  {
    const TangentFactors f  = factors(from, dt);
    const int            n  = increment.size();
    const double        *du = increment.data();
    double              *u  = trial.displacement.data();
    double              *v  = trial.velocity->data();
    double              *dv = trial.acceleration->data();
    for (int i = 0; i < n; ++i)
      {
        u[i] += du[i];
        v[i] += f.damping * du[i];
        dv[i] += f.mass * du[i];
      }
    if (uses_algorithmic_acceleration())
      add_multiple(1 / (c.beta * dt * dt),
                   increment,
                   *trial.algorithmic_acceleration);
    settle_massless(from, dt, trial);
  }
} // namespace auxfem
