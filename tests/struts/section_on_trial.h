#ifndef auxfem_tests_struts_section_on_trial_h
#define auxfem_tests_struts_section_on_trial_h

#include <auxfem/struts/material.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace auxfem
{
  /** The law of a material with these entries in `Materials/NAME`. */
  inline std::unique_ptr<SectionLaw>
  make_law(const RegistryEntry<SectionLaw>          &entry,
           const std::map<std::string, std::string> &entries)
  {
    Parameters parameters = material_parameters();
    for (const Parameter &parameter : entry.parameters)
      parameters.push_back(parameter);
    ParameterValues values(parameters);
    for (const auto &[name, value] : entries)
      values.set(name, value);
    return entry.make(values);
  }

  /** History of a Gauss point. */
  class StoredHistory
  {
  public:
    StoredHistory(const unsigned int n_internal, const unsigned int n_kept)
      : n_internal(n_internal)
    {
      values.fill(std::vector<double>(n_internal + n_kept, 0.));
    }

    SectionHistory view() const
    {
      SectionHistory history;
      for (std::size_t lane = 0; lane < n_lanes; ++lane)
        {
          history.internal_values[lane] = values[lane].data();
          history.kept_values[lane]     = values[lane].data() + n_internal;
        }
      return history;
    }

    SectionHistoryOutput output()
    {
      SectionHistoryOutput history;
      for (std::size_t lane = 0; lane < n_lanes; ++lane)
        {
          history.internal_values[lane] = values[lane].data();
          history.kept_values[lane]     = values[lane].data() + n_internal;
        }
      return history;
    }

  private:
    unsigned int                   n_internal;
    LaneArray<std::vector<double>> values;
  };

  /** A Gauss point with @p n strains that takes steps. */
  template <unsigned int n>
  struct SectionOnTrial
  {
    SectionOnTrial(const SectionLaw                &law,
                   const std::array<StrainType, n> &types,
                   const std::array<Lanes, n>      &stiffness)
      : law(law)
      , types(types)
      , stiffness(stiffness)
      , radii(radii_of(stiffness))
      , committed(law.n_internal(point()), law.n_kept(point()))
    {}

    SectionPoint point() const
    {
      return {n, types.data(), stiffness.data(), radii.data()};
    }

    /** Takes a step to @p strains and keeps its history. */
    SectionResponse step(const SectionStep &step, const Lanes (&strains)[n])
    {
      SectionResponse            response;
      StoredHistory              end    = committed;
      const SectionHistoryOutput output = end.output();
      law.update(step)->evaluate(point(),
                                 strains,
                                 committed.view(),
                                 &output,
                                 response);
      lost      = law.losses(step)->lost(point(), committed.view(), end.view());
      committed = end;
      return response;
    }

    SectionResponse evaluate(const SectionStep &step,
                             const Lanes (&strains)[n]) const
    {
      SectionResponse response;
      law.update(step)->evaluate(point(),
                                 strains,
                                 committed.view(),
                                 nullptr,
                                 response);
      return response;
    }

    SectionInstant instant(const Lanes (&strains)[n]) const
    {
      StoredHistory              rates  = committed;
      const SectionHistoryOutput output = rates.output();
      SectionInstant             now;
      law.instant(point(), strains, committed.view(), &output, now);
      return now;
    }

    static std::array<Lanes, n> radii_of(const std::array<Lanes, n> &stiffness)
    {
      using std::sqrt;
      std::array<Lanes, n> radii;
      for (unsigned int k = 0; k < n; ++k)
        radii[k] = sqrt(Lanes(stiffness[k] / stiffness[0]));
      return radii;
    }

    const SectionLaw               &law;
    const std::array<StrainType, n> types;
    const std::array<Lanes, n>      stiffness, radii;
    StoredHistory                   committed;
    Lanes                           lost = 0; ///< in the last step
  };
} // namespace auxfem

#endif
