#include <auxfem/struts/fibre_sections.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Strains of a fibre by a strain of the section, of type and index. */
    std::array<double, max_fibre_strains>
    strains_of(const Fibre       &fibre,
               const unsigned int strain,
               const unsigned int n_strains)
    {
      const auto sheared = [](const std::array<double, 2> &shear) {
        return std::array<double, max_fibre_strains>{{0, shear[0], shear[1]}};
      };
      if (strain == 0)
        return {{1, 0, 0}};
      if (n_strains == 3)
        return strain == 1 ? sheared(fibre.shear_2)
                           : std::array<double, 3>{{fibre.arm_3, 0, 0}};
      switch (strain)
        {
          case 1:
            return sheared(fibre.shear_2);
          case 2:
            return sheared(fibre.shear_3);
          case 3:
            return sheared(fibre.twist);
          default:
            return {{strain == 4 ? fibre.arm_2 : fibre.arm_3, 0, 0}};
        }
    }
  } // namespace

  FibreSection::FibreSection(const std::vector<Fibre> &fibres,
                             const unsigned int        n_strains,
                             const double              shear_modulus)
    : n_strains(n_strains)
    , n_components(shear_modulus == 0 ? 1
                     : n_strains == 3 ? 2
                                      : 3)
    , moduli({{1, shear_modulus, shear_modulus}})
    , equivalents({{1, 3, 3}})
    , strains(fibres.size())
  {
    const bool in_plane = n_strains == 3;
    for (unsigned int k = 0; k < n_strains; ++k)
      {
        const bool is_normal = k == 0 || (in_plane ? k == 2 : k > 3);
        if (!is_normal && shear_modulus == 0)
          continue;
        const double modulus = is_normal ? 1. : shear_modulus;
        Felt         new_felt{k, modulus, 1 / std::sqrt(modulus), 0};
        for (std::size_t i = 0; i < fibres.size(); ++i)
          {
            const auto by_strain = strains_of(fibres[i], k, n_strains);
            double     square    = 0;
            for (unsigned int c = 0; c < n_components; ++c)
              {
                strains[i][c][felt.size()] = by_strain[c];
                square +=
                  equivalents[c] * std::pow(moduli[c] * by_strain[c], 2);
              }
            new_felt.reach = std::max(new_felt.reach, std::sqrt(square));
          }
        felt.push_back(new_felt);
      }
    for (const Fibre &fibre : fibres)
      weights.push_back(fibre.weight);
  }

  SectionYielding yielding_of_fibres(const FibreSections  &sections,
                                     const SectionPoint   &point,
                                     const Lanes          *strains,
                                     const SectionHistory &history)
  {
    using std::abs, std::max, std::sqrt;
    const FibreSection &section = sections.of(point);
    const FibrePoint    fibres(point, section);
    const FeltStrains   x = fibres.felt(strains);
    SectionYielding     largest;
    for (unsigned int i = 0; i < section.n_fibres(); ++i)
      {
        Lanes square = 0, tension = 0, equivalent = 0;
        for (unsigned int c = 0; c < section.n_components; ++c)
          {
            const double modulus = section.moduli[c];
            const Lanes  plastic =
              history.kept(fibres.layout.fibre_plastic(i, c));
            const Lanes elastic =
              modulus * (fibres.fibre_strain(i, c, x) - plastic);
            const Lanes stress = elastic -
              sections.curve.kinematic() / section.equivalents[c] * plastic;
            if (c == 0)
              tension = elastic;
            square += section.equivalents[c] * stress * stress;
            equivalent += section.equivalents[c] * elastic * elastic;
          }
        const Lanes accumulated = history.kept(fibres.layout.accumulated(i));
        largest.plastic_strain  = max(largest.plastic_strain, accumulated);
        largest.equivalent_stress =
          max(largest.equivalent_stress, Lanes(sqrt(equivalent)));
        where(abs(tension) > abs(largest.fibre_stress), largest.fibre_stress) =
          tension;
        largest.utilisation =
          max(largest.utilisation,
              Lanes(sqrt(square) / sections.curve.stress(accumulated)));
        largest.failure =
          max(largest.failure,
              max(Lanes(accumulated / sections.limits.plastic_strain),
                  Lanes(tension / sections.limits.stress)));
      }
    return largest;
  }
} // namespace auxfem
