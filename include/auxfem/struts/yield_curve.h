#ifndef auxfem_struts_yield_curve_h
#define auxfem_struts_yield_curve_h

#include <auxfem/mathematics/lanes.h>

#include <optional>
#include <utility>
#include <vector>

namespace auxfem
{
  /**
   * Uniaxial yielding of a material with isotropic hardening by a table, linear
   * kinematic hardening (Prager) and the rate dependence of Cowper & Symonds
   * (1957): yield stress k(alpha) (1 + (rate / D)^(1/n)), back stress h times
   * the plastic strain. All stresses are over Young's modulus.
   */
  class YieldCurve
  {
  public:
    /** A point of the table. */
    struct Point
    {
      double plastic_strain; ///< accumulated
      double stress;         ///< over Young's modulus
    };

    /** Parameters of Cowper & Symonds. */
    struct Rate
    {
      double reference; ///< D (1/s)
      double exponent;  ///< n
    };

    /**
     * @param points the first at plastic strain 0, strains rising, stresses not
     *   falling; beyond the last one the stress is constant
     * @param kinematic hardening modulus h over Young's modulus
     */
    YieldCurve(const std::vector<Point> &points,
               double                    kinematic,
               std::optional<Rate>       rate);

    /** Yield stress of the material at rest. */
    double initial() const
    {
      return segments.front().stress;
    }

    /** h. */
    double kinematic() const
    {
      return kinematic_modulus;
    }

    bool depends_on_rate() const
    {
      return rate.has_value();
    }

    /** Plastic strain at the end of the table; empty if it has one point. */
    std::optional<double> end_of_table() const;

    /** Static yield stress at an accumulated plastic strain. */
    Lanes stress(const Lanes &plastic_strain) const;

    /** An increment of plastic strain, >= 0, and the derivative of yield stress
     * plus back stress by it. */
    struct Flow
    {
      Lanes increment, slope;
    };

    /**
     * Increment d with @p stress = (1 + h) d + yield stress at the end, or 0
     * where the stress does not exceed the yield stress.
     * @param stress elastic stress minus back stress, >= 0
     * @param plastic_strain accumulated, at the start of the step
     * @param dt length of the step (s); 0: yielding without rate dependence
     */
    Flow
    flow(const Lanes &stress, const Lanes &plastic_strain, double dt) const;

    /** Flow of a fibre in tension and shear, by von Mises' rule. */
    template <class Number>
    struct ShearFlowOf
    {
      Number increment;  ///< of accumulated plastic strain
      Number multiplier; ///< increment over the equivalent stress at the end
      /** Derivative of the yield stress, without back stress, by the
       * increment. */
      Number slope;
    };
    using ShearFlow = ShearFlowOf<Lanes>;

    /**
     * As flow() for the elastic stress minus back stress of the components @p
     * normal and @p shear, the latter times sqrt(3), both >= 0.
     * @param shear_ratio three times G / E
     */
    ShearFlow shear_flow(const Lanes &normal,
                         const Lanes &shear,
                         const Lanes &plastic_strain,
                         double       shear_ratio,
                         double       dt) const;

  private:
    /** Factor of the yield stress by an increment of plastic strain in @p dt
     * (s), and its slope. */
    std::pair<double, double> rate_factor(double increment, double dt) const;

    ShearFlowOf<double> shear_flow_at(double normal,
                                      double shear,
                                      double plastic_strain,
                                      double shear_ratio,
                                      double dt) const;

    /** A linear piece, from the plastic strain `begin` on. */
    struct Segment
    {
      double begin, stress, slope;
    };

    /** Yield stress over Young's modulus and its slope at a plastic strain. */
    std::pair<double, double> at(double plastic_strain) const;
    std::vector<Segment>      segments;
    double                    kinematic_modulus;
    std::optional<Rate>       rate;
  };
} // namespace auxfem

#endif
