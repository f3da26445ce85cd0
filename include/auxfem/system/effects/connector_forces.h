#ifndef auxfem_system_effects_connector_forces_h
#define auxfem_system_effects_connector_forces_h

#include <auxfem/connectors/connector_law.h>
#include <auxfem/scene/scene.h>
#include <auxfem/system/effect.h>

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

  /** A group of equal connectors between joints, or joints and the ground. */
  class ConnectorForces : public Effect
  {
  public:
    /**
     * @param pairs the connectors of the whole lattice; those whose ends this
     *   rank does not own are left out.
     * @param large_rotation false: the line between the ends is the one at rest.
     * @param layout extended by the history this group needs.
     */
    ConnectorForces(const ConnectorDefinition    &definition,
                    const std::vector<JointPair> &pairs,
                    const Lattice                &lattice,
                    const DofNumbering           &numbering,
                    bool                          large_rotation,
                    StateLayout                  &layout);

    bool   is_linear() const override;
    void   register_blocks(TangentMatrix &matrix) override;
    void   begin_step(const Step &step) override;
    void   add_residual(const Step &step, double *residual) override;
    void   add_tangent(const Step           &step,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override;
    void   accept(const Step &step) override;
    void   add_energies(const State &state, Energies &energies) const override;
    double round_off_scale(double largest_displacement,
                           double largest_rotation) const override;

    const std::string &name() const;

    /** Whether energy is lost in this group. */
    bool is_viscous() const;

    /** Connectors counted by this rank, in order. */
    unsigned int n_reported() const;

    /** State of counted connector @p i, after the last add_residual(). */
    ConnectorReport report(unsigned int i, const State &state) const;

  private:
    struct Ends
    {
      /** Local unknowns x1, y1, z1, x2, y2, z2; -1: ground, z in the plane. */
      std::array<int, 6> unknowns;
      /** From first to second end at rest (m). */
      dealii::Tensor<1, 3> span;
      double               rest_length; ///< m
      unsigned int         first_joint, second_joint, cell;
      bool                 counted; ///< by this rank
    };

    static bool differences_extension(const State &state, double dt);
    void        evaluate_motion(const State &state, double dt);

    std::string                         group_name;
    std::shared_ptr<const ConnectorLaw> law;
    bool                                follows_line;
    dealii::Tensor<1, 3>                ground_offset;
    const Lattice                      &lattice;
    std::vector<Ends>                   connectors;
    std::vector<unsigned int>           counted;
    unsigned int                        first_history, first_dissipated;
    std::size_t                         first_block = 0;

    std::vector<ConnectorMotion>      motion;
    std::vector<ConnectorResponse>    response;
    std::vector<double>               stored;
    std::vector<dealii::Tensor<1, 3>> direction;
    std::vector<dealii::Tensor<1, 3>> velocity_difference;
    std::vector<double>               current_length;
  };
} // namespace auxfem

#endif
