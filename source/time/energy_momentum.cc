#include <auxfem/elements/cayley_rotation.h>
#include <auxfem/time/schemes.h>

namespace auxfem
{
  namespace
  {
    const std::string energy_momentum_name = "energy-momentum";

    /**
     * The mean velocity of a step is its increment over dt, for rotations
     * Cayley's measure of it,
     *
     *   (v_n + v_{n+1}) / 2 = (u_{n+1} - u_n) / dt,
     *   (omega_n + omega_{n+1}) / 2 = 2 tan((phi_{n+1} - phi_n) / 2) / dt,
     *
     * in space of material angular velocities and the vector of this length,
     *
     * and the mean acceleration (v_{n+1} - v_n) / dt balances the mean forces.
     */
    class EnergyMomentum : public ImplicitScheme
    {
    public:
      EnergyMomentum() : ImplicitScheme(energy_momentum_name)
      {}

      void predict(const State &from, double dt, State &to) const override;

      TangentFactors factors(const State & /*from*/,
                             const double dt) const override
      {
        return {0.5, 1 / dt, 2 / (dt * dt)};
      }

      void correct(const State  &from,
                   const Vector &increment,
                   double        dt,
                   State        &trial) const override;

      bool balances_means() const override
      {
        return true;
      }
    };

    void
    EnergyMomentum::predict(const State &from, const double dt, State &to) const
    {
      // From the positions at the start: where a step is long for the motion, a
      // guess ahead of it is further off, and Newton's method fails.
      const int     n = from.displacement.size();
      const double *v = from.velocity->data();
      to.displacement = from.displacement;
      double *v_new   = to.velocity->data();
      double *a_new   = to.acceleration->data();
      for (int i = 0; i < n; ++i)
        {
          v_new[i] = -v[i];
          a_new[i] = -2 * v[i] / dt;
        }
    }

    void EnergyMomentum::correct(const State  &from,
                                 const Vector &increment,
                                 const double  dt,
                                 State        &trial) const
    {
      const TangentFactors f  = factors(from, dt);
      const int            n  = increment.size();
      const double        *du = increment.data();
      const double        *u0 = from.displacement.data();
      double              *u  = trial.displacement.data();
      double              *v  = trial.velocity->data();
      double              *a  = trial.acceleration->data();
      for (const int i : *trial.plane_rotations)
        {
          // What Cayley's measure grows by beyond the increment.
          const double more = cayley_rotation(u[i] + du[i] - u0[i]) -
            cayley_rotation(u[i] - u0[i]) - du[i];
          v[i] += 2 * f.damping * more;
          a[i] += f.mass * more;
        }
      for (const std::array<int, 3> &at : *trial.space_rotations)
        {
          const SpaceVector before = vector_at(u, at.data()) -
            vector_at(u0, at.data()),
                            moved = vector_at(du, at.data());
          const SpaceVector more =
            cayley_rotation(before + moved) - cayley_rotation(before) - moved;
          for (unsigned int c = 0; c < 3; ++c)
            {
              v[at[c]] += 2 * f.damping * more[c];
              a[at[c]] += f.mass * more[c];
            }
        }
      for (int i = 0; i < n; ++i)
        {
          u[i] += du[i];
          v[i] += 2 * f.damping * du[i];
          a[i] += f.mass * du[i];
        }
    }

    std::unique_ptr<TimeScheme>
    make_energy_momentum(ParameterValues & /*values*/)
    {
      return std::make_unique<EnergyMomentum>();
    }
  } // namespace

  TimeSchemeEntry energy_momentum_entry()
  {
    return {{energy_momentum_name,
             "keeps energy and momenta at large rotations, of second order",
             {},
             make_energy_momentum},
            {Model::lattice}};
  }
} // namespace auxfem
