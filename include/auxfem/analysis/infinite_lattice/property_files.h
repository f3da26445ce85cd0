#ifndef auxfem_analysis_infinite_lattice_property_files_h
#define auxfem_analysis_infinite_lattice_property_files_h

#include <auxfem/analysis/infinite_lattice/effective_properties.h>
#include <auxfem/output/output_folder.h>

#include <string>

namespace auxfem
{
  /** Files that write_effective_properties() writes. */
  FolderContents effective_property_contents();

  /**
   * Writes to @p folder: stiffness.csv, the matrix; directions.csv, Young's
   * modulus, Poisson's ratios and shear moduli by direction; modulus.vtu, the
   * curve or surface whose distance from its centre is Young's modulus in that
   * direction, for ParaView. Throws on failure as CsvTable.
   */
  void write_effective_properties(const EffectiveProperties &properties,
                                  const std::string         &folder);

  /** Lines for the screen. */
  std::string text_of(const EffectiveProperties &properties);

  /** Members of summary.json. */
  Json json_of(const EffectiveProperties &properties);
} // namespace auxfem

#endif
