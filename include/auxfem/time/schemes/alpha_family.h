#ifndef auxfem_time_schemes_alpha_family_h
#define auxfem_time_schemes_alpha_family_h

#include <auxfem/time/schemes/time_scheme.h>

namespace auxfem
{
  /**
   * Newmark, Hilber-Hughes-Taylor and generalized-alpha as one scheme, in the
   * form of Arnold & Bruels (2007). Equilibrium holds at the end of the step
   * with the true acceleration v'; displacement and velocity follow Newmark's
   * formulas with an auxiliary acceleration a,
   *
   * @code
   * (1 - alpha_m) a_{n+1} + alpha_m a_n =
   *                             (1 - alpha_f) v'_{n+1} + alpha_f v'_n
   * u_{n+1} = u_n + dt v_n + dt^2 [(1/2 - beta) a_n + beta a_{n+1}]
   * v_{n+1} = v_n + dt [(1 - gamma) a_n + gamma a_{n+1}]
   * @endcode
   *
   * For linear systems this is the method of Chung & Hulbert (1993). With
   * alpha_m = alpha_f = 0 it is Newmark's method and a = v'.
   *
   * Members with gamma = 2 beta have the spectral radius one at infinity, so
   * that accelerations of unknowns without mass would grow. Rates of such
   * unknowns are differences of the last three positions; if they are damped,
   * a = v' = 0.
   */
  class AlphaFamily : public ImplicitScheme
  {
  public:
    /** Parameters of a member of the family. */
    struct Coefficients
    {
      double alpha_m, alpha_f, beta, gamma;
    };

    /** The member with these @p coefficients. */
    AlphaFamily(const std::string &name, const Coefficients &coefficients);

    /** Newmark (1959); second order for gamma = 1/2 only. */
    static Coefficients newmark(double beta, double gamma);

    /** Hilber, Hughes & Taylor (1977), @p alpha in [-1/3, 0]. */
    static Coefficients hht(double alpha);

    /** Chung & Hulbert (1993) from the spectral radius at infinity, in [0, 1].
     */
    static Coefficients generalized_alpha(double spectral_radius);

    const Coefficients &coefficients() const
    {
      return c;
    }

    void predict(const State &from, double dt, State &to) const override;
    TangentFactors factors(const State &from, double dt) const override;
    void           correct(const State  &from,
                           const Vector &increment,
                           double        dt,
                           State        &trial) const override;

    bool propagates_alternating_errors() const override
    {
      return c.gamma == 0.5 && !uses_algorithmic_acceleration();
    }

    bool uses_algorithmic_acceleration() const override
    {
      return c.alpha_m != 0 || c.alpha_f != 0;
    }

    /**
     * Follows from the Taylor series of the formulas above. a_n is v' at the
     * time delta dt after t_n, delta = alpha_m - alpha_f, so that c = beta +
     * delta / 2 - 1/6. The order is two for gamma = 1/2 - delta.
     */
    std::optional<double> error_constant() const override;

    bool keeps_massless_in_equilibrium() const override
    {
      return c.gamma == 2 * c.beta;
    }

  private:
    /** Sets rates of unknowns without mass in a step of @p dt to @p trial. */
    void settle_massless(const State &from, double dt, State &trial) const;

    void settle_acceleration(unsigned int unknown,
                             double       acceleration,
                             State       &trial) const;

    Coefficients c;
  };
} // namespace auxfem

#endif
