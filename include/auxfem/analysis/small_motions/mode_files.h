#ifndef auxfem_analysis_small_motions_mode_files_h
#define auxfem_analysis_small_motions_mode_files_h

#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/buckling_modes.h>
#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/analysis/small_motions/natural_modes.h>
#include <auxfem/output/output_folder.h>

namespace auxfem
{
  /**
   * Files that mode analyses of any kind write besides log.txt and
   * summary.json.
   */
  FolderContents mode_contents();

  /**
   * Writes modes.csv, complex_modes.csv, buckling.csv or relaxations.csv with
   * its column reference. Called on the first rank.
   */
  ///@{
  void write_mode_table(const NaturalModes &found, const std::string &folder);
  void write_mode_table(const ComplexModes &found, const std::string &folder);
  void write_mode_table(const BucklingModes &found, const std::string &folder);
  void write_mode_table(const Relaxations &found, const std::string &folder);
  ///@}

  /** Table of the modes for the screen, without the final line break. */
  ///@{
  std::string mode_table_text(const NaturalModes &found,
                              unsigned int        dimension);
  std::string mode_table_text(const ComplexModes &found);
  std::string mode_table_text(const BucklingModes &found);
  std::string mode_table_text(const Relaxations &found);
  ///@}

  /** Entry of the modes in summary.json. */
  ///@{
  Json json_of(const NaturalModes &found);
  Json json_of(const ComplexModes &found);
  Json json_of(const BucklingModes &found);
  Json json_of(const Relaxations &found);
  ///@}

  /** A mode shape to be drawn. */
  struct ModePicture
  {
    const Vector &shape;
    /** Angular frequency (rad/s); 0 without vibration. */
    double angular_frequency = 0;
    /** Imaginary part of a complex mode, whose real part is the shape. */
    const Vector *imaginary = nullptr;
  };

  /**
   * Writes graphics of one period of mode @p number (from 1 on) about the
   * solution of @p run; their times are fractions of the period. Returns the
   * names of the series. Collective.
   */
  std::vector<std::string> write_mode_pictures(const LatticeRun  &run,
                                               const ModePicture &mode,
                                               unsigned int       number);
} // namespace auxfem

#endif
