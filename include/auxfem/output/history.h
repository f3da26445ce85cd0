#ifndef auxfem_output_history_h
#define auxfem_output_history_h

#include <auxfem/equations/equations.h>
#include <auxfem/figures/derived_columns.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/effective_strains.h>
#include <auxfem/output/probes.h>
#include <auxfem/output/strut_stresses.h>
#include <auxfem/output/support_moments.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>

#include <optional>

namespace auxfem
{
  /**
   * Rows of `history.csv`. Columns: `time`, or `arc_length`, `load_factor`,
   * `negative_eigenvalues` and `determinant`; for a probe P `P.ux`, `P.uy`,
   * `P.phi` (if all its joints rotate) and in dynamics `P.vx`, `P.vy`, `P.ax`,
   * `P.ay`, means over its joints; for a probe on rigid parts the columns of
   * RigidPartProbe; for a support S `S.rx`, `S.ry`, `S.m`, force and moment on
   * the lattice summed over its joints (`S.m` excludes moments of forces), and
   * `S.ux`, `S.uy` where it moves; for a group of connectors C `C.force`,
   * `C.extension`, sums over the group; if requested those of
   * EffectiveStrains; for a plate P `P.ux`, `P.uy`, its displacement, `P.fx`,
   * `P.fy`, the force of the struts on it, `P.penetration`, and if it moves in
   * dynamics `P.vx`, `P.ax`; those of SupportMoments, StressProbe and
   * energy_columns(); those of the user, see DerivedColumn. An infinite lattice
   * has no supports but the mean strain and stress, `strain_xy`, `stress_xy`.
   * Units and meanings are in `history.units.csv`.
   *
   * In space probes also have `P.uz`, `P.vz`, `P.az`, and instead of `P.phi`
   * the mean rotation vector `P.phi_x`, `P.phi_y`, `P.phi_z`, which includes
   * whole turns; supports have `S.rz`, and instead of `S.m` the moments `S.mx`,
   * `S.my`, `S.mz`.
   */
  class History
  {
  public:
    /**
     * Locates the probes. Throws InputError as require_existing_columns().
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
     * Row of a solution, with whole turns counted from the previous rows.
     * Collective: one reduction.
     */
    const std::vector<double> &values(const Solution &solution);

    /**
     * @name Columns of probes on joints and of supports, which are linear in
     * displacements and reactions
     */
    ///@{
    std::vector<Column> sum_columns() const;

    /**
     * Values of sum_columns() for small @p displacements and @p reactions,
     * values of all local unknowns; rotations as vectors in the global frame.
     * Collective.
     */
    std::vector<double> sums(const Vector &displacements,
                             const Vector &reactions) const;
    ///@}

    /** Energies up to the last row. */
    const EnergyRecord &energies() const
    {
      return record;
    }

    /** Records energies and rotations of a state without a row. */
    void note(const State &state);

    /**
     * Saves or restores at @p state, the last one of values() or note().
     * Collective.
     */
    void serialize(const State &state, CheckpointArchive &archive);

    /**
     * Largest |rotation| (rad) in all rows so far, of nodes of this rank;
     * before serialize(), of all ranks. In space only probes and rigid parts
     * count revolutions.
     */
    double largest_rotation() const
    {
      return rotation_so_far;
    }

    /** Largest effective strains in all rows so far, if requested. */
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
      acceleration,
      residual
    };

    static bool is_rate(const Quantity quantity)
    {
      return quantity == Quantity::velocity ||
        quantity == Quantity::acceleration;
    }

    /** A column that is a weighted sum over unknowns. */
    struct UnknownSum
    {
      Quantity         quantity;
      std::vector<int> unknowns; ///< local numbers, owned by this rank
      double           factor;
      /** By unknown; empty: 1. */
      std::vector<double> weights = {};

      /** @param value of an unknown */
      template <class Value>
      double total(const Value &value) const
      {
        double sum = 0;
        for (std::size_t i = 0; i < unknowns.size(); ++i)
          sum += (weights.empty() ? 1. : weights[i]) * value(unknowns[i]);
        return factor * sum;
      }
    };

    void define_probe(const ProbeDefinition &probe,
                      const SceneContext    &context);
    /**
     * Defines a column for a mean over @p joints; @p column has its name within
     * the probe.
     */
    void define_mean(const ProbeDefinition           &probe,
                     const std::vector<unsigned int> &joints,
                     const Column                    &column,
                     Quantity                         quantity,
                     unsigned int                     component);
    void define_support(const Support &support);
    /** Defines `S.ux` and so on for the displacements that @p support moves,
     * unless @p scene has a probe or plate of its name. */
    void define_moved_support(const Scene &scene, const Support &support);
    /** Defines velocities and accelerations of the plates that move. */
    void define_plate_rates(const Scene &scene);
    /** Defines velocities and accelerations of @p probe in dynamics. */
    void define_rates(const ProbeDefinition           &probe,
                      const std::vector<unsigned int> &joints);
    void define_mean_deformation();
    void define_connectors(const ConnectorForces &group);
    void define_plates(const PlateContact &plates);
    void define_derived_columns(const std::vector<DerivedColumn> &definitions);

    /**
     * Writes sums of this rank from column @p column on; returns the next
     * column.
     */
    unsigned int add_unknown_sums(const State &state, unsigned int column);
    unsigned int add_support_moments(const State &state, unsigned int column);
    unsigned int add_stresses(const State &state, unsigned int column);
    unsigned int add_rigid_part_values(const State &state, unsigned int column);
    unsigned int add_connector_sums(const Solution &solution,
                                    unsigned int    column);
    /** As above, but summed over all ranks. */
    unsigned int add_plates(const Solution &solution, unsigned int column);
    unsigned int add_strains(const State &state, unsigned int column);
    double value(Quantity quantity, const State &state, int unknown) const;

    const Equations    &equations;
    MPI_Comm            communicator;
    std::vector<Column> column_list;
    /** Number of columns for time or position on a path. */
    unsigned int                n_position_columns = 1;
    std::vector<UnknownSum>     unknown_sums;
    RigidPartRotations          part_rotations;
    std::vector<RigidPartProbe> rigid_part_probes;
    SupportMoments              support_moments;
    std::vector<StressProbe>    stress_probes;
    RotationVectors             rotation_vectors;
    /** Effective strains, if requested. */
    std::optional<EffectiveStrains> strains;
    LargestStrain                   strain_so_far;
    std::vector<double>             row;
    /** Number of columns before the derived ones. */
    unsigned int                 n_recorded_columns = 0;
    std::optional<DerivedValues> derived_values;
    EnergyRecord                 record;
    double                       rotation_so_far = 0;
  };

  /**
   * Throws InputError if a probe of @p scene matches no joint of @p lattice, or
   * if effective strains are requested for a lattice without sides.
   */
  void require_existing_columns(const Scene &scene, const Lattice &lattice);
} // namespace auxfem

#endif
