#ifndef auxfem_analysis_mesh_error_h
#define auxfem_analysis_mesh_error_h

#include <auxfem/equations/held_struts.h>

namespace auxfem
{
  /**
   * Error that the elements of a run make in the motion of the joints,
   * estimated strut by strut at instants of it.
   *
   * Each strut is solved again with its ends held and its acceleration kept, on
   * elements of half the length and one order more. By how much this changes
   * the forces r_s on its ends is what the joints are out of equilibrium by:
   * they move by e = K^-1 sum r_s, K being the stiffness of the lattice. With
   * the stiffness K_s of a strut alone,
   *
   *     e.K e <= sum r_s.K_s^+ r_s,
   *
   * (the energy of a sum of loads on a sum of springs), so what is added up
   * strut by strut is no less than the square of the error in the energy norm,
   * as long as K is that of small motions.
   */
  class MeshError
  {
  public:
    /** @param scene, model must outlive the object. */
    MeshError(const Scene &scene, const LatticeModel &model);

    /** Looks at an instant. Collective. */
    void look(const State &state);

    /**
     * Largest error at one instant in the energy norm, relative to that of the
     * largest motion so far.
     */
    double relative() const;

    /** Twice the largest strain energy so far (J). */
    double largest_energy() const
    {
      return energy;
    }

    /** The struts that this rank counts. */
    const std::vector<unsigned int> &struts() const
    {
      return same.struts();
    }

    /** Of each of struts(), the motion in which its error was largest. */
    const std::vector<StrutMotion> &most_demanding() const
    {
      return motions;
    }

    /** What is remembered of the run so far, to go on with it. */
    ///@{
    std::vector<double> save() const
    {
      return {error, energy};
    }
    void resume(const std::vector<double> &saved)
    {
      error  = saved.at(0);
      energy = saved.at(1);
    }
    ///@}

  private:
    const LatticeModel       &model;
    HeldStruts                same, finer;
    std::vector<unsigned int> first_elements; ///< of the model, by struts()
    std::vector<double>       largest;        ///< errors (J), by struts()
    std::vector<StrutMotion>  motions;
    /** Largest sum of the errors, twice the largest strain energy (J). */
    double error = 0, energy = 0;
  };

  /**
   * Errors (J, as the square of the energy norm) that struts would have with
   * other elements.
   *
   * @param seen the motions that their ends have; errors are not finite where
   *   they are not
   * @param which struts, by their numbers in MeshError::struts()
   */
  std::vector<double> errors_of_division(const Scene                     &scene,
                                         const LatticeModel              &model,
                                         const MeshError                 &seen,
                                         const std::vector<unsigned int> &which,
                                         StrutDivision division);
} // namespace auxfem

#endif
