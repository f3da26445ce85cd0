#ifndef auxfem_reduced_cell_cell_scheme_h
#define auxfem_reduced_cell_cell_scheme_h

#include <auxfem/scene/scene.h>
#include <auxfem/time/schemes.h>

#include <deal.II/base/numbers.h>

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
   * The cell at one time, a row of its history. What a scheme does not know is
   * not a number.
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
  void refuse_not_finite(const CellSample &sample);

  /** An angle (rad) as users read it (deg). */
  inline double degrees(const double radians)
  {
    return radians * 180 / dealii::numbers::PI;
  }

  /** Takes the reduced cell of a scene through time, step by step. */
  class CellScheme
  {
  public:
    virtual ~CellScheme() = default;

    /**
     * The cell at t = 0, at rest. To be called once, before advance(). Throws
     * ComputationError if there is no first acceleration.
     */
    virtual CellSample start() = 0;

    /**
     * Advances by one step of the scene. Throws ComputationError if it cannot;
     * the samples until then hold.
     */
    virtual CellSample advance() = 0;

    /** Iterations, or evaluations of the equations, so far. */
    virtual unsigned long work() const = 0;
  };

  /** A choice of `Time/Scheme` that takes the reduced cell through time itself.
   */
  class CellMethod : public TimeScheme
  {
  public:
    using TimeScheme::TimeScheme;

    /**
     * The scheme at work on @p scene, which must outlive it. Throws InputError
     * if it cannot do the scene.
     */
    virtual std::unique_ptr<CellScheme> begin(const Scene &scene) const = 0;
  };

  /** The choice whose work a @p Scheme does, which is made of a scene. */
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
   * The scheme of @p scene, which must outlive it. Throws InputError if the
   * scheme cannot do the scene.
   */
  std::unique_ptr<CellScheme> make_cell_scheme(const Scene &scene);

  /** A scheme of lattices at work on the cell of @p scene. */
  std::unique_ptr<CellScheme> make_implicit_cell_scheme(const Scene &scene);
} // namespace auxfem

#endif
