#include <auxfem/connectors/elastic_law.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Force curve with a dashpot in parallel: F = f(u) + (C + c |f(u)|)
     * du/dt. */
    class ElasticLaw : public ConnectorLaw
    {
    public:
      ElasticLaw(std::shared_ptr<const ForceCurve> curve,
                 const ElasticLawDamping          &damping)
        : curve(std::move(curve))
        , damping(damping)
      {}

      bool is_linear() const override
      {
        return false;
      }

      bool is_viscous() const override
      {
        return damping.constant > 0 || damping.per_force > 0;
      }

      bool has_kinks() const override
      {
        return curve->has_kinks();
      }

      void evaluate(const unsigned int     n,
                    const ConnectorMotion *motion,
                    const double * /*committed*/,
                    double * /*trial*/,
                    ConnectorResponse *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          response[i] =
            with_dashpot(curve->at(motion[i].extension), motion[i].rate);
      }

      void evaluate_mean(const unsigned int     n,
                         const ConnectorMotion *motion,
                         const double * /*committed*/,
                         double * /*trial*/,
                         ConnectorResponse *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            const ConnectorMotion &m = motion[i];
            response[i] =
              with_dashpot(curve->mean(m.previous_extension, m.extension),
                           (m.extension - m.previous_extension) / m.dt);
            response[i].stiffness += response[i].damping / m.dt;
            response[i].damping = 0;
          }
      }

      /** The dissipation uses the means of rate and elastic force. */
      ConnectorEnergy energy(const ConnectorMotion &motion,
                             const double * /*committed*/,
                             const double * /*trial*/) const override
      {
        const double stored    = curve->energy(motion.extension);
        const double increment = motion.extension - motion.previous_extension;
        // A step of length zero dissipates nothing.
        if (increment == 0 || !is_viscous())
          return {stored, 0};
        const double force =
          curve->mean(motion.previous_extension, motion.extension).force;
        return {stored, coefficient(force) * increment * increment / motion.dt};
      }

      ContinuousResponse continuous(const double extension,
                                    const double rate,
                                    const double * /*internal*/,
                                    double * /*internal_rates*/) const override
      {
        const double force   = curve->at(extension).force;
        const double viscous = coefficient(force) * rate;
        return {force + viscous, curve->energy(extension), viscous * rate};
      }

      ConnectorResponse relaxed(const double extension) const override
      {
        const ForceCurve::Value value = curve->at(extension);
        return {value.force, value.stiffness, 0};
      }

      std::unique_ptr<ConnectorLaw> without_viscosity() const override
      {
        return make_elastic_law(curve);
      }

      std::complex<double>
      dynamic_stiffness(const std::complex<double> s,
                        const double               extension) const override
      {
        const ForceCurve::Value value = curve->at(extension);
        return value.stiffness + s * coefficient(value.force);
      }

    private:
      /** Damping coefficient (N s/m) at an elastic force (N). */
      double coefficient(const double force) const
      {
        return damping.constant + damping.per_force * std::abs(force);
      }

      /** Force and tangents by extension and rate. */
      ConnectorResponse with_dashpot(const ForceCurve::Value &elastic,
                                     const double             rate) const
      {
        const double c = coefficient(elastic.force);
        return {elastic.force + c * rate,
                elastic.stiffness *
                  (1 + std::copysign(damping.per_force, elastic.force) * rate),
                c};
      }

      const std::shared_ptr<const ForceCurve> curve;
      const ElasticLawDamping                 damping;
    };
  } // namespace

  PiecewiseLinearCurve::PiecewiseLinearCurve(const std::vector<Point> &points,
                                             const double              first,
                                             const double              last)
  {
    pieces.push_back({-std::numeric_limits<double>::infinity(),
                      points.front().first,
                      points.front().second,
                      first});
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const auto &[extension, force] = points[i];
        const double stiffness         = i + 1 == points.size()
                  ? last
                  : (points[i + 1].second - force) / (points[i + 1].first - extension);
        pieces.push_back({extension, extension, force, stiffness});
      }
  }

  ForceCurve::Value PiecewiseLinearCurve::at(const double extension) const
  {
    const auto   next      = std::upper_bound(pieces.begin() + 1,
                                       pieces.end(),
                                       extension,
                                       [](const double u, const Piece &piece) {
                                         return u < piece.begin;
                                       });
    const Piece &piece     = *(next - 1);
    double       stiffness = piece.stiffness;
    if (extension == piece.begin)
      stiffness = std::max(stiffness, (next - 2)->stiffness);
    return {piece.force + piece.stiffness * (extension - piece.extension),
            stiffness};
  }

  ForceCurve::Value PiecewiseLinearCurve::mean(const double from,
                                               const double to) const
  {
    Value        mean = at(from);
    const double way  = to - from;
    if (way == 0)
      return {mean.force, mean.stiffness / 2};
    // Integrals of stiffness times the remaining, or the past, part of the way:
    // sums without cancellation, however short the way is.
    mean.stiffness         = 0;
    const auto [low, high] = std::minmax(from, to);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      {
        const double begin = std::max(low, pieces[i].begin);
        const double end =
          i + 1 < pieces.size() ? std::min(high, pieces[i + 1].begin) : high;
        if (!(begin < end))
          continue;
        const double part =
          pieces[i].stiffness * ((end - begin) / std::abs(way));
        const double middle = begin + (end - begin) / 2;
        mean.force += part * (to - middle);
        mean.stiffness += part * ((middle - from) / way);
      }
    return mean;
  }

  bool PiecewiseLinearCurve::has_kinks() const
  {
    return true;
  }

  std::unique_ptr<ConnectorLaw>
  make_elastic_law(std::shared_ptr<const ForceCurve> curve,
                   const ElasticLawDamping          &damping)
  {
    return std::make_unique<ElasticLaw>(std::move(curve), damping);
  }

  const Quantity &parallel_damping()
  {
    static const Quantity parameter{"Damping coefficient",
                                    "0",
                                    "N s/m",
                                    Range::non_negative(),
                                    "Force of a dashpot in parallel per rate "
                                    "of extension."};
    return parameter;
  }

  const Quantity &stop_damping()
  {
    static const Quantity parameter{
      "Stop damping",
      "0",
      "s/m",
      Range::non_negative(),
      "Damping force over elastic force, per rate of extension (Hunt & "
      "Crossley): a free connector does not damp."};
    return parameter;
  }
} // namespace auxfem
