#ifndef auxfem_mesh_cell_h
#define auxfem_mesh_cell_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/registry.h>

#include <functional>

namespace auxfem
{
  /** A strut of a unit cell and the strut sets it belongs to. */
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

  /** A joint of a unit cell and a joint of a neighbour. */
  struct NeighbourPair
  {
    unsigned int       first;  ///< joint of this cell
    unsigned int       second; ///< joint of the neighbour
    std::array<int, 3> shift;  ///< from this cell to the neighbour, in cells
  };

  /** Straight struts of one strut set between neighbouring cells. */
  struct StrutsAcross
  {
    std::string                set;
    std::vector<NeighbourPair> ends;
  };

  /**
   * A unit cell about its own origin. make_array() repeats it by its
   * translation vectors and merges joints that coincide with those of a
   * neighbour.
   */
  struct UnitCell
  {
    /** Positions about the cell's origin (m). */
    std::vector<dealii::Point<3>> joints;

    std::vector<UnitStrut> struts;

    /** Struts to neighbours, made wherever that neighbour exists. */
    std::vector<StrutsAcross> struts_across;

    /** Joint pairs that connectors may link, by name. */
    std::map<std::string, std::vector<std::pair<unsigned int, unsigned int>>>
      pairs;

    /** Joint pairs of a cell and a neighbour, by name; made wherever that
     * neighbour exists. */
    std::map<std::string, std::vector<NeighbourPair>> pairs_across;

    /** Translations to the next cells of the three directions of the array
     * (m), linearly independent; 0 if the cell cannot be repeated in that
     * direction. Those of most cells are along x, y, z. */
    std::array<dealii::Tensor<1, 3>, 3> vectors;

    /** Whether the cell can be repeated in direction @p d. */
    bool repeats(const unsigned int d) const
    {
      return vectors[d].norm() > 0;
    }

    /** Sentence that tells the user why a direction has no vector; may be
     * empty. */
    std::array<std::string, 3> no_vector_reasons;

    /** Distance below which joints of different cells are one (m), if above
     * 1e-8 of the cell's size. */
    double merge_distance = 0;

    /**
     * Joints through which cells meet, by side (`left`, `right`, `bottom`,
     * `top`, `back`, `front`). On the array's boundary they form the set of
     * that name. A cell without ports gets these sets from the faces of the
     * bounding box, unless joint_sets has a set of that name.
     */
    std::map<std::string, std::vector<unsigned int>> ports;

    /** Further named joints, collected over all cells, e.g. `tips`. */
    std::map<std::string, std::vector<unsigned int>> joint_sets;

    /** Sentences that tell the user how the cell was made. */
    std::vector<std::string> notes;
  };

  /** A kind of unit cell, made from parameters of the scene. Its constructor
   * refuses impossible shapes. */
  class Cell
  {
  public:
    virtual ~Cell() = default;

    /** Builds the unit cell. */
    virtual UnitCell build() const = 0;
  };

  /** A Cell that holds a finished UnitCell. */
  class PrebuiltCell : public Cell
  {
  public:
    explicit PrebuiltCell(const UnitCell &cell) : cell(cell)
    {}

    UnitCell build() const override
    {
      return cell;
    }

  private:
    UnitCell cell;
  };

  /** All kinds of cells the program knows (mesh/cells/cell_table.cc). */
  const Registry<Cell> &cell_registry();

  /**
   * Repeats @p cell @p n_cells times by its vectors. Cell (i, j, k) has its
   * origin at i, j, k times them and the number i + nx * (j + ny * k).
   * Struts and pairs across two cells have the number of the first one.
   *
   * Joints of different cells that lie closer than the merge distance become
   * one, at the place of the first; joints of the same cell are never merged.
   * The first of several coincident struts or pairs remains, and pairs whose
   * joints have become one are dropped, so that a pair set may be empty.
   *
   * Fills the joint sets `all`, `bottom`, `top`, `left`, `right` (in space also
   * `back`, `front`), the strut set `all`, and the sets of the cell. Throws
   * InputError if a number of cells is zero or a direction without vector is
   * repeated.
   * @param keeps whether there is a cell whose joints have their mean at a
   *   position (m); empty: everywhere
   */
  Lattice
  make_array(const UnitCell                                      &cell,
             const std::array<unsigned int, 3>                   &n_cells,
             const std::function<bool(const dealii::Point<3> &)> &keeps = {});

  /**
   * Stacks a planar @p cell in layers: repeats it at the @p distance (m) along
   * z and adds straight struts between equal joints of neighbouring layers
   * (strut set `columns`). @p columns names their joints: sets and sides of the
   * cell joined by `+`, or `all`. Throws InputError naming @p path if the cell
   * is not planar or has no joints of that name.
   */
  UnitCell extrude(UnitCell           cell,
                   double             distance,
                   const std::string &columns,
                   const std::string &path);
} // namespace auxfem

#endif
