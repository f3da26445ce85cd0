#ifndef auxfem_analysis_watch_h
#define auxfem_analysis_watch_h

#include <auxfem/analysis/tangent_solver.h>
#include <auxfem/output/verdict.h>
#include <auxfem/scene/scene.h>

#include <memory>
#include <optional>

namespace auxfem
{
  /**
   * Looks at a run while it goes on, and judges it at the end. All functions
   * are collective.
   */
  class Watch
  {
  public:
    virtual ~Watch() = default;

    /** The state at t = 0, in order. */
    virtual void start(const State & /*state*/)
    {}

    /**
     * A step, or a part of one, is solved and accepted; step.to has its
     * energies.
     * @param results of its end
     * @param solver of Newton's method, with the factorization it keeps
     */
    virtual void step(const Evaluation        &step,
                      const EvaluationResults &results,
                      TangentSolver           &solver) = 0;

    /**
     * Whether the ends of a static step, solved but not yet accepted, have
     * different numbers of negative modes.
     * @param solver as step()
     */
    virtual bool changes_stability(const Evaluation & /*step*/,
                                   TangentSolver & /*solver*/)
    {
      return false;
    }

    /** The next step leads to another equilibrium than the connected one, which
     * is known: the energy that is set free is no error. */
    virtual void expect_jump()
    {}

    /** What it makes of the run so far; the same on all ranks. */
    virtual std::vector<Finding> findings() const = 0;

    /** How deep struts have gone into plates or other struts so far, over their
     * thickness; none if it does not look at that. */
    virtual std::optional<double> largest_penetration() const
    {
      return std::nullopt;
    }

    /** @name For runs that are resumed. */
    ///@{
    virtual void save(Records &records) const   = 0;
    virtual void resume(const Records &records) = 0;
    ///@}
  };

  /**
   * ` (Time/Time step = ... s). A step of ... s would miss 1 %.`: the end of
   * what a watch says of steps that miss too much.
   * @param scene_step that of the scene (s)
   * @param missed part that its steps miss
   */
  std::string shorter_step_text(double                scene_step,
                                const ImplicitScheme &scheme,
                                double                missed);

  /** All watches that the scene gives cause for, one per file. */
  class Watches
  {
  public:
    /** @param scene, equations, work must outlive the object; @p work takes up
     * what they do. */
    Watches(const Scene &scene, const Equations &equations, Work &work);

    /** One more, which looks at what the others do not; returns it. Before
     * start(). */
    template <class Added>
    Added *add(std::unique_ptr<Added> watch)
    {
      Added *const added = watch.get();
      watches.push_back(std::move(watch));
      return added;
    }

    void start(const State &state);
    void step(const Evaluation        &step,
              const EvaluationResults &results,
              TangentSolver           &solver);

    /** Whether one says so. */
    bool changes_stability(const Evaluation &step, TangentSolver &solver);

    /** Says so to all. */
    void expect_jump()
    {
      for (const auto &watch : watches)
        watch->expect_jump();
    }

    /** Of all, the worst first. */
    std::vector<Finding> findings() const;

    /** Of the one that looks at that. */
    std::optional<double> largest_penetration() const;

    void save(Records &records) const;
    void resume(const Records &records);

  private:
    std::vector<std::unique_ptr<Watch>> watches;
  };

  /** @name The watches; only watch.cc needs them. */
  ///@{
  /** Of energy that is not accounted for, or that a scheme with inertia gives
   * or takes. */
  std::unique_ptr<Watch> make_energy_watch(const Scene     &scene,
                                           const Equations &equations);

  /** Of steps that are long for the motion that they follow. With inertia. */
  std::unique_ptr<Watch> make_step_watch(const Scene     &scene,
                                         const Equations &equations);

  /** Of loads that change within steps. With inertia. @p scene must outlive it. */
  std::unique_ptr<Watch> make_load_step_watch(const Scene &scene);

  /** Of strains that no linear law stands for; the scene has elastic struts. */
  std::unique_ptr<Watch> make_strain_watch(const Equations &equations);

  /** Of strains beyond those at which sections yield; a section has one. */
  std::unique_ptr<Watch> make_yield_watch(const Equations &equations);

  /** Of struts that buckle between their joints, which their elements do not
   * show; the scene has elastic struts. */
  std::unique_ptr<Watch> make_local_buckling_watch(const Scene     &scene,
                                                   const Equations &equations);

  /** Of bending that elements of order 1 miss; the scene simulates shear
   * flexibility, without which these bend as they should. */
  std::unique_ptr<Watch> make_bending_watch(const StrutGroup &linear_elements,
                                            const Scene      &scene,
                                            const Equations  &equations);

  /** Of bending waves shorter than elements resolve; the scene has elastic
   * struts, and inertia. */
  std::unique_ptr<Watch> make_wave_watch(const Scene     &scene,
                                         const Equations &equations);

  /** Of connectors that are shortened to nothing; the scene has some. */
  std::unique_ptr<Watch> make_connector_watch(const Equations &equations);

  /** Of struts that go deep into plates; the scene has some. */
  std::unique_ptr<Watch> make_contact_watch(const Equations &equations);

  /** Of impacts that steps do not resolve. With inertia; the scene has contact.
   */
  std::unique_ptr<Watch> make_impact_watch(const Scene     &scene,
                                           const Equations &equations);

  /** Of loads that are too fast to leave inertia out, where time has a meaning.
   */
  std::unique_ptr<Watch> make_load_speed_watch(const Scene     &scene,
                                               const Equations &equations);

  /** Of struts that touch or pass through each other; the scene has elastic
   * struts. */
  std::unique_ptr<Watch> make_crossing_watch(const Scene     &scene,
                                             const Equations &equations);

  /** Of struts that go through plates where contact is left out; the scene has
   * plates. @p scene must outlive it. */
  std::unique_ptr<Watch> make_plate_crossing_watch(const Scene     &scene,
                                                   const Equations &equations);

  /** Of displacements too large for the small-displacement form, in linear
   * scenes. */
  std::unique_ptr<Watch>
  make_small_displacement_watch(const Scene     &scene,
                                const Equations &equations,
                                Work            &work);

  /** Watches free lattices in space whose spin makes errors grow beyond the
   * tolerance that the steps follow. Without rigid parts. */
  std::unique_ptr<Watch> make_spin_watch(const Scene     &scene,
                                         const Equations &equations);

  /** Of equilibria and motions that a disturbance would leave. */
  std::unique_ptr<Watch> make_stability_watch(const Scene     &scene,
                                              const Equations &equations,
                                              Work            &work);
  ///@}
} // namespace auxfem

#endif
