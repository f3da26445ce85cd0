#ifndef auxfem_output_rigid_part_probe_h
#define auxfem_output_rigid_part_probe_h

#include <auxfem/output/csv_table.h>
#include <auxfem/parameters/scene.h>
#include <auxfem/system/system.h>

namespace auxfem
{
  /**
   * A probe P on rigid parts, written `rigid: STRUTS` or `rigid: STRUTS @
   * JOINTS`: `P.phi`, the mean rotation of the parts the struts belong to,
   * counted on past half turns, and with joints `P.fx`, `P.fy`, the sum of the
   * forces these exert on the parts.
   */
  class RigidPartProbe
  {
  public:
    /** Whether @p definition is a probe of this kind. */
    static bool is_one(const ProbeDefinition &definition);

    /**
     * Finds parts and joints. Throws InputError for sets that do not exist,
     * struts none of which is rigid, and joints none of which is of the parts.
     * @param system must outlive the probe.
     */
    RigidPartProbe(const ProbeDefinition &definition,
                   const SceneContext    &context,
                   const System          &system);

    /** Throws InputError as the constructor. */
    static void check(const ProbeDefinition &definition,
                      const SceneContext    &context,
                      const Lattice         &lattice);

    std::vector<Column> columns() const;

    /** Follows the rotations, so that they can be counted past half turns. */
    void follow(const State &state);

    /** This rank's share of each column, to be summed over the ranks. */
    std::vector<double> values(const State &state) const;

  private:
    struct Part
    {
      unsigned int              report;       ///< number on this rank
      std::vector<unsigned int> joints;       ///< indices into its forces
      double                    rotation = 0; ///< followed so far (rad)
    };

    std::string       name;
    bool              has_forces;
    unsigned int      n_parts; ///< on all ranks
    const System     &system;
    std::vector<Part> parts; ///< of this rank
  };
} // namespace auxfem

#endif
