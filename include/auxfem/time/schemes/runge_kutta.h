#ifndef auxfem_time_schemes_runge_kutta_h
#define auxfem_time_schemes_runge_kutta_h

#include <auxfem/time/schemes/time_scheme.h>

#include <complex>
#include <vector>

namespace auxfem
{
  /**
   * Coefficients of an ESDIRK scheme, stiffly accurate: the first stage is the
   * start of the step, the others are implicit with equal diagonal
   * coefficients, and the last is the solution. At stage i, at the time t_n +
   * c_i dt,
   *
   * @code
   * y_i = y_n + dt sum_{j < i} a_ij y'_j + gamma dt y'_i
   * @endcode
   */
  struct ButcherTableau
  {
    std::vector<double>              times;   ///< c_i, in [0, 1]
    std::vector<std::vector<double>> factors; ///< a_ij, j <= i
    std::vector<double>              weights; ///< b_i = a_si
    /** b_i minus those of the embedded scheme of the order below. */
    std::vector<double> embedded_difference;
    double              diagonal; ///< gamma
    unsigned int        order;

    unsigned int n_stages() const
    {
      return times.size();
    }

    /**
     * b_i a_ij + b_j a_ji - b_i b_j (K. Burrage & J. C. Butcher, SIAM J.
     * Numer. Anal. 16 (1979) 46-57). By it the scheme misses the growth of a
     * quadratic form: with the power y'.M y at the stages,
     *
     * @code
     * dt sum_i b_i y_i.M y'_i = (y_{n+1}.M y_{n+1} - y_n.M y_n) / 2
     *                           + dt^2 / 2 sum_ij m_ij y'_i.M y'_j
     * @endcode
     */
    double missed_growth(unsigned int i, unsigned int j) const;

    /**
     * The oscillation exp(iz) at the stages of a step with the phase z = @p
     * angle (rad).
     */
    std::vector<std::complex<double>> oscillation(double angle) const;
  };

  /**
   * The tableau of order 3, 4 or 5: ESDIRK3(2)5L[2]SA and ESDIRK5(4)7L[2]SA2
   * of C. A. Kennedy & M. H. Carpenter, Appl. Numer. Math. 146 (2019) 221-244,
   * and ARK4(3)6L[2]SA of the same, Appl. Numer. Math. 44 (2003) 139-181, all
   * as in SUNDIALS. They are L-stable, of stage order 2, and have no stage
   * beyond the step's end.
   */
  ButcherTableau esdirk_tableau(unsigned int order);

  /**
   * A stage of an implicit Runge-Kutta scheme. With the contributions of
   * earlier stages as the base, it is a backward Euler step over gamma dt,
   *
   * @code
   * v = v_base + gamma dt a,   u = u_base + gamma dt v
   * @endcode
   *
   * Here `from` is the base, with a predicted acceleration, and the step
   * length is gamma dt.
   */
  class RungeKutta : public ImplicitScheme
  {
  public:
    RungeKutta(const std::string &name, const ButcherTableau &tableau);

    void predict(const State &from, double dt, State &to) const override;

    TangentFactors factors(const State & /*from*/,
                           const double dt) const override
    {
      return {1., 1 / dt, 1 / (dt * dt)};
    }

    void correct(const State  &from,
                 const Vector &increment,
                 double        dt,
                 State        &trial) const override;

    /** Rigid parts are constrained in position. */
    std::optional<std::string> note_on_rigid_parts() const override;

    const ButcherTableau *stages() const override
    {
      return &tableau;
    }

    unsigned int order() const override
    {
      return tableau.order;
    }

    double amplification(double angle) const override;

    /**
     * For an oscillation of phase z in a step the differences yield 4
     * sin^2(z/2) / 12 of z; the scheme misses |R(iz) - exp(iz)| / z.
     */
    double missed_phase(double by_trapezoidal_rule) const override;

    double error_by_difference(double angle) const override;

    /** Only up to order 4. */
    bool estimates_errors() const override;

  private:
    const ButcherTableau tableau;
  };
} // namespace auxfem

#endif
