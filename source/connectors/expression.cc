#include <auxfem/connectors/connector_law.h>
#include <auxfem/parameters/expression.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace auxfem
{
  namespace
  {
    /** Derivative of @p f at @p x by fourth-order differences of the width @p
     * h. */
    template <class Function>
    double derivative(const Function &f, const double x, const double h)
    {
      return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) /
        (12 * h);
    }

    /** Mean of @p f between @p a and @p b by five Gauss points. */
    template <class Function>
    double gauss_mean(const Function &f, const double a, const double b)
    {
      static const std::array<std::pair<double, double>, 5> points = {
        {{-0.9061798459386640, 0.1184634425280945},
         {-0.5384693101056831, 0.2393143352496832},
         {0, 0.2844444444444444},
         {0.5384693101056831, 0.2393143352496832},
         {0.9061798459386640, 0.1184634425280945}}};
      double mean = 0;
      for (const auto &[place, weight] : points)
        mean += weight * f((a + b) / 2 + place * (b - a) / 2);
      return mean;
    }

    /** Sizes of a motion, for differences. */
    struct MotionScale
    {
      double extension; ///< m
      double rate;      ///< m/s
    };

    /**
     * Force F(u, v) of extension u and its rate v as a formula. The force
     * F(u, 0) without rate counts as elastic: its work is the stored energy,
     * the internal variable. The work of F(u, v) - F(u, 0) is lost, or gained
     * if the formula drives the motion.
     */
    class ExpressionLaw : public ConnectorLaw
    {
    public:
      using Constants = std::vector<Expression::Constant>;

      /** @param has_rate whether @p text contains v and v counts */
      ExpressionLaw(const std::string &text,
                    const Constants   &constants,
                    const bool         has_rate,
                    const MotionScale &scale)
        : text(text)
        , constants(constants)
        , has_rate(has_rate)
        , scale(scale)
        , formula(text, {{"u", &u}, {"v", &v}}, {}, constants)
      {}

      unsigned int n_history() const override
      {
        return 1;
      }

      bool is_linear() const override
      {
        return false;
      }

      bool is_viscous() const override
      {
        return has_rate;
      }

      bool has_kinks() const override
      {
        return true;
      }

      void evaluate(const unsigned int     n,
                    const ConnectorMotion *motion,
                    const double          *committed,
                    double                *trial,
                    ConnectorResponse     *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            const double extension = motion[i].extension;
            trial[i]               = committed[i] + elastic_work(motion[i]);
            response[i] = tangents(extension, has_rate ? motion[i].rate : 0.);
          }
      }

      void evaluate_stage(const unsigned int     n,
                          const ConnectorMotion *motion,
                          const double          *base,
                          double                *trial,
                          ConnectorResponse     *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            const double extension = motion[i].extension;
            trial[i] =
              base[i] + motion[i].dt * force(extension, 0) * motion[i].rate;
            response[i] = tangents(extension, has_rate ? motion[i].rate : 0.);
          }
      }

      void evaluate_mean(const unsigned int     n,
                         const ConnectorMotion *motion,
                         const double          *committed,
                         double                *trial,
                         ConnectorResponse     *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            const ConnectorMotion &m = motion[i];
            trial[i]                 = committed[i] + elastic_work(m);
            const auto mean          = [&](const double end) {
              return mean_force(m.previous_extension,
                                end,
                                (end - m.previous_extension) / m.dt);
            };
            const double rate = (m.extension - m.previous_extension) / m.dt;
            double       h    = width(m.extension);
            if (has_rate)
              h = std::min(h, rate_width(rate) * m.dt);
            response[i] = {mean(m.extension),
                           derivative(mean, m.extension, h),
                           0};
          }
      }

      void evaluate_relaxed(const unsigned int     n,
                            const ConnectorMotion *motion,
                            const double          *committed,
                            double                *trial,
                            ConnectorResponse     *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            trial[i]    = committed[i] + elastic_work(motion[i]);
            response[i] = relaxed(motion[i].extension);
          }
      }

      ConnectorEnergy energy(const ConnectorMotion &motion,
                             const double * /*committed*/,
                             const double *trial) const override
      {
        const double increment = motion.extension - motion.previous_extension;
        // A step of length zero dissipates nothing.
        if (increment == 0 || !has_rate)
          return {*trial, 0};
        return {*trial,
                mean_force(motion.previous_extension,
                           motion.extension,
                           increment / motion.dt) *
                    increment -
                  elastic_work(motion)};
      }

      ContinuousResponse continuous(const double  extension,
                                    const double  rate,
                                    const double *internal,
                                    double       *internal_rates) const override
      {
        const double elastic = force(extension, 0);
        const double whole   = has_rate ? force(extension, rate) : elastic;
        *internal_rates      = elastic * rate;
        return {whole, *internal, (whole - elastic) * rate};
      }

      ConnectorResponse relaxed(const double extension) const override
      {
        return {force(extension, 0), stiffness(extension, 0), 0};
      }

      std::unique_ptr<ConnectorLaw> without_viscosity() const override
      {
        return std::make_unique<ExpressionLaw>(text, constants, false, scale);
      }

      std::complex<double>
      dynamic_stiffness(const std::complex<double> s,
                        const double               extension) const override
      {
        const ConnectorResponse response = tangents(extension, 0);
        return response.stiffness + s * response.damping;
      }

    private:
      /** Width of differences over the size of the motion: fourth-order
       * differences lose least digits near the fifth root of round-off. */
      static constexpr double relative_width = 1e-3;

      double force(const double extension, const double rate) const
      {
        u = extension;
        v = rate;
        return formula.value();
      }

      /** Width of differences of the extension (m). */
      double width(const double extension) const
      {
        return relative_width * std::max(std::abs(extension), scale.extension);
      }

      /** Width of differences of the rate (m/s). */
      double rate_width(const double rate) const
      {
        return relative_width * std::max(std::abs(rate), scale.rate);
      }

      double stiffness(const double extension, const double rate) const
      {
        return derivative([&](const double x) { return force(x, rate); },
                          extension,
                          width(extension));
      }

      ConnectorResponse tangents(const double extension,
                                 const double rate) const
      {
        return {
          force(extension, rate),
          stiffness(extension, rate),
          has_rate
            ? derivative([&](const double x) { return force(extension, x); },
                         rate,
                         rate_width(rate))
            : 0.};
      }

      /** Mean force over a way at a constant rate (N). */
      double
      mean_force(const double from, const double to, const double rate) const
      {
        const double counted = has_rate ? rate : 0.;
        return gauss_mean([&](const double x) { return force(x, counted); },
                          from,
                          to);
      }

      /** Growth of the stored energy in a step (J). */
      double elastic_work(const ConnectorMotion &motion) const
      {
        return gauss_mean([&](const double x) { return force(x, 0); },
                          motion.previous_extension,
                          motion.extension) *
          (motion.extension - motion.previous_extension);
      }

      const std::string text;
      const Constants   constants;
      const bool        has_rate;
      const MotionScale scale;
      mutable double    u = 0, v = 0; ///< variables of the formula
      const Expression  formula;
    };

    const Text force_formula{
      "Force",
      "",
      "Formula of the force (N) by the extension u (m) and its rate v (m/s); "
      "the work of the force at v = 0 counts as stored, the rest as lost.",
      /*required=*/true};

    const Quantity typical_extension{
      "Typical extension",
      "1 mm",
      "m",
      Range::positive(),
      "Size of extensions; differences of a thousandth of it give the tangent "
      "near rest."};

    const Quantity typical_rate{"Typical rate",
                                "1 mm/s",
                                "m/s",
                                Range::positive(),
                                "Size of rates of extension, likewise."};

    /** Whether @p text is a formula without the variable v. */
    bool has_no_rate(const std::string                       &text,
                     const std::vector<Expression::Constant> &constants)
    {
      double u = 0;
      try
        {
          Expression(text, {{"u", &u}}, {}, constants);
          return true;
        }
      catch (const ExpressionError &)
        {
          return false;
        }
    }

    std::unique_ptr<ConnectorLaw> make_expression(ParameterValues &values)
    {
      const std::string                        text = values[force_formula];
      const std::vector<Expression::Constant> &constants =
        values.context.constants;
      try
        {
          auto law = std::make_unique<ExpressionLaw>(
            text,
            constants,
            !has_no_rate(text, constants),
            MotionScale{values[typical_extension], values[typical_rate]});
          if (!std::isfinite(law->relaxed(0).force))
            values.refuse(force_formula,
                          "it has no finite value at u = 0, v = 0, where the "
                          "motion begins. Choose a formula that has one");
          return law;
        }
      catch (const ExpressionError &error)
        {
          values.refuse(force_formula,
                        std::string(error.what()) + "\n" + error.allowed);
        }
    }
  } // namespace

  RegistryEntry<ConnectorLaw> expression_entry()
  {
    return {"expression",
            "Force by a formula of extension and rate.",
            {force_formula, typical_extension, typical_rate},
            make_expression};
  }
} // namespace auxfem
