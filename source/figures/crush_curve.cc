#include <auxfem/figures/crush_curve.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Stress and work at a strain between points of a loading curve. */
    class CurveAt
    {
    public:
      CurveAt(const CrushCurve &loading, const double strain)
      {
        const auto after = std::lower_bound(loading.strain.begin() + 1,
                                            loading.strain.end() - 1,
                                            strain) -
          loading.strain.begin();
        const double from = loading.strain[after - 1];
        const double part = (strain - from) / (loading.strain[after] - from);
        stress =
          (1 - part) * loading.stress[after - 1] + part * loading.stress[after];
        // Work of the straight line, and a share of what loops in between add.
        const double straight =
          (loading.stress[after - 1] + loading.stress[after]) / 2 *
          (loading.strain[after] - from);
        const double loops =
          loading.work[after] - loading.work[after - 1] - straight;
        work = loading.work[after - 1] +
          (loading.stress[after - 1] + stress) / 2 * (strain - from) +
          part * loops;
      }

      double stress, work;
    };

    /** Largest stress up to a strain. */
    double largest_stress(const CrushCurve &loading, const double strain)
    {
      double largest = CurveAt(loading, strain).stress;
      for (std::size_t i = 0;
           i < loading.strain.size() && loading.strain[i] <= strain;
           ++i)
        largest = std::max(largest, loading.stress[i]);
      return largest;
    }

    bool reaches(const CrushCurve &loading, const double strain)
    {
      return loading.strain.front() <= strain &&
        strain <= loading.strain.back();
    }

    double mean_stress_at_equal_steps(const CrushCurve   &loading,
                                      const CrushOptions &options)
    {
      constexpr double   step  = 0.001; // ISO 13314
      const double       range = options.plateau_end - options.plateau_begin;
      const unsigned int n     = std::max(1L, std::lround(range / step));
      double             sum   = 0;
      for (unsigned int i = 0; i <= n; ++i)
        sum += CurveAt(loading, options.plateau_begin + i * range / n).stress;
      return sum / (n + 1);
    }

    /** First strain from @p begin on at which stress crosses @p level. */
    std::optional<double> strain_of_stress(const CrushCurve &loading,
                                           const double      begin,
                                           const double      level)
    {
      double strain = begin, stress = CurveAt(loading, begin).stress;
      if (stress >= level)
        return begin;
      for (std::size_t i = 0; i < loading.strain.size(); ++i)
        {
          if (loading.strain[i] <= begin)
            continue;
          if (loading.stress[i] >= level)
            return strain +
              (loading.strain[i] - strain) * (level - stress) /
              (loading.stress[i] - stress);
          strain = loading.strain[i];
          stress = loading.stress[i];
        }
      return std::nullopt;
    }

    void add_plateau(const CrushCurve   &loading,
                     const CrushOptions &options,
                     CrushFigures       &figures)
    {
      if (!reaches(loading, options.plateau_begin) ||
          !reaches(loading, options.plateau_end))
        return;
      constexpr double end_over_plateau = 1.3; // ISO 13314
      figures.plateau_stress = mean_stress_at_equal_steps(loading, options);
      figures.plateau_end =
        strain_of_stress(loading,
                         options.plateau_end,
                         end_over_plateau * *figures.plateau_stress);
      if (!figures.plateau_end)
        return;
      const double end            = *figures.plateau_end;
      figures.work_to_plateau_end = CurveAt(loading, end).work;
      figures.efficiency_at_plateau_end =
        *figures.work_to_plateau_end / (largest_stress(loading, end) * end);
    }

    void add_densification(const CrushCurve   &loading,
                           const CrushOptions &options,
                           CrushFigures       &figures)
    {
      const std::vector<double> eta = efficiencies(loading, options);
      // The last one of several equal maxima.
      const std::size_t onset =
        eta.rend() - std::max_element(eta.rbegin(), eta.rend()) - 1;
      if (onset + 1 >= eta.size() || eta[onset] <= 0)
        return;
      const double strain = loading.strain[onset], work = loading.work[onset];
      figures.densification_strain  = strain;
      figures.efficiency            = eta[onset];
      figures.work_to_densification = work;
      const double at_yield = options.yield_strain > loading.strain.front()
        ? CurveAt(loading, options.yield_strain).work
        : 0;
      figures.plateau_stress_by_energy =
        (work - at_yield) / (strain - options.yield_strain);
      figures.ideality               = work / (loading.stress[onset] * strain);
      figures.peak_stress            = largest_stress(loading, strain);
      figures.crush_force_efficiency = work / strain / figures.peak_stress;
    }
  } // namespace

  void CrushCurve::add(const double next_strain, const double next_stress)
  {
    work.push_back(strain.empty() ? 0
                                  : work.back() +
                       (next_strain - strain.back()) *
                         (next_stress + stress.back()) / 2);
    strain.push_back(next_strain);
    stress.push_back(next_stress);
  }

  CrushCurve loading_part(const CrushCurve &curve)
  {
    CrushCurve loading;
    for (std::size_t i = 0; i < curve.strain.size(); ++i)
      if (loading.strain.empty() || curve.strain[i] > loading.strain.back())
        {
          loading.strain.push_back(curve.strain[i]);
          loading.stress.push_back(curve.stress[i]);
          loading.work.push_back(curve.work[i]);
        }
    return loading;
  }

  std::vector<double> efficiencies(const CrushCurve   &loading,
                                   const CrushOptions &options)
  {
    std::vector<double> eta(loading.strain.size(), 0);
    if (eta.size() < 2 || loading.strain.back() <= options.yield_strain)
      return eta;
    const double at_yield = options.yield_strain > loading.strain.front()
      ? CurveAt(loading, options.yield_strain).work
      : 0;
    for (std::size_t i = 0; i < eta.size(); ++i)
      if (loading.strain[i] > options.yield_strain && loading.stress[i] > 0)
        eta[i] = (loading.work[i] - at_yield) / loading.stress[i];
    return eta;
  }

  CrushFigures crush_figures(const CrushCurve   &curve,
                             const CrushOptions &options)
  {
    CrushFigures     figures;
    const CrushCurve loading = loading_part(curve);
    figures.work_at_end      = curve.work.back();
    figures.largest_strain   = loading.strain.back();
    figures.work_to_largest  = loading.work.back();
    figures.peak_stress =
      *std::max_element(loading.stress.begin(), loading.stress.end());
    if (loading.strain.size() < 2)
      return figures;
    add_plateau(loading, options, figures);
    add_densification(loading, options, figures);
    return figures;
  }
} // namespace auxfem
