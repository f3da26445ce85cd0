#ifndef auxfem_contact_contact_law_h
#define auxfem_contact_contact_law_h

#include <auxfem/parameters/subsection_schema.h>

#include <deal.II/base/tensor.h>

#include <optional>

namespace auxfem
{
  /**
   * Penalty law of contact: the force is quadratic up to the depth `smoothing`
   * and linear with the slope `stiffness` beyond,
   *
   *     f(d) = k d^2 / (2 s),  0 < d < s,     f(d) = k (d - s/2),  d >= s,
   *
   * so force and stiffness start at zero. After C. Meier, A. Popp, W. A. Wall,
   * A finite element approach for the line-to-line contact interaction of thin
   * beams with arbitrary orientation, Comput. Methods Appl. Mech. Eng. 308,
   * 2016, 377-413 (their quadratically regularised law).
   */
  struct ContactLaw
  {
    double stiffness; ///< k (N/m)
    double smoothing; ///< s (m)

    /** Force (N) at the penetration @p depth (m); a gap is negative. */
    double force(double depth) const;

    /** Derivative of the force with respect to the depth (N/m). */
    double slope(double depth) const;

    /** Stored energy (J): integral of the force up to @p depth. */
    double energy(double depth) const;

    /** Mean force (N) over the depths from @p from to @p to. Its work equals
     * the energy change, and it is evaluated without cancellation. */
    double mean_force(double from, double to) const;

    /** Derivative of the mean force with respect to @p to (N/m). */
    double mean_slope(double from, double to) const;
  };

  /** Friction at a contact point. */
  struct FrictionForce
  {
    using Vector = dealii::Tensor<1, 3>;

    Vector force;               ///< on the first body (N)
    Vector slip;                ///< tangential relative velocity (m/s)
    double normal_velocity = 0; ///< separation velocity (m/s)
    double scale = 0; ///< sqrt(slip^2 + v0^2) (m/s); 0 without friction
    double limit = 0; ///< N

    /** Dissipated power (W), not negative. */
    double lost_power() const
    {
      return -(force * slip);
    }
  };

  /** Derivatives of the negative friction force. */
  struct FrictionChange
  {
    dealii::Tensor<2, 3> by_velocity; ///< (N s/m)
    dealii::Tensor<2, 3>
      by_normal; ///< for tangential changes of the normal (N)
    dealii::Tensor<1, 3> by_pressure; ///< 1
  };

  /**
   * Regularised Coulomb friction. With the tangential relative velocity @p v_t
   * and the normal force @p f, the friction force is
   *
   *     -mu f v_t / sqrt(v_t^2 + v0^2).
   *
   * Theory: doc/theory/contact.md, Friction.
   */
  struct CoulombFriction
  {
    double coefficient;   ///< mu
    double slip_velocity; ///< v0 (m/s)

    /** @param velocity of the first body relative to the second (m/s)
     * @param normal unit normal of the contact face, towards the first body
     * @param pressure normal force (N) */
    FrictionForce force(const dealii::Tensor<1, 3> &velocity,
                        const dealii::Tensor<1, 3> &normal,
                        double                      pressure) const;

    /** @param normal as passed to force() */
    FrictionChange change(const FrictionForce        &force,
                          const dealii::Tensor<1, 3> &normal) const;
  };

  /** Parameters of subsection `Contact`: penalty stiffness and friction. */
  struct ContactParameters
  {
    /** Penalty stiffness over the stiffness of the half strut between axis and
     * face. */
    double stiffness = 1;
    /** Penetrations over half the thickness: end of the quadratic part of the
     * law, and limit beyond which a step is rejected. */
    double smoothing = 0.01, largest_penetration = 0.5;
    double friction      = 0; ///< Coulomb's coefficient
    double slip_velocity = 0; ///< regularisation velocity v0 (m/s)
  };

  /** Declares subsection `Contact`. */
  SubsectionSchema contact_schema();

  /** Reads subsection `Contact`. */
  ContactParameters read_contact(ParameterValues &values);
} // namespace auxfem

#endif
