#ifndef auxfem_output_response_files_h
#define auxfem_output_response_files_h

#include <auxfem/output/csv_table.h>
#include <auxfem/output/output_folder.h>

namespace auxfem
{
  /** @name Files of the response of an infinite lattice to a mean deformation:
   * stiffness and Poisson's ratios at each step, and losses of stability */
  ///@{
  FolderContents response_contents();

  std::vector<Column> response_columns(unsigned int dimension);

  std::vector<Column> stability_columns(unsigned int dimension);
  ///@}
} // namespace auxfem

#endif
