#ifndef auxfem_equations_effects_connector_forces_h
#define auxfem_equations_effects_connector_forces_h

#include <auxfem/connectors/connector_law.h>
#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /** What one connector does now, for output. */
  struct ConnectorReport
  {
    /** Ends of the connector at rest (m). */
    std::array<dealii::Point<3>, 2> ends;
    /** Displacements of its ends (m); zero at the ground. */
    std::array<dealii::Tensor<1, 3>, 2> displacements;
    double                              force;      ///< N, positive in tension
    double                              extension;  ///< m
    double                              dissipated; ///< J so far
    unsigned int                        cell;
  };

  /** A connector along its line whose direction means little. */
  struct VanishingConnector
  {
    double       part  = 1; ///< of its length at rest that is left, 0 if none
    unsigned int joint = invalid_index; ///< its first
  };

  /** Motion and forces of a group of connectors in one evaluation. */
  struct ConnectorResults : public EffectResults
  {
    explicit ConnectorResults(unsigned int n_connectors);

    std::vector<ConnectorMotion>   motion;
    std::vector<ConnectorResponse> response;
    /** Of the force; of a mean force not quite of unit length; not a number
     * where the ends meet. */
    std::vector<dealii::Tensor<1, 3>> direction;
    std::vector<dealii::Tensor<1, 3>> velocity_difference;
    std::vector<double>               current_length; ///< m
  };

  /** A group of equal connectors between joints, or joints and the ground. */
  class ConnectorForces : public Effect
  {
  public:
    /**
     * @param pairs the connectors of the whole lattice; those whose ends this
     *   rank does not own are left out.
     * @param large_rotation false: the line between the ends is the one at rest.
     */
    ConnectorForces(const ConnectorDefinition    &definition,
                    const std::vector<JointPair> &pairs,
                    const Lattice                &lattice,
                    const DofNumbering           &numbering,
                    bool                          large_rotation);

    bool is_linear() const override;
    void register_in(StateLayout &layout) override;
    void register_blocks(TangentPattern &pattern) override;
    std::unique_ptr<EffectResults> make_results() const override;

    void        add_residual(const Evaluation &evaluation,
                             double           *residual,
                             EffectResults    *results) const override;
    void        add_tangent(const Evaluation     &evaluation,
                            const EffectResults  *results,
                            const TangentFactors &factors,
                            TangentMatrix        &matrix) const override;
    void        add_geometric_tangent(const ForceChange &change,
                                      unsigned int       effect,
                                      TangentMatrix     &matrix) const override;
    void        add_relaxation_times(const Unknowns      &unknowns,
                                     std::vector<double> &times) const override;
    void        add_viscous_stiffness(const Evaluation    &evaluation,
                                      const EffectResults *results,
                                      std::complex<double> s,
                                      TangentMatrix       &real,
                                      TangentMatrix       &imaginary) const override;
    void        account(const Evaluation    &evaluation,
                        const EffectResults *results,
                        EnergyAccount       &account) const override;
    void        account_step(const Evaluation    &step,
                             const EffectResults *results,
                             EnergyAccount       &account) const override;
    void        account_stage(const Evaluation    &stage,
                              const EffectResults *results,
                              EnergyAccount       &account) const override;
    void        find_internal_rates(const State         &state,
                                    const EffectResults *results,
                                    double              *rates) const override;
    void        raise_forces(const Evaluation    &evaluation,
                             const EffectResults *results,
                             double              *forces) const override;
    void        raise_uncertain_forces(const Evaluation    &evaluation,
                                       const EffectResults *results,
                                       double               largest_displacement,
                                       double               largest_rotation,
                                       double              *forces) const override;
    std::string why_not_finite(const Evaluation    &evaluation,
                               const EffectResults *results) const override;

    const std::string &name() const
    {
      return group_name;
    }

    /**
     * The connector counted by this rank with the smallest part of its length
     * left, if that is less than @p least; one whose line has been turned round
     * in the step has passed through zero. Else of no joint. None of a fixed
     * direction.
     * @param results of the evaluation of the end of the step
     */
    VanishingConnector shortest(const Evaluation    &step,
                                const EffectResults &results,
                                double               least) const;

    /** Connectors counted by this rank, in order. */
    unsigned int n_reported() const
    {
      return owned.size();
    }

    /** Counted connector @p i at @p state, from the results of its evaluation. */
    ConnectorReport report(unsigned int         i,
                           const State         &state,
                           const EffectResults *results) const;

  private:
    /** The law of connector @p i as a differential equation, at @p state, of
     * which the @p results are. */
    ContinuousResponse continuous(unsigned int         i,
                                  const State         &state,
                                  const EffectResults &results,
                                  double              *internal_rates) const;

    struct Ends
    {
      /** Local unknowns x1, y1, z1, x2, y2, z2; -1: ground, z in the plane. */
      std::array<int, 6> unknowns;
      /** From first to second end at rest (m). */
      dealii::Tensor<1, 3> span;
      double               rest_length; ///< m
      /** Of the force, at rest. */
      dealii::Tensor<1, 3> direction;
      unsigned int         first_joint, second_joint, cell;
      /** Among all pairs of the group. */
      unsigned int number;
      bool         owned; ///< by this rank
    };

    /** Unknowns and geometry of a pair at rest. */
    Ends make_ends(const ConnectorDefinition &definition,
                   const JointPair           &pair,
                   const DofNumbering        &numbering) const;

    /** Difference of the values at both ends. */
    static dealii::Tensor<1, 3> difference(const Ends   &ends,
                                           const double *values);
    /** The line between the ends, displaced by @p du. */
    double extension(const Ends &ends, const dealii::Tensor<1, 3> &du) const;
    /** Whether connector @p i has no direction at a length (m). */
    bool ends_meet(unsigned int i, double length) const;
    void find_motion(const Evaluation &evaluation,
                     ConnectorResults &results) const;

    /** At which connector @p i with the extensions in @p results grows (m/s). */
    double rate(unsigned int            i,
                const Evaluation       &evaluation,
                const ConnectorResults &results) const;

    /** Forces of the motion in @p results, and internal variables. */
    void find_response(const Evaluation &evaluation,
                       ConnectorResults &results) const;

    /** Motion of a connector at the instant @p state of @p extension (m). */
    ConnectorMotion
    motion_at(const Ends &ends, const State &state, double extension) const;

    /**
     * What the mean of the forces of connector @p i at both ends of the step
     * does beyond what it stores and loses by @p energy (J).
     */
    double taken(unsigned int            i,
                 const Evaluation       &step,
                 const ConnectorResults &results,
                 const ConnectorEnergy  &energy) const;

    /** Derivative of mean forces by the state at the end. */
    void add_mean_tangent(const Evaluation       &evaluation,
                          const ConnectorResults &results,
                          TangentMatrix          &matrix) const;
    /** Adds the derivative of the force on the second end of connector @p i by the relative motion. */
    void add_block(unsigned int i,
                   const double (&by_motion)[3][3],
                   TangentMatrix &matrix) const;

    std::string                         group_name;
    std::shared_ptr<const ConnectorLaw> law;
    bool                                follows_line;
    dealii::Tensor<1, 3>                ground_offset;
    const Lattice                      &lattice;
    std::vector<Ends>                   connectors;
    std::vector<unsigned int>           owned;
    /** Index of the first internal variable and of the first dissipated energy
     * in State::history. */
    std::size_t  first_history = 0, first_dissipated = 0;
    unsigned int stored_entry = 0, dissipated_entry = 0, numerical_entry = 0;
    std::size_t  first_block = 0;
  };
} // namespace auxfem

#endif
