#ifndef auxfem_analysis_relative_motion_h
#define auxfem_analysis_relative_motion_h

#include <auxfem/model/lattice_model.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <map>
#include <vector>

namespace auxfem
{
  /**
   * How far struts that are near each other move against each other: a bound
   * from above, by the displacements in each cell of a grid and in the cells
   * around it. What moves a lattice as a whole, or stretches it from end to
   * end, hardly counts.
   */
  class RelativeMotion
  {
  public:
    /** @p model must outlive the object. */
    explicit RelativeMotion(const LatticeModel &model);

    /** Motions count from @p displacement (of all local unknowns) on. */
    void start(const Vector &displacement);

    /** @param name begins the names of the records */
    ///@{
    void save(const std::string &name, Records &records) const;
    void resume(const std::string &name, const Records &records);
    ///@}

    /**
     * Largest distance (m) between the displacements of two nodes since
     * start() whose elements were less than a cell apart then; infinite if that
     * is not known. Collective.
     */
    double largest(const Vector &displacement) const;

  private:
    using Key = std::array<int, 3>;

    /** Of displacements (m). */
    struct Box
    {
      Box();
      void add(const Box &other);

      std::array<double, 3> lower, upper;
    };

    using Cells = std::map<Key, Box>;

    Key   key(const dealii::Point<3> &position) const;
    Cells motions(const Vector &displacement) const;

    const LatticeModel           &model;
    const double                  cell_size; ///< m
    std::vector<dealii::Point<3>> middles;   ///< of elements, at rest
    /** At start(); empty before. */
    Vector                    start_displacement;
    std::vector<Key>          keys;            ///< of cells
    std::vector<unsigned int> cell_of_element; ///< index of a key
  };
} // namespace auxfem

#endif
