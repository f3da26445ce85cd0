#ifndef auxfem_output_singular_point_files_h
#define auxfem_output_singular_point_files_h

#include <auxfem/equations/equations.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/output/vtu_writer.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>

#include <optional>

namespace auxfem
{
  /**
   * Factor of a mode shape, values of all local unknowns, in pictures of @p
   * scene, from ModesDefinition::amplitude (m per shape). Collective.
   */
  double shape_amplitude(const Scene     &scene,
                         const Equations &equations,
                         const Vector    &shape);

  /** Files that a path of equilibria writes besides those of other runs. */
  FolderContents path_contents();

  /** Name of the kind, e.g. `limit point`. */
  std::string text_of(SingularPoint::Kind kind);

  /** One line for the screen on singular point @p number (from 1 on). */
  std::string
  text_of(const State &at, const SingularPoint &point, unsigned int number);

  /**
   * singular_points.csv with its reference, and the series `singular_...` for
   * ParaView: at the time n the lattice at singular point n, displaced by its
   * null vector. All functions but series() are collective.
   */
  class SingularPointFiles
  {
  public:
    /**
     * Throws InputError as CsvTable and VtuWriter do.
     * @param scene, equations must outlive the object
     * @param restart_checkpoint data of serialize(); nullptr: none
     */
    SingularPointFiles(const Scene          &scene,
                       const Equations      &equations,
                       MPI_Comm              communicator,
                       const CheckpointData *restart_checkpoint);

    /** Adds a point, at @p at. */
    void write(const State &at, const SingularPoint &point);

    /** Saves or restores the number and positions of the files. */
    void serialize(CheckpointArchive &archive);

    /** Names of the files and series that a checkpoint relies on. */
    std::vector<std::string> files() const;

    /** Number of points so far. */
    unsigned int number() const
    {
      return n_written;
    }

    /** Names of the series for ParaView. */
    std::vector<std::string> series() const;

  private:
    const Scene             &scene;
    const Equations         &equations;
    MPI_Comm                 communicator;
    std::optional<CsvTable>  table; ///< on rank 0
    std::optional<VtuWriter> graphics;
    unsigned int             n_written = 0;
  };
} // namespace auxfem

#endif
