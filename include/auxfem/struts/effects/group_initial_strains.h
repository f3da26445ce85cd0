#ifndef auxfem_struts_effects_group_initial_strains_h
#define auxfem_struts_effects_group_initial_strains_h

#include <auxfem/equations/element_batches.h>
#include <auxfem/equations/evaluation.h>
#include <auxfem/mathematics/lanes.h>
#include <auxfem/model/initial_strains.h>

#include <vector>

namespace auxfem
{
  /** Values of all loads in InitialStrains at one time. */
  using InitialStrainLoads = std::vector<double>;

  /** Initial strains of the elements of one group, whose sections have @p
   * n_strains strains. */
  class GroupInitialStrains
  {
  public:
    /** @param struts strut of each element
     * @param n_strains 3 in the plane, 6 in space */
    GroupInitialStrains(const InitialStrains            &all,
                        const std::vector<unsigned int> &struts,
                        unsigned int                     n_strains);

    /** Whether an element has an initial strain at some time. */
    bool exist() const
    {
      return !groups.empty();
    }

    /** @name Loads at an instant, at the end and at the start of an evaluation.
     */
    ///@{
    InitialStrainLoads at(const State &state) const;
    InitialStrainLoads at_end(const Evaluation &evaluation) const;
    InitialStrainLoads at_start(const Evaluation &step) const;
    ///@}

    /** Rates of the loads by time_of_loads() at the end of an evaluation. */
    InitialStrainLoads rates(const Evaluation &evaluation) const;

    unsigned int n_loads() const
    {
      return groups.size();
    }

    /** Name and history of load @p i. */
    const InitialStrain &load(const unsigned int i) const
    {
      return *groups[i].strain;
    }

    /** Adds @p factor times the strains of a batch under @p loads. */
    void add(double                    factor,
             const InitialStrainLoads &loads,
             const ElementBatch       &batch,
             Lanes                    *strains) const
    {
      for (unsigned int i = 0; i < groups.size(); ++i)
        add_one(i, factor * loads[i], batch, strains);
    }

    /** Adds the strain of a batch by the amount @p value of load @p i. */
    void add_one(const unsigned int  i,
                 const double        value,
                 const ElementBatch &batch,
                 Lanes              *strains) const
    {
      strains[groups[i].index] += value *
        batch.numbers([&](unsigned int e) { return groups[i].factors[e]; });
    }

  private:
    /** One load on the group. */
    struct GroupStrain
    {
      const InitialStrain *strain;
      unsigned int         index;   ///< among the strains of the section
      std::vector<double>  factors; ///< by element
    };

    /** Value of @p history from @p evaluate, 0 before statics raises it. */
    template <class Evaluate>
    InitialStrainLoads values(const State    &state,
                              const Evaluate &evaluate) const;

    std::vector<GroupStrain> groups;
    const bool               raised_from_zero;
  };
} // namespace auxfem

#endif
