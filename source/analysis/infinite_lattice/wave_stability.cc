#include <auxfem/analysis/infinite_lattice/wave_stability.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  const char *name_of(const StabilityLoss::Kind kind)
  {
    switch (kind)
      {
        case StabilityLoss::Kind::long_wave:
          return "long wave";
        case StabilityLoss::Kind::wave:
          return "wave";
        default:
          return "strut";
      }
  }

  namespace
  {
    constexpr unsigned int n_samples = 4;

    /** Lagrange's polynomial through values at times. */
    class Interpolation
    {
    public:
      explicit Interpolation(const std::vector<double> &times) : times(times)
      {}

      /** @param value of sample i */
      template <class Value>
      double at(const double time, const Value &value) const
      {
        double sum = 0;
        for (unsigned int i = 0; i < times.size(); ++i)
          {
            double weight = 1;
            for (unsigned int j = 0; j < times.size(); ++j)
              if (j != i)
                weight *= (time - times[j]) / (times[i] - times[j]);
            sum += weight * value(i);
          }
        return sum;
      }

      /** Zero between the last two times. */
      template <class Value>
      double zero(const Value &value) const
      {
        const double begin = times[times.size() - 2], end = times.back();
        const auto   function = [&](const double time) {
          return at(time, value);
        };
        std::uintmax_t max_evaluations = 100;
        const auto [lower, upper]      = boost::math::tools::toms748_solve(
          function,
          begin,
          end,
          boost::math::tools::eps_tolerance<double>(50),
          max_evaluations);
        return (lower + upper) / 2;
      }

    private:
      const std::vector<double> &times;
    };
  } // namespace

  WaveStability::WaveStability(const unsigned int n,
                               const unsigned int dimension)
    : waves(wave_vectors_of_zone(n, dimension))
  {}

  WaveStiffness WaveStability::record(const double               time,
                                      const PeriodTangent       &tangent,
                                      const std::vector<double> &values,
                                      const MPI_Comm             communicator)
  {
    // Direction of long waves, stability of struts, stiffnesses.
    std::vector<double> found;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        const auto [modulus, direction] = tangent.moduli()
          ? least_acoustic_modulus(*tangent.moduli())
          : std::pair(0., dealii::Tensor<1, 3>());
        found                           = {direction[0],
                                           direction[1],
                                           direction[2],
                 tangent.struts_are_stable() ? 1. : 0.,
                                           modulus};
        for (const WaveVector &wave : waves)
          {
            WavePhases phases;
            for (unsigned int d = 0; d < 3; ++d)
              phases[d] = 2 * dealii::numbers::PI * wave[d];
            found.push_back(tangent.has_contact_between_periods()
                              ? std::numeric_limits<double>::quiet_NaN()
                              : tangent.least_stiffness(phases));
          }
      }
    found = dealii::Utilities::MPI::broadcast(communicator, found);
    Sample sample{time, values, {found.begin() + 4, found.end()}};
    if (at_start.empty())
      {
        at_start = sample.stiffnesses;
        is_lost.assign(at_start.size(), 0.);
      }
    for (unsigned int i = 0; i < at_start.size(); ++i)
      sample.stiffnesses[i] /= at_start[i];
    samples.push_back(sample);
    if (samples.size() > n_samples)
      samples.erase(samples.begin());

    WaveStiffness result;
    result.direction  = dealii::Point<3>(found[0], found[1], found[2]);
    result.long_waves = sample.stiffnesses.front();
    // Waves that symmetry makes equal differ by round-off.
    const auto least =
      std::min_element(sample.stiffnesses.begin() + 1,
                       sample.stiffnesses.end(),
                       [](const double one, const double two) {
                         return one < two - 1e-9 * std::abs(two);
                       });
    const bool exists = least != sample.stiffnesses.end();
    result.waves = exists ? *least : std::numeric_limits<double>::quiet_NaN();
    result.wave =
      exists ? waves[least - sample.stiffnesses.begin() - 1] : WaveVector{};
    find_losses(result.direction);
    if (found[3] == 0 && !strut_is_lost)
      {
        strut_is_lost = true;
        loss_list.push_back({StabilityLoss::Kind::strut, {}, time, values});
      }
    return result;
  }

  void WaveStability::find_losses(const dealii::Tensor<1, 3> &direction)
  {
    std::vector<double> times;
    for (const Sample &sample : samples)
      times.push_back(sample.time);
    const Interpolation        interpolation(times);
    std::vector<StabilityLoss> found;
    for (unsigned int w = 0; w < is_lost.size(); ++w)
      {
        const auto stiffness = [&](const unsigned int i) {
          return samples[i].stiffnesses[w];
        };
        const unsigned int last = samples.size() - 1;
        if (is_lost[w] != 0 || !(stiffness(last) <= 0))
          continue;
        is_lost[w] = 1;
        StabilityLoss loss{w == 0 ? StabilityLoss::Kind::long_wave
                                  : StabilityLoss::Kind::wave,
                           {},
                           times.back(),
                           samples.back().values};
        if (w == 0)
          for (unsigned int d = 0; d < 3; ++d)
            loss.wave[d] = direction[d];
        else
          loss.wave = waves[w - 1];
        if (last > 0 && stiffness(last - 1) > 0 && stiffness(last) < 0)
          {
            loss.time = interpolation.zero(stiffness);
            for (std::size_t v = 0; v < loss.values.size(); ++v)
              loss.values[v] =
                interpolation.at(loss.time, [&](const unsigned int i) {
                  return samples[i].values[v];
                });
          }
        found.push_back(loss);
      }
    std::stable_sort(found.begin(),
                     found.end(),
                     [](const StabilityLoss &one, const StabilityLoss &other) {
                       return one.time < other.time;
                     });
    loss_list.insert(loss_list.end(), found.begin(), found.end());
  }

  void WaveStability::serialize(CheckpointArchive &archive)
  {
    const std::string name = "stability against waves: ";
    archive.list(name + "at the start", at_start);
    archive.list(name + "lost", is_lost);
    archive.values(name + "struts", strut_is_lost);
    unsigned int n = samples.size(), n_losses = loss_list.size();
    archive.values(name + "numbers", n, n_losses);
    samples.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const std::string number = std::to_string(i);
        archive.values(name + "time " + number, samples[i].time);
        archive.list(name + "values " + number, samples[i].values);
        archive.list(name + "stiffnesses " + number, samples[i].stiffnesses);
      }
    loss_list.resize(n_losses);
    for (unsigned int i = 0; i < n_losses; ++i)
      {
        StabilityLoss    &loss   = loss_list[i];
        const std::string number = std::to_string(i);
        unsigned int      kind   = static_cast<unsigned int>(loss.kind);
        archive.values(name + "loss " + number,
                       kind,
                       loss.time,
                       loss.wave[0],
                       loss.wave[1],
                       loss.wave[2]);
        loss.kind = static_cast<StabilityLoss::Kind>(kind);
        archive.list(name + "loss values " + number, loss.values);
      }
  }
} // namespace auxfem
