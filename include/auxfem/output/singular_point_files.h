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
   * By what the shape of a mode, of all local unknowns, is multiplied to be
   * seen in pictures of @p scene: ModesDefinition::amplitude (m per shape).
   * Collective.
   */
  double shape_amplitude(const Scene     &scene,
                         const Equations &equations,
                         const Vector    &shape);

  /** What a path of equilibria writes beside the files of other runs. */
  FolderContents path_contents();

  /** The kind in words, e.g. `limit point`. */
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
    /** Throws InputError as the files do. @p scene, equations must outlive the
     * object. @param restart_checkpoint what serialize() has saved; nullptr: nothing. */
    SingularPointFiles(const Scene          &scene,
                       const Equations      &equations,
                       MPI_Comm              communicator,
                       const CheckpointData *restart_checkpoint);

    /** Adds a point, at @p at. */
    void write(const State &at, const SingularPoint &point);

    /** What files there are. */
    void serialize(CheckpointArchive &archive);

    /** Names of the files and series that a checkpoint relies on. */
    std::vector<std::string> files() const;

    /** How many there are. */
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
