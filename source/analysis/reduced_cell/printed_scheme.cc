

/**
 * @file NOT A MODEL OF THE CELL: the equations and the scheme of Shokri Rad,
 * Mohsenizadeh and Ahmad exactly as printed, for comparison. No other scheme
 * uses this file. The printed errors are:
 *
 * - Eq. (18): K (Y2 + 2 L1 sin theta) on the right lacks the rest length 2 L1
 *   sin theta0, which stretches the spring from the start; entry (2,2) has 3/2
 *   m1 instead of 2 m1;
 * - Eq. (20), Maxwell: the right side is that of Kelvin-Voigt, although there
 *   is no spring beside the dashpot. With Y3 for Y2 everywhere, as Eq. (22) has
 *   it, its motion is that of Eq. (18);
 * - Eqs. (24), (25): the second difference lacks - 2 x(i), so the motion
 *   vanishes with the step length;
 * - the equations divide by cos theta without mechanical reason.
 */

#include <auxfem/analysis/reduced_cell/cell_scheme.h>
#include <auxfem/parameters/errors.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** K, C and the model of the paper's two connectors. */
    struct PrintedConnector
    {
      double stiffness, damping; ///< K (N/m), C (N s/m)
      bool   is_maxwell;
    };

    PrintedConnector connector_of(const Scene &scene)
    {
      const ConnectorDefinition &group  = scene.connectors.front();
      const ConnectorLaw        &law    = *group.law;
      const double               spring = law.relaxed(0).stiffness;
      if (law.n_history() == 0 && law.is_linear())
        // The power at unit rate is C.
        return {spring,
                law.continuous(0, 1, nullptr, nullptr).lost_power,
                false};
      if (!law.is_linear() || law.n_history() > 1 || spring > 0)
        throw InputError(group.path +
                         ": Time/Scheme = as printed is the paper's, which has "
                         "equations for Kelvin-Voigt and Maxwell connectors "
                         "only. Choose one of these, or another scheme");
      // Energy 1/(2 K) and power 1/C at unit force.
      const double             force      = 1;
      double                   force_rate = 0;
      const ContinuousResponse unit = law.continuous(0, 0, &force, &force_rate);
      if (unit.lost_power == 0)
        throw InputError(group.path +
                         ": Time/Scheme = as printed needs a Damping "
                         "coefficient > 0 of a Maxwell connector");
      return {0.5 / unit.stored, 1 / unit.lost_power, true};
    }

    /**
     * Two-step scheme of Eqs. (23) to (25) for Eq. (18) or (20). With a Maxwell
     * connector the second unknown is Y3. The paper then gives neither Y1 nor
     * Y2, so there are no energies.
     */
    class PrintedScheme : public TwoStepScheme
    {
    public:
      explicit PrintedScheme(const Scene &scene)
        : TwoStepScheme(scene)
        , connector(connector_of(scene))
      {}

    private:
      /** Accelerations of theta and of Y2 (or Y3) from Eq. (18), (20). */
      CellVector printed_acceleration(const CellMotion &motion) const
      {
        const ReducedCellDefinition &p = *scene.reduced_cell;
        const double L1 = p.bar_length, m1 = p.bar_mass, m2 = p.part_mass;
        const double theta = cell.equations().angle(motion.position[0]);
        const double c = std::cos(theta), s = std::sin(theta);
        const double rotation_rate = motion.velocity[0];

        CellMatrix M;
        M[0][0] = -5 * m1 * L1 / (12 * c) - m1 * L1 * s * s / (4 * c) -
          (2 * m2 + 9 * m1 / 4) * (L1 * c);
        M[0][1] = -2 * m1 - m2;
        M[1][0] =
          -m1 * L1 * s * s / (2 * c) + 3 * m1 * L1 * c / 2 - m1 * L1 / (6 * c);
        M[1][1] = m2 + 3 * m1 / 2;

        CellVector right_side;
        right_side[0] = cell.load() +
          connector.stiffness * (motion.position[1] + 2 * L1 * s) +
          connector.damping *
            (motion.velocity[1] + 2 * L1 * rotation_rate * c) -
          2 * L1 * (m1 + m2) * rotation_rate * rotation_rate * s;
        right_side[1] = 2 * m1 * L1 * rotation_rate * rotation_rate * s;
        return invert(M) * right_side;
      }

      /**
       * Force f2 of Eq. (26) or (27). The paper counts tension positive; auxfem
       * counts compression positive.
       */
      double transmitted(const CellMotion &motion) const
      {
        if (connector.is_maxwell)
          return -connector.stiffness * motion.position[1];
        return -(connector.stiffness *
                   cell.equations().extension(motion.position) +
                 connector.damping * cell.equations().extension_rate(motion));
      }

      /**
       * Computes a sample; all first positions are those at rest, as in Eq.
       * (24) for i = 3.
       */
      CellSample sample() override
      {
        const double     dt     = scene.time.step;
        const CellMotion motion = grid.motion(dt);
        const CellVector a      = printed_acceleration(motion);
        if (!std::isfinite(a[0]) || !std::isfinite(a[1]))
          throw_not_finite();
        grid.shift(grid.before() + 4 * dt * dt * a);

        CellSample now  = cell.accept(motion);
        now.transmitted = transmitted(motion);
        if (connector.is_maxwell)
          {
            const double unknown = std::numeric_limits<double>::quiet_NaN();
            now.upper_rise = now.lower_rise = unknown;
            for (double &energy : now.energies.amounts())
              energy = unknown;
          }
        return now;
      }

      [[noreturn]] void throw_not_finite() const
      {
        std::ostringstream message;
        message << "The paper's scheme as printed gives numbers that are not "
                   "finite at t = "
                << scene.time.time_at(step)
                << " s.\nAll steps until then are in the output folder. Use "
                   "another Time/Scheme.";
        throw ComputationError(message.str());
      }

      const PrintedConnector connector;
    };

    const std::string as_printed_name = "as printed";

    std::unique_ptr<TimeScheme> make_as_printed(ParameterValues & /*values*/)
    {
      return std::make_unique<CellMethodOf<PrintedScheme>>(as_printed_name);
    }
  } // namespace

  TimeSchemeEntry as_printed_entry()
  {
    return {
      {as_printed_name,
       "the paper's equations (18), (20) and scheme (24), (25) with their "
       "misprints",
       {},
       make_as_printed},
      {Model::reduced_cell}};
  }
} // namespace auxfem
