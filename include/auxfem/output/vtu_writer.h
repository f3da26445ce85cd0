#ifndef auxfem_output_vtu_writer_h
#define auxfem_output_vtu_writer_h

#include <auxfem/equations/equations.h>
#include <auxfem/output/line_graphics.h>
#include <auxfem/output/strut_stresses.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/struts/effects/struts.h>

#include <optional>

namespace auxfem
{
  /**
   * Files for ParaView: `solution.pvd` with the elastic struts (several
   * straight pieces per element), `rigid_parts.pvd` and `connectors.pvd`, each
   * if the scene has any. The geometry is that at rest; `displacement` is the
   * vector for Warp By Vector, `radius` the one for Tube. One rank writes each
   * element and connector.
   *
   * Fields of struts: displacement (m), velocity (m/s, in dynamics), rotation
   * (rad), axial_force, shear_force (N), bending_moment (N m),
   * strain_energy_density (J/m), those of Stresses (Pa) and fibre_strain,
   * radius (m), numbers of strut, cell, section
   * and mpi_rank, and `set_NAME`, 1 inside and 0 outside, for the user's strut
   * sets. In space rotation is the rotation vector, d1, d2, d3 are the section
   * axes now, and forces are axial_force, shear_force_2, shear_force_3 (N),
   * torque, bending_moment_2, bending_moment_3 (N m), about these axes. Fields
   * of connectors: displacement (m), force (N), extension (m),
   * dissipated_energy (J), numbers of group and cell. Fields of rigid parts:
   * displacement (m), velocity (m/s, in dynamics), rotation (rad, within half a
   * turn), force (N) of the joint on the part, zero between joints, numbers of
   * part, definition and cell.
   */
  class VtuWriter
  {
  public:
    /**
     * Makes the subfolders of @p folder. Throws InputError on failure. All
     * writing functions are collective, too.
     * @param scene, equations must outlive the writer
     * @param prefix prefix of the names of all series
     */
    VtuWriter(const Scene       &scene,
              const Equations   &equations,
              const std::string &folder,
              MPI_Comm           communicator,
              const std::string &prefix = "");

    /** Names of the series that are written. */
    std::vector<std::string> series() const;

    /**
     * Writes the elastic struts at @p state. Throws ComputationError if writing
     * fails.
     */
    void write_struts(const State &state);

    /** Adds the struts of one polynomial order. */
    void add_struts(const StrutForces &struts,
                    const State       &state,
                    LineGraphics      &graphics) const;

    /** As write_struts(), for rigid parts. */
    void write_rigid_parts(const State &state);

    /** As write_struts(), for connectors; nothing without any. */
    void write_connectors(const Solution &solution);

    /** As write_struts(), for plates and contacts; see ContactGraphics. */
    void write_contacts(const Solution &solution);

    /** Saves or restores the numbers of files. */
    void serialize(CheckpointArchive &archive);

  private:
    using SetMembers = std::vector<bool>; ///< by strut

    /** Fields of struts with a law. */
    std::vector<GraphicsField> law_fields() const;
    std::vector<GraphicsField> stress_fields() const;
    void                       append_stresses(const PointStresses &stresses,
                                               std::vector<float>  &values) const;
    std::vector<GraphicsField> strut_fields() const;
    /** Appends the first values of strut_fields(), up to the stresses, at @p
     * point. */
    void                       append_point(const StrutPoint   &point,
                                            std::vector<float> &values) const;
    std::vector<GraphicsField> rigid_part_fields() const;
    /**
     * Lines of one part: its struts, or lines from its first joint to the
     * others.
     */
    std::vector<std::vector<dealii::Point<3>>>
    rigid_part_lines(const RigidPart &part) const;

    const Equations   &equations;
    const unsigned int n_segments;
    /** Stresses; empty: not written. */
    std::optional<StrutStresses> stresses;

    std::vector<std::string>       set_names;
    std::vector<SetMembers>        sets;
    std::optional<GraphicsSeries>  strut_series;
    std::optional<GraphicsSeries>  rigid_part_series;
    std::optional<GraphicsSeries>  connector_series;
    std::optional<ContactGraphics> contacts;
  };
} // namespace auxfem

#endif
