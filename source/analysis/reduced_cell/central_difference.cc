#include <auxfem/analysis/reduced_cell/cell_scheme.h>

#include <array>

namespace auxfem
{
  namespace
  {
    /**
     * The paper's grids with a consistent second difference:
     *
     * x'(i)  = [x(i+1) - x(i-1)] / (2 dt) x''(i) = [x(i+2) - 2 x(i) + x(i-2)] /
     * (4 dt^2)
     *
     * It is explicit for x(i+2) and of second order. Only velocities couple the
     * grids of even and odd steps. With dashpots, a difference of the grids
     * grows about as fast as the motion decays, for any step length.
     */
    class CentralDifference : public TwoStepScheme
    {
    public:
      explicit CentralDifference(const Scene &scene) : TwoStepScheme(scene)
      {}

    private:
      void set_first_positions() override
      {
        const CellMotion rest;
        const double     dt    = scene.time.step;
        const double     force = cell.load() + cell.connector(rest).force;
        const CellVector first =
          dt * dt / 2 * cell.equations().acceleration(rest, force);
        grid = TwoStepGrid(
          std::array<CellVector, 4>{{4 * first, first, CellVector(), first}});
      }

      CellSample sample() override
      {
        const double     dt     = scene.time.step;
        const CellMotion motion = grid.motion(dt);
        cell.equations().require_regular_mass(motion.position[0]);
        const double     force = cell.load() + cell.connector(motion).force;
        const CellVector a     = cell.equations().acceleration(motion, force);
        grid.shift(2 * motion.position - grid.before() + 4 * dt * dt * a);
        return cell.accept(motion);
      }
    };

    const std::string central_difference_name = "central difference";

    std::unique_ptr<TimeScheme>
    make_central_difference(ParameterValues & /*values*/)
    {
      return std::make_unique<CellMethodOf<CentralDifference>>(
        central_difference_name);
    }
  } // namespace

  TimeSchemeEntry central_difference_entry()
  {
    return {{central_difference_name,
             "central differences on two interlaced grids",
             {},
             make_central_difference},
            {Model::reduced_cell}};
  }
} // namespace auxfem
