#ifndef auxfem_analysis_reduced_cell_cell_scheme_h
#define auxfem_analysis_reduced_cell_cell_scheme_h

#include <auxfem/analysis/reduced_cell/cell_equations.h>
#include <auxfem/scene/scene.h>
#include <auxfem/time/schemes/time_scheme.h>

#include <deal.II/base/numbers.h>

#include <array>
#include <memory>

namespace auxfem
{
  /** Entries of the reduced cell's energy ledger, in order. */
  enum CellEnergy : unsigned int
  {
    cell_kinetic,
    cell_stored,
    cell_dissipated,
    cell_work
  };

  /** Energies of the reduced cell at rest. */
  Energies cell_energies();

  /**
   * State of the cell at one time, a row of its history. Values that a scheme
   * does not compute are NaN.
   */
  struct CellSample
  {
    double   time;        ///< s
    double   angle;       ///< theta (rad)
    double   upper_rise;  ///< Y1 (m)
    double   lower_rise;  ///< Y2 (m)
    double   load;        ///< f1 (N)
    double   transmitted; ///< f2 on the foundation (N), positive in compression
    Energies energies;
  };

  /** Throws ComputationError if a number of @p sample is not finite. */
  void require_finite(const CellSample &sample);

  /** Converts an angle from rad to deg. */
  inline double degrees(const double radians)
  {
    return radians * 180 / dealii::numbers::PI;
  }

  /** Time integration of the reduced cell of a scene, step by step; each scheme
   * of the reduced cell derives from it. */
  class CellScheme
  {
  public:
    virtual ~CellScheme() = default;

    /**
     * Sample at t = 0, at rest; called once, before advance(). Throws
     * ComputationError if the initial acceleration does not exist.
     */
    virtual CellSample start() = 0;

    /**
     * Advances by one step of the scene. Throws ComputationError on failure;
     * earlier samples remain valid.
     */
    virtual CellSample advance() = 0;

    /** Number of iterations or evaluations of the equations so far. */
    virtual unsigned long work() const = 0;
  };

  /** A choice of `Time/Scheme` that integrates the reduced cell. */
  class CellMethod : public TimeScheme
  {
  public:
    using TimeScheme::TimeScheme;

    /**
     * Creates the scheme for @p scene, which must outlive it. Throws InputError
     * if the scheme does not support the scene.
     */
    virtual std::unique_ptr<CellScheme> begin(const Scene &scene) const = 0;
  };

  /** CellMethod that is implemented by @p Scheme, constructed from a scene. */
  template <class Scheme>
  class CellMethodOf : public CellMethod
  {
  public:
    using CellMethod::CellMethod;

    std::unique_ptr<CellScheme> begin(const Scene &scene) const override
    {
      return std::make_unique<Scheme>(scene);
    }
  };

  /**
   * Creates the scheme of @p scene, which must outlive it. Throws InputError if
   * the scheme does not support the scene.
   */
  std::unique_ptr<CellScheme> make_cell_scheme(const Scene &scene);

  /** Adapts a time scheme of lattices to the cell of @p scene. */
  std::unique_ptr<CellScheme> make_implicit_cell_scheme(const Scene &scene);

  /**
   * Load, connector and energies of the reduced cell for step-by-step schemes.
   * The connector law receives trial motions of a step until one is accepted.
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

    /** Length of the current step (s). */
    double dt() const
    {
      return connector_motion.dt;
    }

    /** Load f1 at the end of the step (N). */
    double load() const
    {
      return load_now;
    }

    /**
     * Force and tangents of the connector at the end of the step for the trial
     * @p motion.
     */
    const ConnectorResponse &connector(const CellMotion &motion);

    /**
     * Accepts @p motion as the end of the step and updates internal variables
     * and energies. The load works with its mean over the step, as for
     * lattices. Throws ComputationError if a number of the sample is not
     * finite.
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

    /** Computes the sample of the current step and shifts the grid. */
    virtual CellSample sample() = 0;

    const Scene  &scene;
    SteppedCell   cell;
    TwoStepGrid   grid{{}};
    unsigned long step = 0;
  };
} // namespace auxfem

#endif
