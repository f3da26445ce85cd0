#ifndef auxfem_model_initial_strains_h
#define auxfem_model_initial_strains_h

#include <auxfem/scene/run_plan.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** Strain that struts would take on if they were free, uniform along each:
   * `history` times a factor. */
  struct InitialStrain
  {
    /** Which strain of a beam. */
    enum class Kind
    {
      axial,
      curvature_2, ///< about axis 2, in space only (1/m)
      curvature_3  ///< about axis 3 (1/m)
    };
    std::string         name; ///< of the load
    Kind                kind;
    TimeFunction        history; ///< of the load
    std::vector<double> factors; ///< strain over load, by strut of the lattice
  };

  /**
   * Initial strains of a scene. Without a static start, statics raises them
   * from zero in the first step.
   */
  struct InitialStrains
  {
    std::vector<InitialStrain> strains;
    bool                       raised_from_zero = false;
  };

  /** Whether a section has struts with initial strains, by section. */
  std::vector<bool> sections_with_initial_strains(const RunPlan &plan,
                                                  const Lattice &lattice);

  /**
   * The loads of Type = temperature and pretension of a scene. Throws
   * InputError for struts that cannot have them: rigid ones, those without
   * Thermal expansion, those with stiffness-proportional damping.
   * @param sections by Strut::section
   */
  InitialStrains make_initial_strains(const RunPlan              &plan,
                                      const Lattice              &lattice,
                                      const std::vector<Section> &sections);
} // namespace auxfem

#endif
