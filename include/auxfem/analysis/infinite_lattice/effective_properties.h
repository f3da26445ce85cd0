#ifndef auxfem_analysis_infinite_lattice_effective_properties_h
#define auxfem_analysis_infinite_lattice_effective_properties_h

#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/infinite_lattice/elastic_constants.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/scene/run_plan.h>

#include <vector>

namespace auxfem
{
  /** An infinite lattice as a continuum. */
  struct EffectiveProperties
  {
    ElasticConstants elastic;
    /** Volume of struts over that of the period; none if a section has no
     * dimensions. */
    std::optional<double> relative_density;
    /** Mass per volume (kg/m3); none if a section has no density. */
    std::optional<double> density;
    /** Depth of the continuum of a planar lattice: that of its widest section,
     * 1 m if sections have no dimensions (m). */
    double depth = 1;
  };

  /** Plan with a step for each small mean strain of 1, relaxed and without
   * damping. */
  RunPlan plan_of_unit_strains(const Scene &scene);

  /** Mean stress (Pa) of the period at the solution of @p run as a vector.
   * Collective. */
  std::vector<double> mean_stress(const LatticeRun &run);

  /** Properties of the lattice of @p run with this stiffness (Pa). */
  EffectiveProperties
  properties_with(const dealii::FullMatrix<double> &stiffness,
                  const LatticeRun                 &run);

  /**
   * Small-strain properties of the infinite lattice of @p scene: the mean
   * stresses of one period under unit strains. Displacements at opposite joints
   * differ by the mean strain times their distance, rotations are equal. Throws
   * InputError for mechanisms and errors of the scene. Collective.
   */
  EffectiveProperties effective_properties(const Scene &scene,
                                           MPI_Comm     communicator);

  /**
   * Computes effective_properties(), prints them and writes stiffness.csv,
   * directions.csv, modulus.vtu and summary.json. Collective.
   */
  RunResult run_effective_properties(const Scene         &scene,
                                     MPI_Comm             communicator,
                                     const FolderOptions &options);
} // namespace auxfem

#endif
