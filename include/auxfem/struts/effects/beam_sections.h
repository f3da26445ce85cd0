#ifndef auxfem_struts_effects_beam_sections_h
#define auxfem_struts_effects_beam_sections_h

#include <auxfem/struts/effects/law_sections.h>

/**
 * @file
 * Strains and stiffnesses of beams as LawForces needs them: bases of the Beam
 * of BeamForces. Functions take elements at rest, BeamAtRest.
 */
namespace auxfem
{
  /** Sections of beams in the plane with the strains epsilon, gamma, kappa. */
  struct PlaneSections
  {
    static constexpr unsigned int n_strains = 3;

    /** Type of strain @p k. Shear stiffness that compensates bending relaxes
     * with it. */
    static constexpr StrainType strain_type(const unsigned int k,
                                            const bool shear_is_compensated)
    {
      return k == 1 && !shear_is_compensated ? StrainType::shear
                                             : StrainType::normal;
    }

    template <class AtRest>
    static std::array<Lanes, n_strains>
    stiffness_by_strain(const AtRest &at_rest)
    {
      const auto &s = at_rest.stiffness;
      return {{s.axial, s.shear, s.bending}};
    }

    /** Stiffness with the entry of each strain k times @p factor(k). */
    template <class AtRest, class Factor>
    static Beam2D::StiffnessOf<Lanes> scaled_stiffness(const AtRest &at_rest,
                                                       const Factor &factor)
    {
      const auto &s = at_rest.stiffness;
      return {factor(0) * s.axial,
              factor(1) * s.shear,
              factor(2) * s.bending,
              0};
    }

    static Beam2D::LinearizedOf<Lanes>
    without_forces(const Beam2D::StiffnessOf<Lanes> &stiffness)
    {
      return {{0, 0, 0}, stiffness};
    }

    template <class AtRest, class PointLaw>
    static Beam2D::LawSection<PointLaw> law_section(const AtRest &at_rest,
                                                    PointLaw      law)
    {
      return {at_rest.stiffness, std::move(law)};
    }

    /** Forces by strain in one lane. */
    static SectionForces section_forces(const Lanes *forces)
    {
      return {{lane_value(forces[0], 0),
               lane_value(forces[1], 0),
               0,
               0,
               0,
               lane_value(forces[2], 0)}};
    }
  };

  /** Section stiffness of an element. */
  template <class Number>
  struct SpaceStiffness
  {
    Beam3D::StiffnessOf<Number> elastic;
    Number                      damping_time; ///< s
  };

  /** Sections of beams in space with the strains epsilon, gamma_2, gamma_3,
   * torsion, kappa_2, kappa_3. */
  struct SpaceSections
  {
    static constexpr unsigned int n_strains = 6;

    /** @copydoc PlaneSections::strain_type */
    static constexpr StrainType strain_type(const unsigned int k,
                                            const bool shear_is_compensated)
    {
      const bool is_shear =
        k == 3 || ((k == 1 || k == 2) && !shear_is_compensated);
      return is_shear ? StrainType::shear : StrainType::normal;
    }

    template <class AtRest>
    static const auto &elastic_stiffness(const AtRest &at_rest)
    {
      return at_rest.stiffness.elastic;
    }

    template <class AtRest>
    static std::array<Lanes, n_strains>
    stiffness_by_strain(const AtRest &at_rest)
    {
      const auto &s = elastic_stiffness(at_rest);
      return {
        {s.axial, s.shear_2, s.shear_3, s.torsion, s.bending_2, s.bending_3}};
    }

    /** @copydoc PlaneSections::scaled_stiffness */
    template <class AtRest, class Factor>
    static Beam3D::StiffnessOf<Lanes> scaled_stiffness(const AtRest &at_rest,
                                                       const Factor &factor)
    {
      const auto &s = elastic_stiffness(at_rest);
      return {factor(0) * s.axial,
              factor(1) * s.shear_2,
              factor(2) * s.shear_3,
              factor(3) * s.torsion,
              factor(4) * s.bending_2,
              factor(5) * s.bending_3};
    }

    static Beam3D::LinearizedOf<Lanes>
    without_forces(const Beam3D::StiffnessOf<Lanes> &stiffness)
    {
      return {{}, stiffness};
    }

    template <class AtRest, class PointLaw>
    static Beam3D::LawSection<PointLaw> law_section(const AtRest &at_rest,
                                                    PointLaw      law)
    {
      return {elastic_stiffness(at_rest), std::move(law)};
    }

    /** Section forces of elastic @p strains. */
    template <class Number>
    static SectionForcesOf<Number>
    forces(const SpaceStiffness<Number>    &stiffness,
           const Beam3D::StrainsOf<Number> &strains)
    {
      const VectorOf<Number> force  = Beam3D::section_force(stiffness.elastic,
                                                           strains.gamma),
                             moment = Beam3D::section_moment(stiffness.elastic,
                                                             strains.kappa);
      return {{force[0], force[1], force[2], moment[0], moment[1], moment[2]}};
    }

    /** Product of section @p forces and the strains of @p others (J/m). */
    template <class Number>
    static Number strain_product(const SpaceStiffness<Number>  &stiffness,
                                 const SectionForcesOf<Number> &forces,
                                 const SectionForcesOf<Number> &others)
    {
      const Beam3D::StiffnessOf<Number> &s = stiffness.elastic;
      const Number                       k[] =
        {s.axial, s.shear_2, s.shear_3, s.torsion, s.bending_2, s.bending_3};
      Number sum = 0;
      for (unsigned int i = 0; i < forces.size(); ++i)
        sum += forces[i] * others[i] / k[i];
      return sum;
    }

    /** @copydoc PlaneSections::section_forces */
    static SectionForces section_forces(const Lanes *forces)
    {
      SectionForces result;
      for (unsigned int k = 0; k < n_strains; ++k)
        result[k] = lane_value(forces[k], 0);
      return result;
    }
  };
} // namespace auxfem

#endif
