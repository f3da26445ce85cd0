#ifndef auxfem_mesh_cell_h
#define auxfem_mesh_cell_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/registry.h>

namespace auxfem
{
  /** One strut of a unit cell and the strut sets it belongs to. */
  struct UnitStrut
  {
    unsigned int first, second;
    /** Rise of the arc over the chord (m), signed as Strut::sagitta. */
    double sagitta = 0;
    /** Names of the strut sets, e.g. `edges`, `stubs`. */
    std::vector<std::string> sets = {};
    /** Unit normal of the arc's plane, as Strut::normal. */
    dealii::Tensor<1, 3> normal = dealii::Point<3>(0, 0, 1);
  };

  /** A joint of a unit cell and a joint of the next cell along an axis. */
  struct NeighbourPair
  {
    unsigned int first; ///< joint of this cell
    /** 0, 1, 2: the next cell is the one at +x, +y, +z. */
    unsigned int direction;
    unsigned int second; ///< joint of the next cell
  };

  /** Straight struts of one strut set between neighbouring cells. */
  struct StrutsAcross
  {
    std::string                set;
    std::vector<NeighbourPair> ends;
  };

  /**
   * One unit cell about its own centre. Repeated with its period, joints that
   * coincide with those of a neighbour become one.
   */
  struct UnitCell
  {
    /** Positions about the cell's centre (m). */
    std::vector<dealii::Point<3>> joints;

    std::vector<UnitStrut> struts;

    /** Struts to the next cell, made wherever that neighbour exists. */
    std::vector<StrutsAcross> struts_across;

    /** Pairs of joints offered for connectors, by name. */
    std::map<std::string, std::vector<std::pair<unsigned int, unsigned int>>>
      pairs;

    /**
     * Pairs for connectors between a cell and the next one, by name; made
     * wherever that neighbour exists.
     */
    std::map<std::string, std::vector<NeighbourPair>> pairs_across;

    /**
     * Distances between cell centres along x, y, z (m); 0: cannot be repeated
     * that way.
     */
    dealii::Tensor<1, 3> period;

    /**
     * For a direction without period, the reason as a sentence to be shown to
     * the user; may be empty.
     */
    std::array<std::string, 3> why_no_period;

    /**
     * Joints through which cells meet, by side (`left`, `right`, `bottom`,
     * `top`, `back`, `front`); on the array's boundary they form the set of
     * that name. Empty: the sets are the joints on the faces of the bounding
     * box, except where joint_sets has a set of that name.
     */
    std::map<std::string, std::vector<unsigned int>> ports;

    /** Further named joints, collected over all cells, e.g. `tips`. */
    std::map<std::string, std::vector<unsigned int>> joint_sets;

    /** Sentences for the user on how the cell was made. */
    std::vector<std::string> notes;
  };

  /** A kind of unit cell: parameters to joints and struts. */
  class Cell
  {
  public:
    virtual ~Cell() = default;

    /**
     * Builds the unit cell. The constructor has already refused impossible
     * shapes.
     */
    virtual UnitCell build() const = 0;
  };

  /** A cell whose joints and struts are known already. */
  class GivenCell : public Cell
  {
  public:
    explicit GivenCell(const UnitCell &cell) : cell(cell)
    {}

    UnitCell build() const override
    {
      return cell;
    }

  private:
    UnitCell cell;
  };

  /** All kinds of cells the program knows (mesh/cells/register.cc). */
  const Registry<Cell> &cell_registry();

  /**
   * Repeats @p cell @p n_cells times along x, y, z; cell (i, j, k) has its
   * centre at (i, j, k) times the period and the number i + nx * (j + ny * k).
   * Joints of different cells that lie closer than 1e-8 of the cell's size
   * become one, and of struts or pairs that then coincide the first is kept.
   * Joints of one and the same cell are never merged.
   *
   * A strut across two cells has the number of the first one.
   *
   * Fills the joint sets `all`, `bottom`, `top`, `left`, `right` (in space also
   * `back`, `front`) and those of the cell, the strut sets `all` and those of
   * the cell, and the pair sets. A pair across two cells has the number of the
   * first one, and is left out where its joints have become one: a set of such
   * pairs may be empty.
   * Throws InputError if a number of cells is zero or a direction without
   * period is repeated.
   */
  Lattice make_array(const UnitCell                    &cell,
                     const std::array<unsigned int, 3> &n_cells);

  /**
   * Gives a planar @p cell the period @p distance (m) along z and straight
   * struts between equal joints of neighbouring layers, in the strut set
   * `columns`. They stand at the joints of the cell's sets and sides named by
   * @p columns, several joined by `+`, or at `all`.
   *
   * Throws InputError naming @p path if the cell is not planar or has no joints
   * of that name.
   */
  UnitCell extrude(UnitCell           cell,
                   double             distance,
                   const std::string &columns,
                   const std::string &path);
} // namespace auxfem

#endif
