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
   * Rotation vectors (rad) of selected nodes in space, with whole turns counted
   * from state to state. Empty in the plane, where rotations are numbers.
   */
  class RotationVectors
  {
  public:
    /** @param model must outlive the object. */
    explicit RotationVectors(const LatticeModel &model);

    /** Selects the rotation with the local unknown @p unknown, a spin. */
    void choose(int unknown);

    /**
     * Updates the vectors to @p state. About a fixed axis the rotation in
     * between may be large; about changing axes it must stay below half a turn.
     */
    void follow(const State &state);

    /** Saves or restores at @p state, the last one of follow(). */
    void serialize(const State &state, CheckpointArchive &archive);

    /**
     * Entry (rad) of local unknown @p unknown, a spin of a selected rotation.
     */
    double operator[](int unknown) const;

    /** Largest angle (rad). */
    double largest() const;

  private:
    /**
     * Serial numbers of the selected rotations, the same on any number of
     * ranks.
     */
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
   * Rotation vectors of the rigid parts that this rank reports, with half turns
   * counted from state to state.
   */
  class RigidPartRotations
  {
  public:
    /** @param equations must outlive the object. */
    explicit RigidPartRotations(const Equations &equations);

    /**
     * Updates the vectors to @p state; parts must have turned by less than half
     * a turn since the last one.
     */
    void follow(const State &state);

    void serialize(CheckpointArchive &archive);

    /**
     * Rotation vectors (rad) by number of the part in
     * RigidPartConditions::report().
     */
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
   * rotation of the parts of the struts, with half turns counted. With joints
   * also `P.fx`, `P.fy`, in space `P.fz`, the sum of their forces on the parts.
   */
  class RigidPartProbe
  {
  public:
    /** Whether @p definition is a probe of this kind. */
    static bool is_rigid_part_probe(const ProbeDefinition &definition);

    /**
     * Locates parts and joints. Throws InputError for missing sets, and if no
     * strut is rigid or no joint belongs to the parts.
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
     * @param rotations rotation vectors at @p state
     */
    std::vector<double> values(const State              &state,
                               const RigidPartRotations &rotations) const;

  private:
    struct Part
    {
      unsigned int              report; ///< number of the part on this rank
      std::vector<unsigned int> joints; ///< indices into its joint forces
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
