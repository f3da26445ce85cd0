#ifndef auxfem_mesh_periodic_array_h
#define auxfem_mesh_periodic_array_h

#include <auxfem/mesh/cell.h>

#include <array>
#include <vector>

namespace auxfem
{
  /** A joint of an infinite lattice outside of the period, which moves as one
   * in it but for the mean deformation. */
  struct JointImage
  {
    unsigned int       joint; ///< the image
    unsigned int       base;  ///< the joint in the period
    std::array<int, 3> shift; ///< from the base to the image, in periods
  };

  /** How a lattice goes on beyond its joints. */
  struct Periodicity
  {
    /** Translations of the period; those of the plane are the first two (m). */
    std::vector<dealii::Tensor<1, 3>> vectors;
    std::vector<JointImage>           images;

    /** Area (m2) or volume (m3) of the period. */
    double volume() const;

    /** Side of a square or cube of this size (m). */
    double length() const;

    /** Vectors (1/m) whose products with a position are its parts of the
     * translations. */
    std::vector<dealii::Tensor<1, 3>> reciprocal_vectors() const;

    /** Translation by @p shift periods (m). */
    dealii::Tensor<1, 3> translation(const std::array<int, 3> &shift) const;
  };

  /** One period of an infinite lattice: its struts, each once, with their end
   * joints in neighbouring periods. */
  struct PeriodicArray
  {
    Lattice     lattice;
    Periodicity periodicity;
  };

  /**
   * The period of @p n_cells cells of an infinite lattice. Joints are united by
   * translations, not by position alone, and parts that cells share are there
   * once. Sets of joints contain images; there are no sets of sides. Throws
   * InputError if the cell has no vector in one of @p dimension directions.
   */
  PeriodicArray make_periodic_array(const UnitCell                    &cell,
                                    const std::array<unsigned int, 3> &n_cells,
                                    unsigned int dimension);
} // namespace auxfem

#endif
