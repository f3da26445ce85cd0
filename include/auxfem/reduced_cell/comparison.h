#ifndef auxfem_reduced_cell_comparison_h
#define auxfem_reduced_cell_comparison_h

#include <auxfem/output/output_folder.h>
#include <auxfem/reduced_cell/cell_run.h>

namespace auxfem
{
  /** One scheme on one scene, beside the reference. */
  struct ComparisonRow
  {
    std::string name;   ///< of the scene's file, without folder and ending
    std::string scheme; ///< as in Time/Scheme
    /** At the end, or where the scheme failed; no numbers if it never began. */
    double angle               = 0; ///< theta (rad)
    double lower_rise          = 0; ///< Y2 (m)
    double transmitted         = 0; ///< f2 (N)
    double largest_transmitted = 0; ///< |f2| (N)
    /** Largest error of the energy balance, of the largest energy. */
    double relative_balance = 0;
    /** Largest differences from the reference, of its largest values. */
    double      angle_difference = 0, transmitted_difference = 0;
    std::string exit_state;
  };

  /**
   * Computes @p scene with every scheme of the table; the first one, arkode, is
   * the reference. Failures are in the rows.
   */
  std::vector<ComparisonRow> compare_schemes(const Scene &scene);

  /**
   * Compares the schemes on every one of @p scenes, prints a table and writes
   * it to @p folder/comparison.csv. On the calling rank. Throws InputError for
   * scenes of other models and for a folder that cannot be used, see
   * OutputFolder.
   */
  void run_comparison(const std::vector<Scene> &scenes,
                      const std::string        &folder,
                      const FileRules          &rules);
} // namespace auxfem

#endif
