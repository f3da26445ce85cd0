#ifndef auxfem_output_history_h
#define auxfem_output_history_h

#include <auxfem/output/csv_table.h>
#include <auxfem/output/effective_strains.h>
#include <auxfem/output/rigid_part_probe.h>
#include <auxfem/output/rotation_vectors.h>
#include <auxfem/scene/scene.h>
#include <auxfem/system/system.h>

#include <optional>

namespace auxfem
{
  /** Energies of a run as its history has seen them so far (J). */
  struct EnergyRecord
  {
    Energies latest;
    double   balance         = 0; ///< the latest error of the balance
    double   largest_balance = 0; ///< the largest |balance|
    /** Of mechanical, dissipated energy and work. */
    double largest_energy = 0;

    /** Takes note of @p energies; the first ones are those the balance starts from. */
    void add(const Energies &energies);

    /** @p energy over the largest energy; 0 as long as there is no energy. */
    double relative(double energy) const;

  private:
    std::optional<double> start;
  };

  /**
   * Columns of history.csv for energies; without @p has_struts there is none
   * for strain energy.
   */
  std::vector<Column> energy_columns(bool has_struts);

  /** The numbers in these columns after the latest add(). */
  std::vector<double> energy_values(const EnergyRecord &record,
                                    bool                has_struts);

  /**
   * `history.csv`: a row for each recorded state. Columns: `time`; for a probe
   * P `P.ux`, `P.uy`, `P.phi` (if all its joints rotate) and in dynamics
   * `P.vx`, `P.vy`, means over its joints; for a probe on rigid parts the
   * columns of RigidPartProbe; for a support S `S.rx`, `S.ry`,
   * `S.m`, force and moment of the support on the lattice summed over its
   * joints (forces have no part in `S.m`); for a group of connectors C
   * `C.force`, `C.extension`, `C.dissipated`, sums over the group; if wanted
   * those of EffectiveStrains; `kinetic`, `strain`, `stored`, `dissipated`,
   * `external`, and `balance`, which should be zero. Units and meaning are in
   * `history.units.csv`.
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
     * Finds the probes and writes the headers. Throws InputError as
     * refuse_columns_of_nothing() and for files that cannot be written.
     * Collective.
     * @param system must outlive the history.
     */
    History(const Scene       &scene,
            const System      &system,
            const std::string &folder,
            MPI_Comm           communicator);

    /**
     * Appends the row of @p state, which must be the last given to
     * System::residual(). Throws ComputationError if the disk takes no more.
     * Collective: one reduction.
     */
    void write(const State &state);

    /** Energies up to the last row. */
    const EnergyRecord &energies() const;

    /** Takes note of the energies and rotations of a state that gets no row. */
    void note(const State &state);

    /** Largest |rotation| (rad) in all rows so far, of unknowns of this rank.
     */
    double largest_rotation() const;

    /** Effective strains in all rows so far; none unless they are wanted. */
    const LargestStrain &largest_strain() const;

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

    /** Sums of this rank from column @p column on; returns the column after them. */
    unsigned int add_unknown_sums(const State &state, unsigned int column);
    unsigned int add_rigid_part_values(const State &state, unsigned int column);
    unsigned int add_connector_sums(const State &state, unsigned int column);
    unsigned int add_strains(const State &state, unsigned int column);
    double value(Quantity quantity, const State &state, int unknown) const;

    const System               &system;
    MPI_Comm                    communicator;
    std::vector<Column>         columns;
    std::vector<UnknownSum>     sums;
    RigidPartRotations          part_rotations;
    std::vector<RigidPartProbe> rigid_part_probes;
    RotationVectors             rotation_vectors;
    /** If wanted. */
    std::optional<EffectiveStrains> strains;
    LargestStrain                   strain_so_far;
    std::vector<double>             row;
    EnergyRecord                    record;
    /** Rotations in the plane: local numbers, owned by this rank. */
    std::vector<int> rotations;
    double           rotation_so_far = 0;
    /** On rank 0. */
    std::optional<CsvTable> table;
  };

  /**
   * Throws InputError if a probe of @p scene names no joint of @p lattice, or if
   * effective strains are wanted of a lattice without sides.
   */
  void refuse_columns_of_nothing(const Scene &scene, const Lattice &lattice);
} // namespace auxfem

#endif
