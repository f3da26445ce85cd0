#ifndef auxfem_output_support_moments_h
#define auxfem_output_support_moments_h

#include <auxfem/equations/equations.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/scene/scene.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Moments of supports about points that are fixed in space: those of their
   * forces, at the present places of the joints where rotations are large, and
   * those on rotations. Columns `S.moment`, in space `S.moment_x` and so on.
   */
  class SupportMoments
  {
  public:
    /** @param equations must outlive the object */
    SupportMoments(const Scene &scene, const Equations &equations);

    std::vector<Column> columns() const;

    /** This rank's share of each column (N m), to be summed over the ranks. */
    std::vector<double> values(const State &state) const;

  private:
    struct Part
    {
      std::string      name;
      unsigned int     support; ///< in LatticeModel::supports
      dealii::Point<3> point;   ///< m
    };

    /** Present place (m) of @p joint. */
    dealii::Point<3> position(unsigned int joint, const State &state) const;

    const Equations  &equations;
    std::vector<Part> parts;
  };
} // namespace auxfem

#endif
