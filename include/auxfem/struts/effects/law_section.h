#ifndef auxfem_struts_effects_law_section_h
#define auxfem_struts_effects_law_section_h

#include <auxfem/struts/beam_2d.h>
#include <auxfem/struts/beam_3d_strains.h>
#include <auxfem/struts/section_law.h>

/**
 * @file
 * Sections of the beam kernels whose forces come from a SectionLaw.
 */
namespace auxfem
{
  namespace Beam2D
  {
    /** Section whose response comes from @p PointLaw, see PointLaw below. */
    template <class PointLaw>
    struct LawSection
    {
      /** Stiffness that the damping of high frequencies acts on. */
      StiffnessOf<Lanes> stiffness;
      const PointLaw     law;

      ResponseOf<Lanes> response(const int g, const StrainsOf<Lanes> &e) const
      {
        const SectionResponse r = respond(g, e);
        return {forces(r), r.stored};
      }

      using Linearized = LinearizedOf<Lanes, CoupledStiffnessOf<Lanes>>;

      Linearized linearized(const int g, const StrainsOf<Lanes> &e) const
      {
        const SectionResponse r = respond(g, e);
        Linearized            result;
        result.forces = forces(r);
        static_cast<StiffnessOf<Lanes> &>(
          result.stiffness) = {r.tangent[0], r.tangent[1], r.tangent[2], 0};
        result.stiffness.is_coupled = r.is_coupled;
        if (result.stiffness.is_coupled)
          {
            result.stiffness.axial_shear   = r.coupling[0][1];
            result.stiffness.axial_bending = r.coupling[0][2];
            result.stiffness.shear_bending = r.coupling[1][2];
          }
        return result;
      }

      ResponseOf<Lanes> mean(const int               g,
                             const StrainsOf<Lanes> &start,
                             const StrainsOf<Lanes> &increment) const
      {
        return response(g, end(start, increment));
      }

      Linearized mean_linearized(const int               g,
                                 const StrainsOf<Lanes> &start,
                                 const StrainsOf<Lanes> &increment) const
      {
        return linearized(g, end(start, increment));
      }

    private:
      static StrainsOf<Lanes> end(const StrainsOf<Lanes> &start,
                                  const StrainsOf<Lanes> &increment)
      {
        return {start.epsilon + increment.epsilon,
                start.gamma + increment.gamma,
                start.kappa + increment.kappa};
      }

      SectionResponse respond(const int g, const StrainsOf<Lanes> &e) const
      {
        const Lanes strains[] = {e.epsilon, e.gamma, e.kappa};
        return law.respond(g, strains);
      }

      static ForcesOf<Lanes> forces(const SectionResponse &r)
      {
        return {r.forces[0], r.forces[1], r.forces[2]};
      }
    };
  } // namespace Beam2D

  namespace Beam3D
  {
    /** @copydoc Beam2D::LawSection */
    template <class PointLaw>
    struct LawSection
    {
      /** Stiffness that the damping of high frequencies acts on. */
      StiffnessOf<Lanes> stiffness;
      const PointLaw     law;

      ResponseOf<Lanes> response(const int               g,
                                 const StrainsOf<Lanes> &strains) const
      {
        const SectionResponse r = respond(g, strains);
        return {forces(r), r.stored};
      }

      using Linearized = LinearizedOf<Lanes, CoupledStiffnessOf<Lanes>>;

      Linearized linearized(const int g, const StrainsOf<Lanes> &strains) const
      {
        const SectionResponse r = respond(g, strains);
        const Lanes          *t = r.tangent;
        Linearized            result;
        result.forces = forces(r);
        static_cast<StiffnessOf<Lanes> &>(
          result.stiffness)         = {t[0], t[1], t[2], t[3], t[4], t[5]};
        result.stiffness.is_coupled = r.is_coupled;
        if (result.stiffness.is_coupled)
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              {
                const auto entry = [&](const unsigned int k,
                                       const unsigned int l) {
                  return k == l ? t[k] : r.coupling[k][l];
                };
                result.stiffness.by_gamma[i][j]       = entry(i, j);
                result.stiffness.gamma_by_kappa[i][j] = entry(i, 3 + j);
                result.stiffness.by_kappa[i][j]       = entry(3 + i, 3 + j);
              }
        return result;
      }

      ResponseOf<Lanes> mean(const int g,
                             const StrainsOf<Lanes> & /*start*/,
                             const StrainsOf<Lanes> &end,
                             const StrainsOf<Lanes> &added) const
      {
        ResponseOf<Lanes> r = response(g, end);
        add(added, r.forces);
        return r;
      }

      Linearized mean_linearized(const int g,
                                 const StrainsOf<Lanes> & /*start*/,
                                 const StrainsOf<Lanes> &end,
                                 const StrainsOf<Lanes> &added) const
      {
        Linearized r = linearized(g, end);
        add(added, r.forces);
        return r;
      }

      ForcesOf<Lanes> elastic_forces(const StrainsOf<Lanes> &strains) const
      {
        return ElasticSection<Lanes>{stiffness}.elastic_forces(strains);
      }

    private:
      void add(const StrainsOf<Lanes> &added, ForcesOf<Lanes> &forces) const
      {
        const ForcesOf<Lanes> elastic = elastic_forces(added);
        forces.force += elastic.force;
        forces.moment += elastic.moment;
      }

      SectionResponse respond(const int g, const StrainsOf<Lanes> &e) const
      {
        const Lanes strains[] = {e.gamma[0],
                                 e.gamma[1],
                                 e.gamma[2],
                                 e.kappa[0],
                                 e.kappa[1],
                                 e.kappa[2]};
        return law.respond(g, strains);
      }

      static ForcesOf<Lanes> forces(const SectionResponse &r)
      {
        const Lanes *f = r.forces;
        return {VectorOf<Lanes>({f[0], f[1], f[2]}),
                VectorOf<Lanes>({f[3], f[4], f[5]})};
      }
    };
  } // namespace Beam3D
} // namespace auxfem

#endif
