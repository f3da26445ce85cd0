#ifndef auxfem_mesh_array_changes_h
#define auxfem_mesh_array_changes_h

#include <auxfem/mesh/cell.h>
#include <auxfem/parameters/registry.h>

#include <array>
#include <optional>
#include <string>

namespace auxfem
{
  /** What `Lattice` takes away from an array and how it bends it, before sets
   * and sections refer to it. */
  struct ArrayChanges
  {
    /** Condition at the middle of cells that remain; empty: all. */
    std::string region;
    /** Struts that may be missing, and how probable that is. */
    std::string  missing_struts;
    double       missing_probability = 1;
    unsigned int seed                = 1;
    /** Expressions for the coordinates; empty: unchanged. */
    std::array<std::string, 3> map;
  };

  /** Parameters of array changes, in `Lattice`. */
  Parameters array_change_parameters();

  ArrayChanges read_array_changes(const ParameterValues &values);

  /** make_array() of the cells whose middles meet the condition @p region; all
   * if it is empty. Throws InputError if there are none. */
  Lattice make_array_in_region(const UnitCell                    &cell,
                               const std::array<unsigned int, 3> &n_cells,
                               const std::string                 &region,
                               const SceneContext                &context);

  /**
   * Applies the other @p changes to @p lattice: takes missing struts away, then
   * maps the joints and unites those that come to lie at the
   * same place. Joints that lose all struts go, and so do pairs that lose a
   * joint; notes count them. The struts that are missing depend on the seed
   * alone. Throws InputError if nothing remains, or for expressions that cannot
   * be computed.
   */
  void change_array(const ArrayChanges &changes,
                    const SceneContext &context,
                    Lattice            &lattice);
} // namespace auxfem

#endif
