#ifndef auxfem_mesh_sets_h
#define auxfem_mesh_sets_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/parameters/registry.h>

namespace auxfem
{
  /**
   * Joints named by @p text in one of four forms:
   * - names of joint sets joined by `+`;
   * - numbers, `3, 5, 7`;
   * - `nearest: x, y` or `nearest: x, y, z`, the joint nearest to a point;
   *   lengths with or without units, z = 0 by default;
   * - a condition in x, y, z, xmin, xmax, ... (m) and the scene's constants,
   *   e.g. `y > ymax - 1e-6 && x < 0.02`.
   *
   * Throws InputError naming @p path for an unknown set or number and for an
   * empty selection.
   */
  std::vector<unsigned int> select_joints(const Lattice      &lattice,
                                          const std::string  &text,
                                          const SceneContext &context,
                                          const std::string  &path);

  /** As select_joints(), for struts; positions are those of strut middles. */
  std::vector<unsigned int> select_struts(const Lattice      &lattice,
                                          const std::string  &text,
                                          const SceneContext &context,
                                          const std::string  &path);

  /** @name Joints or struts selected by `Joints` or `Struts` of @p definition. */
  ///@{
  template <class Definition>
  std::vector<unsigned int> joints_of(const Definition   &definition,
                                      const Lattice      &lattice,
                                      const SceneContext &context)
  {
    return select_joints(lattice,
                         definition.joints,
                         context,
                         definition.path + "/Joints");
  }

  template <class Definition>
  std::vector<unsigned int> struts_of(const Definition   &definition,
                                      const Lattice      &lattice,
                                      const SceneContext &context)
  {
    return select_struts(lattice,
                         definition.struts,
                         context,
                         definition.path + "/Struts");
  }
  ///@}

  /**
   * Connector pairs named by @p text: a pair set of the cell, `3 5; 7 9`, or
   * `ground: JOINTS`; with ` where CONDITION` those whose middle as designed
   * meets a condition as in select_joints(). Throws InputError naming @p path
   * for an unknown set or joint number and where there are no such pairs.
   */
  std::vector<JointPair> select_pairs(const Lattice      &lattice,
                                      const std::string  &text,
                                      const SceneContext &context,
                                      const std::string  &path);
} // namespace auxfem

#endif
