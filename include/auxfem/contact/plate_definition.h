#ifndef auxfem_contact_plate_definition_h
#define auxfem_contact_plate_definition_h

#include <auxfem/contact/rigid_surface.h>
#include <auxfem/loads/load_definitions.h>
#include <auxfem/parameters/subsection_schema.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>

namespace auxfem
{
  /**
   * Force against penetration: none without it, a parabola up to the depth
   * `smoothing`, from there on a straight line of slope `stiffness`,
   *
   *     f(d) = k d^2 / (2 s),  0 < d < s,     f(d) = k (d - s/2),  d >= s,
   *
   * so that force and stiffness begin at zero. A penalty law as in C. Meier, A.
   * Popp, W. A. Wall, A finite element approach for the line-to-line contact
   * interaction of thin beams with arbitrary orientation, Comput. Methods Appl.
   * Mech. Eng. 308, 2016, 377-413 (their quadratically regularised law).
   */
  struct ContactLaw
  {
    double stiffness; ///< k (N/m)
    double smoothing; ///< s (m)

    /** N, at the penetration @p depth (m), negative where there is a gap. */
    double force(double depth) const;

    /** Derivative of the force by the depth (N/m). */
    double slope(double depth) const;

    /** Integral of the force from no penetration to @p depth (J). */
    double energy(double depth) const;

    /** Mean of the force over the depths between @p from and @p to (N): its
     * work on the way is the change of the energy, without cancellation. */
    double mean_force(double from, double to) const;

    /** Derivative of the mean force by @p to (N/m). */
    double mean_slope(double from, double to) const;
  };

  /** Friction at a point of contact. */
  struct FrictionForce
  {
    using Vector = dealii::Tensor<1, 3>;

    Vector force; ///< on the first body (N)
    Vector slip;  ///< its velocity along the face of the other one (m/s)
    double normal_velocity = 0; ///< its velocity away from that (m/s)
    double scale = 0; ///< sqrt(slip^2 + v0^2) (m/s); 0 without friction
    double limit = 0; ///< N

    /** What is lost (W), at least 0. */
    double lost_power() const
    {
      return -(force * slip);
    }
  };

  /** Derivatives of minus the force of friction. */
  struct FrictionChange
  {
    dealii::Tensor<2, 3> by_velocity; ///< of the first body (N s/m)
    dealii::Tensor<2, 3> by_normal;   ///< for changes along the face (N)
    dealii::Tensor<1, 3> by_pressure; ///< 1
  };

  /**
   * Coulomb's friction, regularised: with @p v_t the velocity of a body along
   * the face of another one that presses on it with @p f, the force
   *
   *     -mu f v_t / sqrt(v_t^2 + v0^2).
   *
   * Theory: doc/theory.md, Contact, Friction.
   */
  struct CoulombFriction
  {
    double coefficient;   ///< mu
    double slip_velocity; ///< v0 (m/s)

    /**
     * @param velocity of the first body against the second (m/s)
     * @param normal of the face, of length 1, towards the first body
     * @param pressure force across the face (N)
     */
    FrictionForce force(const dealii::Tensor<1, 3> &velocity,
                        const dealii::Tensor<1, 3> &normal,
                        double                      pressure) const;

    /** @param normal, pressure those that @p force was found with */
    FrictionChange change(const FrictionForce        &force,
                          const dealii::Tensor<1, 3> &normal) const;
  };

  /** `Contact`: how struts resist what touches them. */
  struct ContactParameters
  {
    /** Of a strut from axis to face, by that of its material. */
    double stiffness = 1;
    /** Of the penetration over half the thickness: up to which the stiffness
     * grows, and beyond which a step is rejected. */
    double smoothing = 0.01, largest_penetration = 0.5;
    double friction      = 0; ///< Coulomb's coefficient
    double slip_velocity = 0; ///< at which friction is near to its limit (m/s)
  };

  /** `Contact`. */
  SubsectionSchema contact_schema();

  /** The values of that subsection. */
  ContactParameters read_contact(ParameterValues &values);

  /**
   * `Plates/NAME`: a rigid body that struts cannot enter. It does not turn. Its
   * point of reference is a joint of its own, the set NAME, so whatever holds,
   * moves, loads or shows joints serves plates too.
   */
  struct PlateDefinition
  {
    std::string                         name;
    std::shared_ptr<const RigidSurface> surface;
    dealii::Point<3>                    position; ///< of reference, at rest (m)
    /** Of the components that are held or moved; none if all are free. */
    std::optional<SupportDefinition> support;
    /** None without mass. */
    std::optional<MassDefinition> mass;
    /** None if it starts at rest. */
    std::optional<InitialVelocityDefinition> initial_velocity;
    std::string                              path;
  };

  /** `Plates`. */
  SubsectionSchema plates_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  PlateDefinition read_plate(ParameterValues &values);
} // namespace auxfem

#endif
