#include <auxfem/analysis/reduced_cell/cell_equations.h>
#include <auxfem/parameters/errors.h>

#include <cmath>

namespace auxfem
{
  CellEquations::CellEquations(const ReducedCellDefinition &cell)
    : length(cell.bar_length)
    , angle_at_rest(cell.angle)
    , bar_mass(cell.bar_mass)
    , part_mass(cell.part_mass)
  {}

  double CellEquations::extension(const CellVector &position) const
  {
    // The product avoids a difference of nearly equal sines.
    const double half = position[0] / 2;
    return position[1] +
      4 * length * std::cos(angle_at_rest + half) * std::sin(half);
  }

  double CellEquations::extension_rate(const CellMotion &motion) const
  {
    return lever(motion.position[0]) * motion.velocity;
  }

  CellVector CellEquations::lever(const double rotation) const
  {
    CellVector b;
    b[0] = 2 * length * std::cos(angle(rotation));
    b[1] = 1;
    return b;
  }

  CellVector CellEquations::lever_derivative(const double rotation) const
  {
    CellVector b;
    b[0] = -2 * length * std::sin(angle(rotation));
    return b;
  }

  CellMatrix CellEquations::mass(const double rotation) const
  {
    const double c = std::cos(angle(rotation));
    CellMatrix   M;
    M[0][0] =
      4 * length * length * ((bar_mass + part_mass) * c * c + bar_mass / 3);
    M[0][1] = M[1][0] = 2 * length * c * (2 * bar_mass + part_mass);
    M[1][1]           = 4 * bar_mass + 2 * part_mass;
    return M;
  }

  CellMatrix CellEquations::mass_derivative(const double rotation) const
  {
    const double c = std::cos(angle(rotation)), s = std::sin(angle(rotation));
    CellMatrix   M;
    M[0][0] = -8 * length * length * (bar_mass + part_mass) * c * s;
    M[0][1] = M[1][0] = -2 * length * s * (2 * bar_mass + part_mass);
    return M;
  }

  CellVector CellEquations::velocity_force(const double rotation,
                                           const double rotation_rate) const
  {
    const double c = std::cos(angle(rotation)), s = std::sin(angle(rotation));
    CellVector   h;
    h[0] = -4 * length * length * (bar_mass + part_mass) * s * c;
    h[1] = -2 * length * (2 * bar_mass + part_mass) * s;
    return rotation_rate * rotation_rate * h;
  }

  CellVector
  CellEquations::velocity_force_by_rotation(const double rotation,
                                            const double rotation_rate) const
  {
    const double c = std::cos(angle(rotation)), s = std::sin(angle(rotation));
    CellVector   h;
    h[0] = -4 * length * length * (bar_mass + part_mass) * (c * c - s * s);
    h[1] = -2 * length * (2 * bar_mass + part_mass) * c;
    return rotation_rate * rotation_rate * h;
  }

  CellVector
  CellEquations::velocity_force_by_rate(const double rotation,
                                        const double rotation_rate) const
  {
    return 2 * rotation_rate * velocity_force(rotation, 1);
  }

  CellVector CellEquations::acceleration(const CellMotion &motion,
                                         const double      force) const
  {
    const double rotation = motion.position[0];
    require_regular_mass(rotation);
    return invert(mass(rotation)) *
      (-force * lever(rotation) - velocity_force(rotation, motion.velocity[0]));
  }

  double CellEquations::kinetic_energy(const CellMotion &motion) const
  {
    return 0.5 *
      (motion.velocity * (mass(motion.position[0]) * motion.velocity));
  }

  void CellEquations::require_regular_mass(const double rotation) const
  {
    // In floating point the cosine of an upright bar is not exactly zero.
    if (!is_always_regular() && std::cos(angle(rotation)) < 1e-12)
      throw ComputationError(
        "The bars come upright. Without mass (Reduced cell/Bar mass = 0) "
        "the mass matrix is singular there, so the motion beyond is not "
        "determined. Give the bars a mass, or reduce Time/End time.");
  }
} // namespace auxfem
