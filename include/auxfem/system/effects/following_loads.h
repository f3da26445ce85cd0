#ifndef auxfem_system_effects_following_loads_h
#define auxfem_system_effects_following_loads_h

#include <auxfem/loads/time_function.h>
#include <auxfem/mesh/motion_components.h>
#include <auxfem/system/node_rotations.h>

namespace auxfem
{
  /**
   * Forces and moments that turn with the rotation P of their joint: P f(t),
   * P m(t). They have no potential, and their tangent is not symmetric.
   */
  class FollowingLoads : public Effect
  {
  public:
    /** @param raised_from_zero as for AppliedLoads. */
    FollowingLoads(const Lattice      &lattice,
                   const DofNumbering &numbering,
                   bool                raised_from_zero);

    /** Lets force and moment of @p components (N, N m) act on a joint that has a rotation and is kept on this rank. */
    void add(const std::array<TimeFunction, n_motion_components> &components,
             unsigned int                                         joint);

    /** Whether no load was added. */
    bool empty() const;

    bool is_linear() const override;
    void register_blocks(TangentMatrix &matrix) override;
    void begin_step(const Step &step) override;
    void add_residual(const Step &step, double *residual) override;
    void add_tangent(const Step           &step,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const override;
    void accept(const Step &step) override;

  private:
    /** Force and moment in the axes that turn with the joint (N, N m). */
    struct Values
    {
      SpaceVector force, moment;
    };
    struct Load
    {
      std::array<TimeFunction, n_motion_components> components;
      /** Local unknowns by component of motion; -1: not there. */
      std::array<int, n_motion_components> unknowns;
      Values                               before, now; ///< of the step
    };

    static Values values(const Load &load, double time);
    Quaternion    rotation(const Load &load, const State &state) const;

    const bool          is_planar;
    const DofNumbering &numbering;
    const NodeRotations rotations;
    const bool          raised_from_zero;
    std::vector<Load>   loads;
    std::size_t         first_block = 0;
  };
} // namespace auxfem

#endif
