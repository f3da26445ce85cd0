#ifndef auxfem_struts_viscoelastic_step_h
#define auxfem_struts_viscoelastic_step_h

#include <auxfem/struts/prony_series.h>
#include <auxfem/struts/section_law.h>

namespace auxfem
{
  /** One object for each type of strain. */
  template <class T>
  struct ByStrainType
  {
    T normal, shear;

    const T &operator[](const StrainType type) const
    {
      return type == StrainType::normal ? normal : shear;
    }
  };

  /** Both series of a material, with equally many terms. */
  using ModulusSeries = ByStrainType<PronySeries>;

  /**
   * History at a point. Internal variables: by strain the viscous strains of
   * the terms. Kept: the strains and their mean rates (1/s) in the last step.
   */
  struct ViscoelasticHistory
  {
    ViscoelasticHistory(const SectionPoint &point, const ModulusSeries &series)
      : n_strains(point.n_strains)
      , n_terms(series.normal.terms.size())
    {}

    unsigned int viscous(const unsigned int strain,
                         const unsigned int term) const
    {
      return strain * n_terms + term;
    }

    unsigned int strain(const unsigned int k) const
    {
      return k;
    }

    unsigned int rate(const unsigned int k) const
    {
      return n_strains + k;
    }

    const unsigned int n_strains, n_terms;
  };

  /** @name The viscoelastic law in steps; @p series must outlive the objects. */
  ///@{
  std::unique_ptr<SectionUpdate>
  make_viscoelastic_update(const ModulusSeries &series,
                           const SectionStep   &step);

  std::unique_ptr<SectionLosses>
  make_viscoelastic_losses(const ModulusSeries &series,
                           const SectionStep   &step);
  ///@}
} // namespace auxfem

#endif
