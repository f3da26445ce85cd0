#ifndef auxfem_output_history_h
#define auxfem_output_history_h

#include <auxfem/equations/equations.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/effective_strains.h>
#include <auxfem/output/probes.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>

#include <optional>

namespace auxfem
{
  /**
   * The rows of `history.csv`: numbers of a state. Columns: `time`, or
   * `arc_length`, `load_factor`, `negative_eigenvalues` and `determinant`; for
   * a probe P `P.ux`, `P.uy`, `P.phi` (if all its joints rotate) and in
   * dynamics `P.vx`, `P.vy`, means over its joints; for a probe on rigid parts
   * the columns of RigidPartProbe; for a support S `S.rx`, `S.ry`, `S.m`, force
   * and moment of the support on the lattice summed over its joints (forces
   * have no part in `S.m`); for a group of connectors C `C.force`,
   * `C.extension`, sums over the group; if wanted those of EffectiveStrains;
   * for a plate P `P.ux`, `P.uy`, its displacement, `P.fx`, `P.fy`, the force
   * of the struts on it, and `P.penetration`; those of energy_columns(), with
   * `balance`, which should be zero. Units and
   * meaning are in `history.units.csv`.
   *
   * In space probes have also `P.uz` and `P.vz`, and for `P.phi` the mean
   * rotation vector `P.phi_x`, `P.phi_y`, `P.phi_z`, which counts on past whole
   * turns; supports have `S.rz`, and for `S.m` the moments `S.mx`, `S.my`,
   * `S.mz`.
   */
  class History
  {
  public:
    /**
     * Finds the probes. Throws InputError as refuse_columns_of_nothing().
     * @param equations must outlive the history.
     */
    History(const Scene     &scene,
            const Equations &equations,
            MPI_Comm         communicator);

    const std::vector<Column> &columns() const
    {
      return column_list;
    }

    /**
     * The numbers of the row of a solution, as of the rows before: whole turns
     * are counted. Collective: one reduction.
     */
    const std::vector<double> &values(const Solution &solution);

    /** @name Columns that are linear in displacements and reactions: of probes on
     * joints, and of supports. */
    ///@{
    std::vector<Column> sum_columns() const;

    /** Their values for small @p displacements, rotations as vectors in the
     * global frame, and @p reactions, of all local unknowns. Collective. */
    std::vector<double> sums(const Vector &displacements,
                             const Vector &reactions) const;
    ///@}

    /** Energies up to the last row. */
    const EnergyRecord &energies() const
    {
      return record;
    }

    /** Takes note of the energies and rotations of a state that gets no row. */
    void note(const State &state);

    /** At @p state, the one last given to values() or note(). Collective. */
    void serialize(const State &state, CheckpointArchive &archive);

    /**
     * Largest |rotation| (rad) in all rows so far, of nodes of this rank; in
     * those before serialize() of all ranks. In space only those of probes and
     * rigid parts count revolutions.
     */
    double largest_rotation() const
    {
      return rotation_so_far;
    }

    /** Effective strains in all rows so far; none unless they are wanted. */
    const LargestStrain &largest_strain() const
    {
      return strain_so_far;
    }

  private:
    enum class Quantity
    {
      displacement,
      rotation_vector,
      velocity,
      residual
    };

    /** A column that is a weighted sum over unknowns. */
    struct UnknownSum
    {
      Quantity         quantity;
      std::vector<int> unknowns; ///< local numbers, owned by this rank
      double           factor;
    };

    void define_probe(const ProbeDefinition &probe,
                      const SceneContext    &context);
    /** A column for a mean over @p joints; @p column has its name in the probe. */
    void define_mean(const ProbeDefinition           &probe,
                     const std::vector<unsigned int> &joints,
                     const Column                    &column,
                     Quantity                         quantity,
                     unsigned int                     component);
    void define_support(const Support &support);
    void define_connectors(const ConnectorForces &group);
    void define_plates(const PlateContact &plates);

    /** Sums of this rank from column @p column on; returns the column after them. */
    unsigned int add_unknown_sums(const State &state, unsigned int column);
    unsigned int add_rigid_part_values(const State &state, unsigned int column);
    unsigned int add_connector_sums(const Solution &solution,
                                    unsigned int    column);
    /** Of all ranks already. */
    unsigned int add_plates(const Solution &solution, unsigned int column);
    unsigned int add_strains(const State &state, unsigned int column);
    double value(Quantity quantity, const State &state, int unknown) const;

    const Equations    &equations;
    MPI_Comm            communicator;
    std::vector<Column> column_list;
    /** Columns that say where on the way a row lies. */
    unsigned int                n_of_position = 1;
    std::vector<UnknownSum>     unknown_sums;
    RigidPartRotations          part_rotations;
    std::vector<RigidPartProbe> rigid_part_probes;
    RotationVectors             rotation_vectors;
    /** If wanted. */
    std::optional<EffectiveStrains> strains;
    LargestStrain                   strain_so_far;
    std::vector<double>             row;
    EnergyRecord                    record;
    double                          rotation_so_far = 0;
  };

  /**
   * Throws InputError if a probe of @p scene names no joint of @p lattice, or if
   * effective strains are wanted of a lattice without sides.
   */
  void refuse_columns_of_nothing(const Scene &scene, const Lattice &lattice);
} // namespace auxfem

#endif
