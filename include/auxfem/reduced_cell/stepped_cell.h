#ifndef auxfem_reduced_cell_stepped_cell_h
#define auxfem_reduced_cell_stepped_cell_h

#include <auxfem/reduced_cell/cell_equations.h>
#include <auxfem/reduced_cell/cell_scheme.h>

#include <array>

namespace auxfem
{
  /**
   * Load, connector and energies of the reduced cell for schemes that go from
   * step to step: the law gets trial motions of a step until one is accepted.
   */
  class SteppedCell
  {
  public:
    /** @param scene must outlive the object. */
    explicit SteppedCell(const Scene &scene);

    const CellEquations &equations() const
    {
      return cell;
    }

    /** Begins the step number @p step (from 1; 0: the start, of length zero). */
    void begin_step(unsigned long step);

    /** Length of the step begun (s). */
    double dt() const
    {
      return connector_motion.dt;
    }

    /** f1 at its end (N). */
    double load() const
    {
      return load_now;
    }

    /** Force and tangents of the connector at its end, for @p motion there. */
    const ConnectorResponse &connector(const CellMotion &motion);

    /**
     * Ends the step with @p motion: internal variables and energies follow. The work of the load is that of its mean
     * over the step, as for lattices. Throws ComputationError if a number of
     * the sample is not finite.
     */
    CellSample accept(const CellMotion &motion);

  private:
    const Scene        &scene;
    const CellEquations cell;
    const ConnectorLaw &law;
    std::vector<double> committed, trial;
    ConnectorMotion     connector_motion{};
    ConnectorResponse   response{};
    double              time = 0, load_before = 0, load_now = 0;
    Energies            energies;
  };

  /**
   * Positions around step i on the grid of the paper's Eqs. (23) to (25), where
   * velocities reach one step to both sides and accelerations two.
   */
  class TwoStepGrid
  {
  public:
    /** x(-2), x(-1), x(0), x(1). */
    explicit TwoStepGrid(const std::array<CellVector, 4> &first);

    /** Position at i; velocity [x(i+1) - x(i-1)] / (2 dt). */
    CellMotion motion(const double dt) const
    {
      return {x[2], (x[3] - x[1]) / (2 * dt)};
    }

    /** x(i-2). */
    const CellVector &before() const
    {
      return x[0];
    }

    /** Goes on to i + 1; @p next is x(i+2). */
    void shift(const CellVector &next)
    {
      x = {{x[1], x[2], x[3], next}};
    }

  private:
    std::array<CellVector, 4> x;
  };

  /** A scheme on the two-step grid: one sample, one evaluation a step. */
  class TwoStepScheme : public CellScheme
  {
  public:
    CellSample start() override;
    CellSample advance() override;

    unsigned long work() const override
    {
      return step + 1;
    }

  protected:
    /**
     * Throws InputError for uneven steps.
     * @param scene must outlive the object.
     */
    explicit TwoStepScheme(const Scene &scene);

    /** Sets the grid for the first sample; by default all positions are those
     * at rest. */
    virtual void set_first_positions()
    {}

    /** The sample of the step begun, and the grid made ready for the next. */
    virtual CellSample sample() = 0;

    const Scene  &scene;
    SteppedCell   cell;
    TwoStepGrid   grid{{}};
    unsigned long step = 0;
  };
} // namespace auxfem

#endif
