#ifndef auxfem_output_probes_h
#define auxfem_output_probes_h

#include <auxfem/equations/equations.h>
#include <auxfem/model/lattice_model.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>

namespace auxfem
{
  /**
   * Chosen rotations in space as rotation vectors since rest (rad), counted on
   * past whole turns from state to state. None in the plane, where rotations
   * are numbers.
   */
  class RotationVectors
  {
  public:
    /** @param model must outlive the object. */
    explicit RotationVectors(const LatticeModel &model);

    /** Chooses the rotation that local unknown @p unknown, a spin, belongs to.
     */
    void choose(int unknown);

    /**
     * Goes on to @p state. The sum of turns in between tells apart vectors
     * that mean the same rotation, so it may be large about a fixed axis; about
     * axes that change it must stay below half a turn.
     */
    void follow(const State &state);

    /** At @p state, the one last followed. */
    void serialize(const State &state, CheckpointArchive &archive);

    /** The entry of local unknown @p unknown (rad), a spin of a chosen one. */
    double operator[](int unknown) const;

    /** Largest angle (rad). */
    double largest() const;

  private:
    /** Names of the chosen ones, the same on any number of ranks. */
    std::vector<unsigned int> numbers() const;

    struct Rotation
    {
      unsigned int index; ///< among DofNumbering::rotations()
      SpaceVector  vector;
      SpaceVector  entries; ///< of State::displacement
    };

    const LatticeModel   &model;
    std::vector<Rotation> rotations; ///< rising by index
  };

  /**
   * Rotation vectors of the rigid parts this rank reports on, counted on past
   * half turns from state to state.
   */
  class RigidPartRotations
  {
  public:
    /** @param equations must outlive the object. */
    explicit RigidPartRotations(const Equations &equations);

    /** Goes on to @p state; parts must not have turned by half a turn since the last. */
    void follow(const State &state);

    void serialize(CheckpointArchive &archive);

    /** By the number of the part in RigidPartConditions::report() (rad). */
    const std::vector<SpaceVector> &values() const
    {
      return rotations;
    }

  private:
    /** Numbers of the parts in the lattice. */
    std::vector<unsigned int> parts() const;

    const Equations         &equations;
    std::vector<SpaceVector> rotations;
  };

  /**
   * A probe P on rigid parts, written `rigid: STRUTS` or `rigid: STRUTS @
   * JOINTS`, where the name of a definition (`Rigid parts/NAME`) may stand for
   * the struts: `P.phi`, in space `P.phi_x`, `P.phi_y`, `P.phi_z`, the mean
   * rotation of the parts the struts belong to, counted on past half turns, and
   * with joints `P.fx`, `P.fy`, in space `P.fz`, the sum of the forces these
   * exert on the parts.
   */
  class RigidPartProbe
  {
  public:
    /** Whether @p definition is a probe of this kind. */
    static bool is_one(const ProbeDefinition &definition);

    /**
     * Finds parts and joints. Throws InputError for sets that do not exist,
     * struts none of which is rigid, and joints none of which is of the parts.
     * @param equations must outlive the probe.
     */
    RigidPartProbe(const ProbeDefinition &definition,
                   const Scene           &scene,
                   const Equations       &equations);

    /** Throws InputError as the constructor. */
    static void check(const ProbeDefinition &definition,
                      const Scene           &scene,
                      const Lattice         &lattice);

    std::vector<Column> columns() const;

    /**
     * This rank's share of each column, to be summed over the ranks.
     * @param rotations as followed up to @p state.
     */
    std::vector<double> values(const State              &state,
                               const RigidPartRotations &rotations) const;

  private:
    struct Part
    {
      unsigned int              report; ///< number on this rank
      std::vector<unsigned int> joints; ///< indices into its forces
    };

    std::string       name;
    bool              has_forces;
    unsigned int      n_dimensions;
    unsigned int      n_parts; ///< on all ranks
    const Equations  &equations;
    std::vector<Part> parts; ///< of this rank
  };
} // namespace auxfem

#endif
