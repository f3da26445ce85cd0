#include <auxfem/struts/fibres.h>
#include <auxfem/struts/material.h>
#include <auxfem/struts/section_law.h>
#include <auxfem/struts/yield_curve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace auxfem
{
  namespace
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

    class ElasticPlasticUpdate : public SectionUpdate
    {
    public:
      ElasticPlasticUpdate(const FibreSections &sections,
                           const SectionStep   &step)
        : sections(sections)
        , curve(sections.curve)
        , step(step)
      {}

      AUXFEM_FLATTEN void evaluate(const SectionPoint         &point,
                                   const Lanes                *strains,
                                   const SectionHistory       &committed,
                                   const SectionHistoryOutput *end,
                                   SectionResponse &response) const override
      {
        const FibrePoint fibres(point, sections.of(point));
        Lanes            start[max_section_strains];
        start_strains(point, committed, start);
        const NormalStrains before = fibres.normal(start),
                            now    = fibres.normal(strains);
        const Lanes reach          = fibres.reach(before, now),
                    slack =
                      curve.initial() - committed.kept(fibres.layout.used());
        if (is_frozen() || !any_of(reach > slack))
          stay_elastic(fibres, strains, committed, reach, end, response);
        else
          flow(fibres, strains, before, now, committed, end, response);
        if (end != nullptr)
          for (unsigned int k = 0; k < point.n_strains; ++k)
            end->set_kept(fibres.layout.strain(k), strains[k]);
        if (step.kind == SectionStep::Kind::mean)
          for (unsigned int k = 0; k < point.n_strains; ++k)
            response.forces[k] =
              (response.forces[k] +
               point.stiffness[k] *
                 (start[k] - committed.kept(fibres.layout.plastic(k)))) /
              2;
      }

      void start_strains(const SectionPoint   &point,
                         const SectionHistory &committed,
                         Lanes                *strains) const override
      {
        for (unsigned int k = 0; k < point.n_strains; ++k)
          strains[k] = committed.kept(k);
      }

    private:
      /** Whether no time passes in which a material that depends on the rate
       * could flow. */
      bool is_frozen() const
      {
        return curve.depends_on_rate() && step.dt == 0 &&
          step.kind == SectionStep::Kind::end;
      }

      /** A step in which no fibre yields, known without their history. */
      void stay_elastic(const FibrePoint           &fibres,
                        const Lanes                *strains,
                        const SectionHistory       &committed,
                        const Lanes                &reach,
                        const SectionHistoryOutput *end,
                        SectionResponse            &response) const
      {
        const FibreHistory &layout = fibres.layout;
        Lanes               plastic[max_section_strains];
        for (unsigned int k = 0; k < layout.n_strains; ++k)
          {
            plastic[k]          = committed.kept(layout.plastic(k));
            response.tangent[k] = fibres.point.stiffness[k];
            for (unsigned int l = 0; l < layout.n_strains; ++l)
              response.coupling[k][l] = 0;
          }
        fibres.set_forces(strains,
                          plastic,
                          committed.kept(layout.stored()),
                          response);
        if (end == nullptr)
          return;
        for (unsigned int i = layout.n_strains; i < layout.size(); ++i)
          end->set_kept(i, committed.kept(i));
        end->set_kept(layout.used(), committed.kept(layout.used()) + reach);
      }

      /** A step in which fibres may yield: return mapping in each. */
      void flow(const FibrePoint           &fibres,
                const Lanes                *strains,
                const NormalStrains        &before,
                const NormalStrains        &now,
                const SectionHistory       &committed,
                const SectionHistoryOutput *end,
                SectionResponse            &response) const
      {
        using std::abs, std::max, std::copysign;
        const FibreSection &section                   = fibres.section;
        const FibreHistory &layout                    = fibres.layout;
        const double        back                      = 1 + curve.kinematic();
        Lanes               force[max_normal_strains] = {},
              tangent[max_normal_strains][max_normal_strains] = {}, stored = 0,
              lost = 0, used = 0;
        for (unsigned int i = 0; i < section.n_fibres(); ++i)
          {
            const Lanes plastic = committed.kept(layout.fibre_plastic(i)),
                        accumulated =
                          committed.kept(layout.fibre_accumulated(i)),
                        strain = fibres.fibre_strain(i, now),
                        trial  = strain - back * plastic;
            const YieldCurve::Flow flow =
              curve.flow(abs(trial), accumulated, step.dt);
            const Lanes increment            = copysign(flow.increment, trial),
                        yielded              = plastic + increment,
                        stress               = strain - yielded;
            Lanes slope                      = 1;
            where(flow.increment > 0, slope) = flow.slope / (1 + flow.slope);
            const double weight              = section.weights[i];
            const auto  &arm                 = section.arms[i];
            for (unsigned int m = 0; m < section.n_normal(); ++m)
              {
                force[m] += weight * arm[m] * stress;
                for (unsigned int l = 0; l <= m; ++l)
                  tangent[m][l] += weight * arm[m] * arm[l] * slope;
              }
            stored += weight * back / 2 * yielded * yielded;
            if (end == nullptr)
              continue;
            // The mean stress of both ends does the work; kinematic hardening
            // stores a part of it.
            lost += weight * increment *
              (fibres.fibre_strain(i, before) + strain -
               back * (plastic + yielded)) /
              2;
            const Lanes hardened = accumulated + flow.increment;
            used                 = max(used,
                       Lanes(curve.initial() - curve.stress(hardened) +
                             abs(strain - back * yielded)));
            end->set_kept(layout.fibre_plastic(i), yielded);
            end->set_kept(layout.fibre_accumulated(i), hardened);
          }
        Lanes plastic[max_section_strains];
        set_response(fibres, strains, force, tangent, plastic, response);
        fibres.set_forces(strains, plastic, stored, response);
        if (end == nullptr)
          return;
        for (unsigned int k = 0; k < layout.n_strains; ++k)
          end->set_kept(layout.plastic(k), plastic[k]);
        end->set_kept(layout.used(), used);
        end->set_kept(layout.stored(), stored);
        end->set_kept(layout.lost(), committed.kept(layout.lost()) + lost);
      }

      /** Sets the tangents of @p response and the @p plastic strains of the
       * section from sums over the fibres. */
      static void set_response(
        const FibrePoint &fibres,
        const Lanes      *strains,
        const Lanes (&force)[max_normal_strains],
        const Lanes (&tangent)[max_normal_strains][max_normal_strains],
        Lanes           *plastic,
        SectionResponse &response)
      {
        const unsigned int n_strains = fibres.layout.n_strains;
        const Lanes       *stiffness = fibres.point.stiffness;
        for (unsigned int k = 0; k < n_strains; ++k)
          {
            plastic[k]          = 0;
            response.tangent[k] = stiffness[k];
            for (unsigned int l = 0; l < n_strains; ++l)
              response.coupling[k][l] = 0;
          }
        const auto &normal = fibres.section.normal_strains;
        for (unsigned int m = 0; m < normal.size(); ++m)
          {
            const unsigned int k = normal[m];
            plastic[k]           = strains[k] - force[m] / fibres.radii[m];
            response.tangent[k]  = stiffness[k] * tangent[m][m];
            for (unsigned int l = 0; l < m; ++l)
              response.coupling[k][normal[l]] =
                response.coupling[normal[l]][k] = fibres.axial() *
                fibres.radii[m] * fibres.radii[l] * tangent[m][l];
          }
      }

      const FibreSections &sections;
      const YieldCurve    &curve;
      const SectionStep    step;
    };

    class ElasticPlasticLosses : public SectionLosses
    {
    public:
      explicit ElasticPlasticLosses(const FibreSections &sections)
        : sections(sections)
      {}

      Lanes lost(const SectionPoint   &point,
                 const SectionHistory &committed,
                 const SectionHistory &accepted) const override
      {
        const FibrePoint   fibres(point, sections.of(point));
        const unsigned int lost = fibres.layout.lost();
        return fibres.axial() * (accepted.kept(lost) - committed.kept(lost));
      }

    private:
      const FibreSections &sections;
    };

    /** Material that yields, in sections of one shape. */
    class ElasticPlastic : public SectionLaw
    {
    public:
      ElasticPlastic(const SectionShape &shape,
                     const FibreNumbers &numbers,
                     const YieldCurve   &curve)
        : numbers(numbers)
        , sections{{plane_fibres(shape, numbers), {0, 2}},
                   {space_fibres(shape, numbers), {0, 4, 5}},
                   curve}
      {}

      std::shared_ptr<const SectionLaw>
      in_shape(const SectionShape &shape) const override
      {
        return std::make_shared<ElasticPlastic>(shape, numbers, sections.curve);
      }

      bool is_linear() const override
      {
        return false;
      }

      bool couples_strains() const override
      {
        return true;
      }

      bool yields() const override
      {
        return true;
      }

      bool starts_relaxed() const override
      {
        return true;
      }

      unsigned int n_internal(const SectionPoint & /*point*/) const override
      {
        return 0;
      }

      unsigned int n_kept(const SectionPoint &point) const override
      {
        return FibreHistory(point.n_strains, sections.of(point).n_fibres())
          .size();
      }

      std::unique_ptr<SectionUpdate>
      update(const SectionStep &step) const override
      {
        return std::make_unique<ElasticPlasticUpdate>(sections, step);
      }

      std::unique_ptr<SectionLosses>
      losses(const SectionStep & /*step*/) const override
      {
        return std::make_unique<ElasticPlasticLosses>(sections);
      }

      void instant(const SectionPoint   &point,
                   const Lanes          *strains,
                   const SectionHistory &history,
                   const SectionHistoryOutput * /*rates*/,
                   SectionInstant &instant) const override
      {
        const FibrePoint fibres(point, sections.of(point));
        Lanes            plastic[max_section_strains];
        for (unsigned int k = 0; k < point.n_strains; ++k)
          {
            plastic[k]          = history.kept(fibres.layout.plastic(k));
            instant.relaxing[k] = 0;
          }
        fibres.set_forces(strains,
                          plastic,
                          history.kept(fibres.layout.stored()),
                          instant);
        instant.relaxing_stored = instant.lost_power = 0;
      }

      double long_time_ratio(const StrainType /*type*/) const override
      {
        return 1;
      }

      std::map<double, double>
      relaxing_ratios(const StrainType /*type*/) const override
      {
        return {};
      }

    private:
      const FibreNumbers  numbers;
      const FibreSections sections;
    };

    const Quantity yield_stress = {
      "Yield stress",
      "",
      "Pa",
      Range::positive(),
      "Stress at which the material begins to yield, in tension and "
      "compression."};
    const QuantityList plastic_strains = {
      "Plastic strains",
      "",
      "1",
      Range::positive(),
      0,
      std::numeric_limits<unsigned int>::max(),
      "Accumulated plastic strains of a hardening table, rising; empty: no "
      "isotropic hardening."};
    const QuantityList flow_stresses = {
      "Flow stresses",
      "",
      "Pa",
      Range::positive(),
      0,
      std::numeric_limits<unsigned int>::max(),
      "Yield stress at each of Plastic strains, linear between them from Yield "
      "stress on and constant beyond the last."};
    const Quantity kinematic_modulus = {
      "Kinematic hardening modulus",
      "0 Pa",
      "Pa",
      Range::non_negative(),
      "Back stress over plastic strain: the yield stress after a reversal falls "
      "by twice the back stress."};
    const Quantity reference_rate = {
      "Reference strain rate",
      "none",
      "1/s",
      Range::positive(),
      "Rate D of Cowper and Symonds, at which the yield stress doubles: it is "
      "multiplied by 1 + (plastic strain rate / D)^(1/n); none: no dependence "
      "on the rate.",
      {"none"}};
    const Quantity rate_exponent = {"Rate exponent",
                                    "5",
                                    "1",
                                    {1, 100, true, true},
                                    "Exponent n of Cowper and Symonds."};
    const Integer  layers        = {
              "Layers",
              16,
              2,
              200,
              "Number of layers across the height, in the plane."};
    const Integer section_rings = {
      "Rings",
      4,
      1,
      50,
      "Number of rings through the radius of circles in space, and of tubes."};
    const Integer section_angles = {
      "Angles",
      16,
      4,
      200,
      "Number of points around circles and tubes in space."};
    const Integer section_grid = {
      "Grid",
      8,
      2,
      50,
      "Number of points along each side of rectangles in space."};

    YieldCurve read_yield_curve(const ParameterValues &values)
    {
      const double                   E = values[youngs_modulus_parameter()];
      std::vector<YieldCurve::Point> points  = {{0, values[yield_stress] / E}};
      const std::vector<double>      strains = values[plastic_strains],
                                stresses     = values[flow_stresses];
      if (strains.size() != stresses.size())
        values.refuse("Plastic strains has " + std::to_string(strains.size()) +
                      " values, Flow stresses has " +
                      std::to_string(stresses.size()) +
                      ". Each strain needs one stress: give lists of equal "
                      "length");
      for (std::size_t i = 0; i < strains.size(); ++i)
        {
          if (!(strains[i] > points.back().plastic_strain))
            values.refuse(
              plastic_strains,
              "strains must rise. Sort the table by strain and give "
              "the stress at plastic strain 0 as Yield stress");
          if (stresses[i] / E < points.back().stress)
            values.refuse(
              flow_stresses,
              "stresses must not fall: softening localizes in single "
              "points of the mesh, so that results depend on it. "
              "Let the table end at its largest stress");
          points.push_back({strains[i], stresses[i] / E});
        }
      std::optional<YieldCurve::Rate> rate;
      if (!values.is_word(reference_rate))
        rate = {values[reference_rate], values[rate_exponent]};
      return {points, values[kinematic_modulus] / E, rate};
    }

    std::unique_ptr<SectionLaw> make_elastic_plastic(ParameterValues &values)
    {
      return std::make_unique<ElasticPlastic>(
        SectionShape{SectionShape::Kind::rectangle, 0},
        FibreNumbers{values[layers],
                     values[section_rings],
                     values[section_angles],
                     values[section_grid]},
        read_yield_curve(values));
    }
  } // namespace

  RegistryEntry<SectionLaw> elastic_plastic_entry()
  {
    return {
      "elastic-plastic",
      "Material that yields (von Mises): sections are divided into fibres "
      "in uniaxial stress; shear and torsion stay elastic.",
      {yield_stress,
       plastic_strains,
       flow_stresses,
       kinematic_modulus,
       reference_rate,
       rate_exponent,
       layers,
       section_rings,
       section_angles,
       section_grid},
      make_elastic_plastic};
  }
} // namespace auxfem
