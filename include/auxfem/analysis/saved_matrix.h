#ifndef auxfem_analysis_saved_matrix_h
#define auxfem_analysis_saved_matrix_h

#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/model/numbering.h>
#include <auxfem/time/records.h>

#include <string>

namespace auxfem
{
  /**
   * Keeps the blocks of @p matrix and its further diagonal in @p records, known
   * by the serial numbers of their unknowns. Collective.
   * @param name begins the names of the records
   */
  void save_matrix(const std::string   &name,
                   const TangentMatrix &matrix,
                   const DofNumbering  &numbering,
                   Records             &records);

  /**
   * Fills @p matrix with what save_matrix() has kept, to the last digit. Throws
   * InputError if a block is missing. Collective.
   */
  void resume_matrix(const std::string  &name,
                     const DofNumbering &numbering,
                     const Records      &records,
                     TangentMatrix      &matrix);
} // namespace auxfem

#endif
