#ifndef auxfem_output_member_forces_h
#define auxfem_output_member_forces_h

#include <auxfem/equations/equations.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/strut_stresses.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Table of section forces of chosen struts at chosen times,
   * `member_forces.csv`: a row for each point of a strut, with position at rest
   * and displacement, section forces and von Mises stress.
   */
  class MemberForces
  {
  public:
    /** Name of the table. */
    static constexpr const char *table_name = "member_forces";

    /**
     * Creates the table, or continues that of the restored @p checkpoint.
     * Throws InputError for missing sets. Collective.
     * @param equations must outlive the object
     */
    MemberForces(const Scene          &scene,
                 const Equations      &equations,
                 MPI_Comm              communicator,
                 const CheckpointData *checkpoint);

    /** Throws InputError for missing sets of @p scene. */
    static void check(const Scene &scene, const Lattice &lattice);

    /** First of the times after @p time (s). */
    std::optional<double> after(double time) const;

    /** Whether @p time (s) is one of the times. */
    bool has(double time) const;

    /** Whether the end of the run is asked for. */
    bool includes_end() const
    {
      return definition.at_end;
    }

    /** Appends the struts at @p state, unless that was done. Collective. */
    void write(const State &state);

    /** Saves the length of the table. */
    void serialize(CheckpointArchive &archive);

  private:
    std::vector<Column> columns() const;
    /** Rows of the elements of this rank, one after the other. */
    std::vector<double> own_rows(const State &state) const;

    const MemberForcesDefinition definition;
    const Equations             &equations;
    const MPI_Comm               communicator;
    const double                 nearness; ///< of equal times (s)
    const StrutStresses          stresses;
    std::vector<bool>            is_chosen; ///< by strut
    std::optional<CsvTable>      table;     ///< on rank 0
    std::optional<double>        last_time; ///< written (s)
  };
} // namespace auxfem

#endif
