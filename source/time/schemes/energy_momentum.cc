#include <auxfem/mathematics/cayley_rotation.h>
#include <auxfem/time/schemes/time_scheme.h>

namespace auxfem
{
  namespace
  {
    const std::string energy_momentum_name = "energy-momentum";

    const Quantity high_frequency_entry = {
      "Damping of energy-momentum",
      "none",
      "1",
      {0, 0.125, true, false},
      "Damping of the highest frequencies of struts with Scheme = "
      "energy-momentum, which stays of second order, keeps the momenta and never "
      "creates energy. With 0.125, its largest value, an oscillation of circular "
      "frequency w keeps of its amplitude in a step 0.9999 if w times the step "
      "is 0.3, 0.94 if 2, 0.71 if 10 and 0.997 if 100. none: no damping.",
      {"none"}};

    /**
     * Energy-momentum scheme with a discrete gradient. The mean velocity of a
     * step is its increment over dt; rotations use Cayley's measure,
     *
     *     (v_n + v_{n+1}) / 2 = (u_{n+1} - u_n) / dt,
     *     (omega_n + omega_{n+1}) / 2 = 2 tan((phi_{n+1} - phi_n) / 2) / dt,
     *
     * in space with material angular velocities and the vector of this length.
     * The mean acceleration (v_{n+1} - v_n) / dt balances the mean forces.
     */
    class EnergyMomentum : public ImplicitScheme
    {
    public:
      /** @param damping see high_frequency_damping() */
      explicit EnergyMomentum(const double damping)
        : ImplicitScheme(energy_momentum_name)
        , damping(damping)
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

      bool uses_discrete_gradient() const override
      {
        return true;
      }

      double high_frequency_damping() const override
      {
        return damping;
      }

    private:
      const double damping;
    };

    void
    EnergyMomentum::predict(const State &from, const double dt, State &to) const
    {
      // Starts from the initial positions: in long steps an extrapolation is
      // worse, and Newton's method fails.
      const int     n = from.displacement.size();
      const double *v = from.velocity->data();
      to.displacement = from.displacement;
      to.compensation = from.compensation;
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
      const double        *c0 = from.compensation->data();
      double              *u  = trial.displacement.data();
      double              *c  = trial.compensation->data();
      double              *v  = trial.velocity->data();
      double              *a  = trial.acceleration->data();
      for (const int i : *trial.plane_rotations)
        {
          // Growth of Cayley's measure beyond the increment, by tan x - tan y
          // = sin(x - y) / (cos x cos y).
          const double before = ((u[i] - u0[i]) + (c[i] - c0[i])) / 2,
                       half   = du[i] / 2;
          const double more   = du[i] *
            (sinc(half) /
               (small_angle_cosine(before + half) *
                small_angle_cosine(before)) -
             1);
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
          for (unsigned int i = 0; i < 3; ++i)
            {
              v[at[i]] += 2 * f.damping * more[i];
              a[at[i]] += f.mass * more[i];
            }
        }
      for (int i = 0; i < n; ++i)
        {
          const double moved = du[i] + c[i], before = u[i];
          u[i] = before + moved;
          c[i] = moved - (u[i] - before);
          v[i] += 2 * f.damping * du[i];
          a[i] += f.mass * du[i];
        }
    }

    std::unique_ptr<TimeScheme> make_energy_momentum(ParameterValues &values)
    {
      const double damping = values.is_word(high_frequency_entry)
        ? 0.
        : double(values[high_frequency_entry]);
      return std::make_unique<EnergyMomentum>(damping);
    }
  } // namespace

  TimeSchemeEntry energy_momentum_entry()
  {
    return {{energy_momentum_name,
             "keeps energy and momenta at large rotations, of second order",
             {high_frequency_entry},
             make_energy_momentum},
            {Model::lattice}};
  }
} // namespace auxfem
