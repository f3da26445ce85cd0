#ifndef auxfem_analysis_division_table_h
#define auxfem_analysis_division_table_h

#include <auxfem/analysis/mesh_error.h>

#include <limits>
#include <vector>

namespace auxfem
{
  /**
   * Errors that the struts would have with other elements, in the motion in
   * which each needs them most, and which elements to take of those: as few
   * unknowns as possible with which the errors of all add up to no more than is
   * wanted.
   */
  class DivisionTable
  {
  public:
    /**
     * @param scene, model must outlive the object.
     * @param seen what a run of them looked at
     * @param wanted sum of the errors (J, as the square of the energy norm) of
     *   all ranks' struts
     * Collective.
     */
    DivisionTable(const Scene        &scene,
                  const LatticeModel &model,
                  const MeshError    &seen,
                  double              wanted);

    /** Elements to take, of MeshError::struts() of this rank. */
    std::vector<StrutDivision> chosen() const;

    /** Sum of the errors (J) of all ranks' struts with these. */
    double sum_of_errors() const
    {
      return sum_with(allowed);
    }

  private:
    struct Candidate
    {
      StrutDivision division;
      double        error; ///< J
    };

    /** What is known of a strut. */
    struct OfStrut
    {
      std::vector<Candidate> candidates;
      /** Nodes of the cheapest that is good enough in any case; invalid_index:
       * there is none yet. */
      unsigned int n_inner_nodes = invalid_index;
      /** Smallest error (J) so far, and with fewer elements. */
      double error = std::numeric_limits<double>::infinity(), former = error;
      /** How often more elements gained nothing, one after the other. */
      unsigned int n_in_vain = 0;

      const Candidate &best(double allowed) const;
    };

    void   try_number(unsigned int n_elements, double share);
    void   try_division(const StrutDivision &division, double share);
    double sum_with(double allowed) const;
    double find_allowed(double wanted) const;

    const Scene         &scene;
    const LatticeModel  &model;
    const MeshError     &seen;
    std::vector<OfStrut> of_struts; ///< by MeshError::struts()
    double               allowed;   ///< error (J) of one strut
  };
} // namespace auxfem

#endif
