#include <auxfem/struts/fibre_sections.h>
#include <auxfem/struts/material.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace auxfem
{
  namespace
  {
    /** Material that yields, in sections of one shape. */
    class ElasticPlastic : public SectionLaw
    {
    public:
      /** Parameters for sections of any shape. */
      struct Material
      {
        FibreNumbers  numbers;
        YieldCurve    curve;
        FailureLimits limits;
        /** Time of failure (s), if struts may break. */
        std::optional<double> failure_time;
        /** Over Young's modulus; 0: shear and torsion stay elastic. */
        double shear_modulus;
      };

      ElasticPlastic(const SectionShape &shape, const Material &material)
        : material(material)
        , sections{
            {plane_fibres(shape, material.numbers), 3, material.shear_modulus},
            {space_fibres(shape, material.numbers), 6, material.shear_modulus},
            material.curve,
            material.limits}
      {}

      SectionShape needed_shape(const SectionShape &shape) const override
      {
        // Proportions of rectangles matter in torsion only.
        const bool needs_ratio =
          shape.kind == SectionShape::Kind::tube || material.shear_modulus > 0;
        return {shape.kind, needs_ratio ? shape.ratio : 0};
      }

      std::shared_ptr<const SectionLaw>
      in_shape(const SectionShape &shape) const override
      {
        return std::make_shared<ElasticPlastic>(shape, material);
      }

      bool is_linear() const override
      {
        return false;
      }

      std::optional<double> yield_strain() const override
      {
        return sections.curve.initial();
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
        return FibreHistory(sections.of(point)).size();
      }

      std::unique_ptr<SectionUpdate>
      update(const SectionStep &step) const override
      {
        return make_elastic_plastic_update(sections, step);
      }

      std::unique_ptr<SectionLosses>
      losses(const SectionStep & /*step*/) const override
      {
        return make_elastic_plastic_losses(sections);
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

      SectionYielding yielding(const SectionPoint   &point,
                               const Lanes          *strains,
                               const SectionHistory &history) const override
      {
        return yielding_of_fibres(sections, point, strains, history);
      }

      std::optional<double> failure_time() const override
      {
        return material.failure_time;
      }

      std::optional<double> largest_plastic_strain() const override
      {
        return sections.curve.end_of_table();
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
      const Material      material;
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
    const Quantity rate_exponent  = {"Rate exponent",
                                     "5",
                                     "1",
                                     {1, 100, true, true},
                                     "Exponent n of Cowper and Symonds."};
    const Quantity failure_strain = {
      "Failure strain",
      "none",
      "1",
      Range::positive(),
      "Accumulated plastic strain of a fibre at which its strut breaks and "
      "loses its forces and then its contact; none: never.",
      {"none"}};
    const Quantity failure_stress = {
      "Failure stress",
      "none",
      "Pa",
      Range::positive(),
      "Tensile stress of a fibre at which its strut breaks; with a larger Yield "
      "stress the material is brittle.",
      {"none"}};
    const Quantity failure_time = {
      "Failure time",
      "none",
      "s",
      Range::positive(),
      "Time in which a strut that breaks loses its forces; several time steps.",
      {"none"}};
    const Choice shear_and_torsion = {
      "Shear and torsion",
      "elastic",
      {"elastic", "yield"},
      "elastic: fibres yield by their axial stress alone, as in slender struts "
      "that bend; yield: by von Mises' stress of axial, shear and torsional "
      "stresses, at three times the time."};
    const Integer layers = {
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
      const double E = read_youngs_modulus(values, example_of_youngs_modulus);
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

    void read_failure(const ParameterValues    &values,
                      ElasticPlastic::Material &material)
    {
      if (!values.is_word(failure_strain))
        material.limits.plastic_strain = values[failure_strain];
      if (!values.is_word(failure_stress))
        material.limits.stress = values[failure_stress] /
          read_youngs_modulus(values, example_of_youngs_modulus);
      const bool may_fail =
        !values.is_word(failure_strain) || !values.is_word(failure_stress);
      if (may_fail && values.is_word(failure_time))
        values.refuse(failure_time,
                      "with Failure strain or Failure stress it must be given. "
                      "Choose about ten time steps");
      if (!may_fail && !values.is_word(failure_time))
        values.refuse(failure_time,
                      "struts do not break without Failure strain or Failure "
                      "stress. Give one of them, or remove Failure time");
      if (may_fail)
        material.failure_time = values[failure_time];
    }

    std::unique_ptr<SectionLaw> make_elastic_plastic(ParameterValues &values)
    {
      ElasticPlastic::Material material{
        {values[layers],
         values[section_rings],
         values[section_angles],
         values[section_grid]},
        read_yield_curve(values),
        {},
        {},
        values[shear_and_torsion] == "yield"
          ? 1 / (2 * (1 + values[poissons_ratio_parameter()]))
          : 0.};
      read_failure(values, material);
      return std::make_unique<ElasticPlastic>(
        SectionShape{SectionShape::Kind::rectangle, 0},
        material);
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
       shear_and_torsion,
       failure_strain,
       failure_stress,
       failure_time,
       layers,
       section_rings,
       section_angles,
       section_grid},
      make_elastic_plastic};
  }
} // namespace auxfem
