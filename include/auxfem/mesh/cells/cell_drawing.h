#ifndef auxfem_mesh_cells_cell_drawing_h
#define auxfem_mesh_cells_cell_drawing_h

#include <auxfem/mesh/cell.h>
#include <auxfem/parameters/registry.h>

#include <string>

namespace auxfem
{
  /**
   * Draws a unit cell by positions: joints at the same place are one joint,
   * struts between the same joints one strut. What neighbours draw as well is
   * united by make_array().
   */
  class CellDrawing
  {
  public:
    /** @param size of the cell (m), for the tolerance of positions */
    explicit CellDrawing(double size) : tolerance(1e-9 * size)
    {}

    /** Number of the joint at @p position (m), a new one if there is none. */
    unsigned int joint(const dealii::Point<3> &position);

    /** As above in the plane. */
    unsigned int joint(const double x, const double y)
    {
      return joint(dealii::Point<3>(x, y, 0));
    }

    /** A strut between joints @p a and @p b, in the strut set @p set.
     * @param sagitta rise of an arc (m), as UnitStrut::sagitta */
    void strut(unsigned int       a,
               unsigned int       b,
               const std::string &set,
               double             sagitta = 0);

    /** As above between positions. */
    void strut(const dealii::Point<3> &a,
               const dealii::Point<3> &b,
               const std::string      &set)
    {
      strut(joint(a), joint(b), set);
    }

    /** A strut from joint @p a to joint @p b of the cell @p shift cells
     * further. */
    void strut_across(unsigned int              a,
                      unsigned int              b,
                      const std::array<int, 3> &shift,
                      const std::string        &set);

    /** The cell with a @p period (m) along x, y, z; 0: none. */
    UnitCell repeated(const dealii::Tensor<1, 3> &period) const;

    UnitCell cell;

  private:
    const double tolerance; ///< of positions (m)
  };

  /** Parameter `Strut length` of cells whose struts are equally long. */
  const Quantity &equal_strut_length();

  /** Throws InputError if the scene is planar: the cell @p name is not. */
  void require_space(const std::string &name, const SceneContext &context);
} // namespace auxfem

#endif
