#ifndef auxfem_struts_fibre_sections_h
#define auxfem_struts_fibre_sections_h

#include <auxfem/struts/section_law.h>
#include <auxfem/struts/yield_curve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace auxfem
{
  /** Largest number of strains that change the length of fibres: axial strain
   * and curvatures. */
  constexpr unsigned int max_normal_strains = 3;

  /** The fibres of a section in the plane or in space. */
  struct FibreSection
  {
    FibreSection(const std::vector<Fibre>        &fibres,
                 const std::vector<unsigned int> &normal_strains)
      : normal_strains(normal_strains)
    {
      for (const Fibre &fibre : fibres)
        {
          weights.push_back(fibre.weight);
          if (normal_strains.size() == 2)
            arms.push_back({1, fibre.arm_3, 0});
          else
            arms.push_back({1, fibre.arm_2, fibre.arm_3});
          for (unsigned int m = 0; m < max_normal_strains; ++m)
            largest_arms[m] =
              std::max(largest_arms[m], std::abs(arms.back()[m]));
        }
    }

    unsigned int n_normal() const
    {
      return normal_strains.size();
    }

    unsigned int n_fibres() const
    {
      return weights.size();
    }

    /** Indices of the axial strain and of the curvatures among the strains.
     */
    const std::vector<unsigned int> normal_strains;
    std::vector<double>             weights;
    /** Strain of a fibre by axial strain and by curvatures, each times its
     * radius of gyration. */
    std::vector<std::array<double, max_normal_strains>> arms;
    std::array<double, max_normal_strains> largest_arms = {{0, 0, 0}};
  };

  /**
   * History at a point, all kept: strains; plastic strains of the section,
   * from which forces are stiffness times (strain - plastic strain); the part
   * of the yield strain that is used up; stored energy at zero strain and
   * lost energy per length, over EA; by fibre plastic and accumulated plastic
   * strain.
   */
  struct FibreHistory
  {
    FibreHistory(const unsigned int n_strains, const unsigned int n_fibres)
      : n_strains(n_strains)
      , n_fibres(n_fibres)
    {}

    unsigned int strain(const unsigned int k) const
    {
      return k;
    }
    unsigned int plastic(const unsigned int k) const
    {
      return n_strains + k;
    }
    unsigned int used() const
    {
      return 2 * n_strains;
    }
    unsigned int stored() const
    {
      return 2 * n_strains + 1;
    }
    unsigned int lost() const
    {
      return 2 * n_strains + 2;
    }
    unsigned int fibre_plastic(const unsigned int i) const
    {
      return 2 * n_strains + 3 + 2 * i;
    }
    unsigned int fibre_accumulated(const unsigned int i) const
    {
      return fibre_plastic(i) + 1;
    }
    unsigned int size() const
    {
      return fibre_plastic(n_fibres);
    }

    const unsigned int n_strains, n_fibres;
  };

  /** Strains that change the length of fibres, times radii of gyration. */
  using NormalStrains = std::array<Lanes, max_normal_strains>;

  /** A Gauss point and the fibres of its section. */
  class FibrePoint
  {
  public:
    FibrePoint(const SectionPoint &point, const FibreSection &section)
      : point(point)
      , section(section)
      , layout(point.n_strains, section.n_fibres())
    {
      using std::sqrt;
      for (unsigned int m = 0; m < section.n_normal(); ++m)
        radii[m] =
          sqrt(Lanes(point.stiffness[section.normal_strains[m]] / axial()));
    }

    /** EA (N). */
    const Lanes &axial() const
    {
      return point.stiffness[section.normal_strains[0]];
    }

    NormalStrains normal(const Lanes *strains) const
    {
      NormalStrains normal;
      for (unsigned int m = 0; m < section.n_normal(); ++m)
        normal[m] = radii[m] * strains[section.normal_strains[m]];
      return normal;
    }

    Lanes fibre_strain(const unsigned int i, const NormalStrains &x) const
    {
      Lanes strain = x[0];
      for (unsigned int m = 1; m < section.n_normal(); ++m)
        strain += section.arms[i][m] * x[m];
      return strain;
    }

    /** Bound of the change of strain of all fibres between two strains. */
    Lanes reach(const NormalStrains &one, const NormalStrains &other) const
    {
      using std::abs;
      Lanes sum = 0;
      for (unsigned int m = 0; m < section.n_normal(); ++m)
        sum += section.largest_arms[m] * abs(one[m] - other[m]);
      return sum;
    }

    /** Sets forces of the strains minus @p plastic ones, and the energy with
     * the part @p stored at zero strain (over EA). */
    template <class Response>
    void set_forces(const Lanes *strains,
                    const Lanes *plastic,
                    const Lanes &stored,
                    Response    &response) const
    {
      response.stored = axial() * stored;
      for (unsigned int k = 0; k < point.n_strains; ++k)
        {
          response.forces[k] = point.stiffness[k] * (strains[k] - plastic[k]);
          response.stored +=
            point.stiffness[k] * strains[k] * (strains[k] / 2 - plastic[k]);
        }
    }

    const SectionPoint &point;
    const FibreSection &section;
    const FibreHistory  layout;
    NormalStrains       radii; ///< 1 and radii of gyration (m)
  };

  /** Sections of a material that yields. */
  struct FibreSections
  {
    const FibreSection &of(const SectionPoint &point) const
    {
      return point.n_strains == 3 ? plane : space;
    }

    FibreSection plane, space;
    YieldCurve   curve;
  };

  /** @name The elastic-plastic law in steps; @p sections must outlive the
   * objects. */
  ///@{
  std::unique_ptr<SectionUpdate>
  make_elastic_plastic_update(const FibreSections &sections,
                              const SectionStep   &step);

  std::unique_ptr<SectionLosses>
  make_elastic_plastic_losses(const FibreSections &sections);
  ///@}
} // namespace auxfem

#endif
