#ifndef auxfem_mesh_cells_frame_text_h
#define auxfem_mesh_cells_frame_text_h

#include <auxfem/mesh/cell.h>
#include <auxfem/parameters/registry.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** An entry between semicolons, split into numbers with their units. */
  struct ListItem
  {
    std::string              where; ///< beginning of messages about it
    std::string              text;
    std::vector<std::string> words;
  };

  /** Splits the @p value of the parameter @p entry at semicolons; messages call
   * its items @p noun and their number. */
  std::vector<ListItem> split_items(const std::string &value,
                                    const std::string &entry,
                                    const std::string &noun,
                                    const std::string &path);

  /** Number of a joint below @p n_joints in @p word. Throws InputError. */
  unsigned int read_joint_number(const std::string &word,
                                 const ListItem    &item,
                                 std::size_t        n_joints);

  /** `Joints`, `Struts` and `Merge distance`. */
  Parameters frame_parameters();

  /** Joints and struts of these parameters. Throws InputError, which calls
   * them a @p noun. */
  UnitCell read_frame(const ParameterValues &values, const std::string &noun);

  /** Merges joints by the Merge distance; see merge_joints(). */
  void merge_joints_of_frame(const ParameterValues &values, UnitCell &cell);
} // namespace auxfem

#endif
