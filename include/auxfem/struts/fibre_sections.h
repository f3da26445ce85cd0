#ifndef auxfem_struts_fibre_sections_h
#define auxfem_struts_fibre_sections_h

#include <auxfem/struts/section_law.h>
#include <auxfem/struts/yield_curve.h>

#include <array>
#include <limits>
#include <vector>

namespace auxfem
{
  /** Largest number of strains of a fibre: axial, shear along axes 2 and 3. */
  constexpr unsigned int max_fibre_strains = 3;

  /** Strains of a section that its fibres feel, each times a radius (m or 1),
   * see FibrePoint. */
  using FeltStrains = std::array<Lanes, max_section_strains>;

  /** The fibres of a section in the plane or in space. Stresses are over
   * Young's modulus. */
  struct FibreSection
  {
    /**
     * @param n_strains of the section: 3 in the plane, 6 in space
     * @param shear_modulus over Young's modulus if fibres yield in shear; 0:
     *   shear and torsion stay elastic
     */
    FibreSection(const std::vector<Fibre> &fibres,
                 unsigned int              n_strains,
                 double                    shear_modulus);

    unsigned int n_fibres() const
    {
      return weights.size();
    }

    unsigned int n_felt() const
    {
      return felt.size();
    }

    unsigned int n_strains;
    /** Number of strains of a fibre; 1: axial strain alone. */
    unsigned int n_components;
    /** Modulus by component, and its stress in the equivalent stress: 1 and 3
     * times the square. */
    std::array<double, max_fibre_strains> moduli, equivalents;

    /** A strain of the section that fibres feel. */
    struct Felt
    {
      unsigned int strain;     ///< among those of the section
      double       modulus;    ///< of the fibres' strains
      double       per_radius; ///< 1 / sqrt(modulus)
      /** Largest change of the equivalent stress of a fibre by it. */
      double reach;
    };
    /** The axial strain first. */
    std::vector<Felt> felt;

    std::vector<double> weights;
    /** Strains of each fibre, by component and by felt strain. */
    std::vector<
      std::array<std::array<double, max_section_strains>, max_fibre_strains>>
      strains;
  };

  /**
   * History at a point, all kept: strains; plastic strains of the section, from
   * which forces are stiffness times (strain - plastic strain); the part of the
   * yield strain that is used up; stored energy at zero strain and lost energy
   * per length, over EA; by fibre its plastic strains and the accumulated one.
   */
  struct FibreHistory
  {
    explicit FibreHistory(const FibreSection &section)
      : n_strains(section.n_strains)
      , n_components(section.n_components)
      , n_fibres(section.n_fibres())
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
    unsigned int fibre_plastic(const unsigned int i, const unsigned int c) const
    {
      return 2 * n_strains + 3 + (n_components + 1) * i + c;
    }
    unsigned int accumulated(const unsigned int i) const
    {
      return fibre_plastic(i, n_components);
    }
    unsigned int size() const
    {
      return fibre_plastic(n_fibres, 0);
    }

    const unsigned int n_strains, n_components, n_fibres;
  };

  /** A Gauss point and the fibres of its section. */
  class FibrePoint
  {
  public:
    FibrePoint(const SectionPoint &point, const FibreSection &section)
      : point(point)
      , section(section)
      , layout(section)
    {
      for (unsigned int m = 0; m < section.n_felt(); ++m)
        radii[m] =
          section.felt[m].per_radius * point.radii[section.felt[m].strain];
    }

    /** EA (N). */
    const Lanes &axial() const
    {
      return point.stiffness[section.felt[0].strain];
    }

    /** Strains of the section that fibres feel, times their radii: those of
     * gyration for curvatures. */
    FeltStrains felt(const Lanes *strains) const
    {
      FeltStrains felt;
      for (unsigned int m = 0; m < section.n_felt(); ++m)
        felt[m] = radii[m] * strains[section.felt[m].strain];
      return felt;
    }

    /** Strain of component @p c of fibre @p i. */
    Lanes fibre_strain(const unsigned int i,
                       const unsigned int c,
                       const FeltStrains &x) const
    {
      const auto &by_felt = section.strains[i][c];
      Lanes       strain  = by_felt[0] * x[0];
      for (unsigned int m = 1; m < section.n_felt(); ++m)
        strain += by_felt[m] * x[m];
      return strain;
    }

    /** Bound of the change of equivalent stress of all fibres between two
     * strains. */
    Lanes reach(const FeltStrains &one, const FeltStrains &other) const
    {
      using std::abs;
      Lanes sum = 0;
      for (unsigned int m = 0; m < section.n_felt(); ++m)
        sum += section.felt[m].reach * abs(one[m] - other[m]);
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
    /** Radius of gyration of each felt strain (m); 1 for the axial one. */
    FeltStrains radii;
  };

  /** Limits of a fibre beyond which its strut breaks. */
  struct FailureLimits
  {
    double plastic_strain = std::numeric_limits<double>::infinity();
    /** Tensile stress over Young's modulus. */
    double stress = std::numeric_limits<double>::infinity();
  };

  /** Sections of a material that yields. */
  struct FibreSections
  {
    const FibreSection &of(const SectionPoint &point) const
    {
      return point.n_strains == plane.n_strains ? plane : space;
    }

    FibreSection  plane, space;
    YieldCurve    curve;
    FailureLimits limits;
  };

  /** How far the fibres of @p point have yielded. */
  SectionYielding yielding_of_fibres(const FibreSections  &sections,
                                     const SectionPoint   &point,
                                     const Lanes          *strains,
                                     const SectionHistory &history);

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
