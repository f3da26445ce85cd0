#ifndef auxfem_analysis_reduced_cell_cell_equations_h
#define auxfem_analysis_reduced_cell_cell_equations_h

#include <auxfem/scene/scene.h>

#include <deal.II/base/tensor.h>

namespace auxfem
{
  /** A pair for the two unknowns of the cell: rotation (rad), rise (m). */
  using CellVector = dealii::Tensor<1, 2>;
  using CellMatrix = dealii::Tensor<2, 2>;

  /** Position and velocity of the cell. */
  struct CellMotion
  {
    /** Rotation theta - theta0 (rad), rise Y2 of the lower part (m). */
    CellVector position;
    /** Rates of both (rad/s, m/s). */
    CellVector velocity;
  };

  /**
   * The equations of motion of the star cell made of six rigid parts: four bars
   * (length L1, mass m1) hinged to an upper and a lower part (mass m2 each),
   * the parts of Figs. 2 and 4 of Shokri Rad, Mohsenizadeh and Ahmad. The cell
   * is symmetric; the bars stand at the angle theta against the horizontal; the
   * load f1 pushes the upper part down; the connector pulls it down with the
   * force F (positive in tension); the lower part is free to slide.
   *
   * With q = (theta - theta0, Y2), c = cos theta, s = sin theta, Lagrange's
   * equations of the kinetic energy of all six parts are
   *
   * @code
   * M q'' + h = -(f1 + F) b,        b = (2 L1 c, 1)
   * M11 = L1^2 [4 (m1 + m2) c^2 + 4/3 m1]
   * M12 = 2 L1 c (2 m1 + m2)        M22 = 4 m1 + 2 m2
   * h1  = -4 L1^2 (m1 + m2) s c theta'^2
   * h2  = -2 L1 (2 m1 + m2) s theta'^2
   * @endcode
   *
   * and the upper part rises by Y1 = Y2 + 2 L1 (sin theta - sin theta0), Eq.
   * (2) of the paper. They follow from its Eqs. (11), (12), (14) and (17) with
   * the errors of (6), (9), (10) and (18) corrected. They contain no division
   * by cos theta: at c = 0 the matrix is regular unless m1 = 0, because
   *
   * @code
   * det M = 4 L1^2 [m2^2 + 2 m1 m2] c^2 + 4/3 m1 L1^2 (4 m1 + 2 m2)
   * @endcode
   *
   * All functions are pure; units SI; the two rows of the equations have the
   * units N m and N.
   */
  class CellEquations
  {
  public:
    explicit CellEquations(const ReducedCellDefinition &cell);

    /** Angle theta (rad) at @p rotation. */
    double angle(const double rotation) const
    {
      return angle_at_rest + rotation;
    }

    /** Y1, rise of the upper part and extension of the connector (m). */
    double extension(const CellVector &position) const;

    /** Y1' (m/s). */
    double extension_rate(const CellMotion &motion) const;

    /** b, derivative of Y1 by the unknowns (m, 1). */
    CellVector lever(double rotation) const;

    /** Derivative of the lever by the rotation. */
    CellVector lever_derivative(double rotation) const;

    /** M. */
    CellMatrix mass(double rotation) const;

    /** Derivative of M by the rotation. */
    CellMatrix mass_derivative(double rotation) const;

    /** h. */
    CellVector velocity_force(double rotation, double rotation_rate) const;

    /** Derivatives of h by rotation and its rate. */
    ///@{
    CellVector velocity_force_by_rotation(double rotation,
                                          double rotation_rate) const;
    CellVector velocity_force_by_rate(double rotation,
                                      double rotation_rate) const;
    ///@}

    /**
     * Acceleration q'' under @p force = f1 + F (N). Throws ComputationError if
     * M is singular (m1 = 0 and the bars upright).
     */
    CellVector acceleration(const CellMotion &motion, double force) const;

    /** Kinetic energy of all parts (J). */
    double kinetic_energy(const CellMotion &motion) const;

    /** Whether M has an inverse at every angle: m1 > 0. */
    bool is_always_regular() const
    {
      return bar_mass > 0;
    }

    /**
     * Throws ComputationError if massless bars are upright or beyond, because M
     * is singular there.
     */
    void require_regular_mass(double rotation) const;

  private:
    const double length, angle_at_rest, bar_mass, part_mass;
  };
} // namespace auxfem

#endif
