#ifndef auxfem_tests_equations_equations_on_ranks_h
#define auxfem_tests_equations_equations_on_ranks_h

#include <auxfem/equations/equations.h>
#include <auxfem/model/build_lattice.h>

#include <deal.II/fe/fe_q.h>

#include <support/scene_text.h>

#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** A scene from `.prm` text with model, equations and one evaluation on
     * given ranks. */
    struct EquationsOnRanks
    {
      explicit EquationsOnRanks(const std::string              &prm_text,
                                const std::vector<std::string> &overrides = {},
                                const MPI_Comm communicator = MPI_COMM_WORLD)
        : scene(read_scene_from_text(prm_text, "test.prm", overrides))
        , lattice(build_lattice(scene))
        , model(scene, lattice, communicator)
        , equations(model)
        , results(equations.make_results())
      {}

      const DofNumbering &dofs() const
      {
        return model.numbering;
      }

      /** A step with or without inertia, according to the scheme. */
      Evaluation step(const State &from, State &to, const double dt) const
      {
        return scene.time.implicit_scheme().is_dynamic()
          ? Evaluation::step(from, to, dt)
          : Evaluation::static_step(from, to, dt);
      }

      /** Evaluates; the results are kept for tangent() and accept(). */
      const EvaluationResults &residual(const Evaluation &evaluation)
      {
        equations.residual(evaluation, results);
        return results;
      }

      /** Uses the evaluation last passed to residual(). */
      void tangent(const Evaluation     &evaluation,
                   const TangentFactors &factors,
                   TangentMatrix        &matrix) const
      {
        equations.tangent(evaluation, results, factors, matrix);
      }

      /** Uses the evaluation last passed to residual(). */
      void accept(const Evaluation &evaluation) const
      {
        equations.accept(evaluation, results);
      }

      std::unique_ptr<TangentMatrix> make_tangent() const
      {
        return std::make_unique<TangentMatrix>(equations.pattern());
      }

      const Scene        scene;
      const Lattice      lattice;
      const LatticeModel model;
      Equations          equations;
      EvaluationResults  results;
    };

    /** Partition-independent name of an unknown: joint or strut, fraction of
     * the length, component. Released ends are points of the strut; rigid parts
     * and constraints are joints past the last. */
    using UnknownName = std::tuple<bool, unsigned int, double, unsigned int>;

    /** Name and position at rest of a local unknown. */
    struct NamedUnknown
    {
      UnknownName      name;
      dealii::Point<3> position;
    };

    /** Unknowns owned by rigid parts and all multipliers. */
    inline void name_constraints(const LatticeModel        &model,
                                 std::vector<NamedUnknown> &names)
    {
      const DofNumbering &dofs       = model.numbering;
      const Lattice      &lattice    = model.lattice;
      unsigned int        number     = lattice.joints.size();
      unsigned int        n_of_parts = 0;
      for (unsigned int part = 0; part < lattice.rigid_parts.size(); ++part)
        {
          const dealii::Point<3> &centre =
            lattice.rigid_parts[part].centre_of_mass;
          for (unsigned int c = 0; c < n_motion_components; ++c)
            if (dofs.constraints().motion(part, c) >= 0)
              names[dofs.constraints().motion(part, c)] =
                {{true, number, 0., c}, centre};
          ++number;
          for (unsigned int i = 0; i < dofs.constraints().n_multipliers(part);
               ++i)
            if (dofs.constraints().multiplier(part, i) >= 0)
              names[dofs.constraints().multiplier(part, i)] =
                {{true, number, double(i), n_motion_components}, centre};
          ++number;
          n_of_parts += dofs.constraints().n_multipliers(part);
        }
      // A hinge has two multipliers.
      const unsigned int n_hinges =
        (dofs.constraints().n_multipliers() - n_of_parts) / 2;
      for (unsigned int hinge = 0; hinge < n_hinges; ++hinge, ++number)
        for (unsigned int i = 0; i < 2; ++i)
          if (dofs.constraints().hinge_multiplier(hinge, i) >= 0)
            names[dofs.constraints().hinge_multiplier(hinge, i)] =
              {{true, number, double(i), n_motion_components}, {}};
    }

    /** Names of all local unknowns. */
    inline std::vector<NamedUnknown> name_unknowns(const LatticeModel &model)
    {
      const DofNumbering       &dofs    = model.numbering;
      const Lattice            &lattice = model.lattice;
      std::vector<NamedUnknown> names(dofs.layout().n_local());
      const dealii::FE_Q<1>     fe(dofs.divisions().front().order);
      for (unsigned int e = 0; e < dofs.elements().size(); ++e)
        {
          const StrutInterval &interval = dofs.elements()[e].interval;
          for (unsigned int a = 0; a <= dofs.divisions().front().order; ++a)
            for (unsigned int c = 0; c < dofs.n_components(); ++c)
              {
                const double s = interval.begin +
                  (interval.end - interval.begin) *
                    fe.get_unit_support_points()[a][0];
                dealii::Tensor<1, 3> tangent;
                NamedUnknown        &unknown =
                  names[dofs.element_unknowns(e)[dofs.n_components() * a + c]];
                unknown.name = {false, interval.strut, s, dofs.components()[c]};
                lattice.axis(lattice.struts[interval.strut],
                             s,
                             unknown.position,
                             tangent);
              }
        }
      for (unsigned int s = 0; s < lattice.struts.size(); ++s)
        for (unsigned int end = 0; end < 2; ++end)
          for (const unsigned int c : dofs.components())
            if (c >= first_rotation && dofs.end_rotation(s, end, c) >= 0)
              names[dofs.end_rotation(s, end, c)] = {
                {false, s, double(end), c},
                lattice.joints[lattice.struts[s].joints[end]]};
      for (unsigned int joint = 0; joint < lattice.joints.size(); ++joint)
        for (const unsigned int c : dofs.components())
          if (dofs.joint_unknown(joint, c) >= 0)
            names[dofs.joint_unknown(joint, c)] = {{true, joint, 0., c},
                                                   lattice.joints[joint]};
      name_constraints(model, names);
      return names;
    }

    /** Fills @p vector with an irregular field of about @p size that depends on
     * position and kind of unknowns only. */
    inline void fill_by_position(const LatticeModel &model,
                                 const double        size,
                                 Vector             &vector)
    {
      const std::vector<NamedUnknown> names = name_unknowns(model);
      for (unsigned int i = 0; i < names.size(); ++i)
        {
          const auto &[at_joint, index, fraction, component] = names[i].name;
          const double phase = 2. * component + (at_joint ? 0. : 0.7 * index);
          vector[i]          = size *
            std::sin(1.3 * names[i].position[0] + 2.1 * names[i].position[1] +
                     0.9 * names[i].position[2] + phase);
        }
    }

    /** Values of @p vector at owned unknowns, by name. */
    inline std::map<UnknownName, double> by_name(const LatticeModel &model,
                                                 const Vector       &vector)
    {
      const std::vector<NamedUnknown> names = name_unknowns(model);
      std::map<UnknownName, double>   values;
      for (unsigned int i = 0; i < model.numbering.layout().n_owned(); ++i)
        values[names[i].name] = vector[i];
      return values;
    }

    /**
     * A frame of straight struts with section stiffnesses of about one and a
     * mass of 1.5 kg/m, with @p further parameters.
     */
    inline SceneText frame_scene(const std::string &joints,
                                 const std::string &struts,
                                 const SceneText   &further = {})
    {
      return SceneText()
        .frame(joints, struts)
        .given("band", {3, 5, 0.7}, {1, 0.5, 0.25})
        .add(further);
    }

    /**
     * A cantilever of 1 m (EA = 3, EI = 0.7) with @p force across its free end,
     * joint 1, and @p time in subsection Time; see SceneText::add().
     */
    inline SceneText cantilever(const std::string &force,
                                const std::string &time)
    {
      return frame_scene("0 0; 1 0", "0 1")
        .support("wall", "0", "clamp")
        .add("Loads/tip", "Joints = 1 | Force y = " + force)
        .add("Time", time);
    }

    /** Star cells with strut length 1 and section stiffnesses of about one and
     * all features: hinges, springs, connectors, prescribed motion, masses,
     * loads, gravity, damping. */
    inline SceneText star_with_everything(const unsigned int n_x,
                                          const unsigned int n_y)
    {
      return SceneText()
        .cells("star", n_x, n_y)
        .add("Lattice", "Strut length = 1 | Opening angle = 60 deg")
        .given("band", {3, 5, 0.7}, {1, 0.5, 0.3})
        .add("Sections/band",
             "Stiffness-proportional damping = 0.3 | "
             "Mass-proportional damping = 0.4")
        .add("Materials/rubber",
             "Law = viscoelastic | Young's modulus = 1 | Density = 0.5 | "
             "Relaxing parts = 0.5 | Relaxation times = 0.3 | "
             "Volume change = elastic")
        .add("Sections/rubber",
             "Struts = 1, 2 | Material = rubber | Shape = given | Area = 3 | "
             "Shear area = 5 | Second moment of area = 0.7")
        .add("Joints/springs",
             "Joints = tips | Type = rotational spring | Stiffness = 0.8")
        .add("Joints/hinges", "Joints = top | Type = hinge")
        .connector("damper",
                   "kelvin-voigt",
                   "Spring stiffness = 0.6 | "
                   "Damping coefficient = 0.9")
        .connector("relaxing",
                   "maxwell",
                   "Spring stiffness = 0.7 | "
                   "Damping coefficient = 1.1 | Between = in-cell x")
        .connector(
          "fixed direction",
          "standard-linear-solid",
          "Long-time stiffness = 0.2 | "
          "Spring stiffness = 0.5 | Damping coefficient = 0.4 | "
          "Between = 0 5; 1 6 | Geometry = direction | Direction = 1 2")
        .connector("anchors",
                   "kelvin-voigt",
                   "Spring stiffness = 0.4 | "
                   "Damping coefficient = 0.2 | Between = ground: top | "
                   "Ground offset = 0.3 1.5")
        .support("foundation", "bottom", "clamp")
        .add("Supports/shaker",
             "Joints = left | Type = prescribed | "
             "Displacement x = 0.02 * sin(3 * t)")
        .mass("weights", "tips", 0.3)
        .mass("flywheels", "notches", 0.1, 0.2)
        .add("Loads/push", "Joints = top | Force y = -0.2 * t | Force x = 0.05")
        .add("Loads/wind",
             "Type = line | Struts = all | Force per length x = 0.01 * t")
        .set("Gravity/Acceleration y", -0.1)
        .mesh(2)
        .time(0.5, 0.05);
    }

    /** star_with_everything() with connectors and rotational springs that are
     * not linear, rub and break; not for schemes with stages. */
    inline SceneText star_with_nonlinear_connectors(const unsigned int n_x,
                                                    const unsigned int n_y)
    {
      return star_with_everything(n_x, n_y)
        .connector("hardening",
                   "cubic",
                   "Spring stiffness = 0.3 | Cubic stiffness = 5 | "
                   "Damping coefficient = 0.1 | Preload = 0.01")
        .connector("stop",
                   "gap",
                   "Spring stiffness = 0.9 | Gap = 0.001 | "
                   "Stop damping = 0.5 | Between = in-cell x")
        .connector("viscous",
                   "power-law-dashpot",
                   "Force at unit rate = 0.1 | Exponent = 0.5 | "
                   "Smoothing rate = 0.01 | Between = 0 5; 1 6")
        .connector("formula",
                   "expression",
                   "Force = 0.3*u + 0.2*tanh(2*u) + 0.1*v*abs(v) | "
                   "Between = ground: top | Ground offset = 0.3 1.5")
        .connector("friction",
                   "friction-slider",
                   "Spring stiffness = 0.5 | Slip force = 5e-5 | "
                   "Hardening stiffness = 0.1 | Between = in-cell x")
        .connector("fuse",
                   "spring",
                   "Spring stiffness = 0.5 | Failure force = 1e-4 | "
                   "Between = in-cell x")
        .remove("Joints/springs/Stiffness")
        .set("Joints/springs/Type", "rotational friction-slider")
        .set("Joints/springs/Spring stiffness", 0.8)
        .set("Joints/springs/Slip moment", 1e-6)
        .set("Joints/springs/Hardening stiffness", 0.5);
    }

    /** Struts that yield at a stress of 0.05. Few fibres rarely begin to yield
     * within a difference quotient. */
    inline SceneText yielding_struts(const std::string &struts)
    {
      return SceneText()
        .add("Materials/steel",
             "Law = elastic-plastic | Young's modulus = 1 | Density = 1 | "
             "Poisson's ratio = 0.3 | Yield stress = 0.05 | "
             "Plastic strains = 100 | Flow stresses = 20 | "
             "Kinematic hardening modulus = 0.1 | Grid = 2 | Layers = 2")
        .add("Sections/steel",
             "Struts = " + struts +
               " | Material = steel | Shape = rectangle | Width = 1.2 | "
               "Height = 1.7");
    }

    /** 2 x 1 x 2 stars in space with the features of star_with_everything(), a
     * revolute hinge and loads that cause large rotations. */
    inline SceneText space_star_with_everything()
    {
      return star_with_everything(2, 1)
        .dimension(3)
        .add("Lattice",
             "Cell = space star | Cells z = 2 | Opening angle = 70 deg")
        .set("Connectors/fixed direction/Direction", "1 2 -1")
        .set("Connectors/anchors/Ground offset", "0.3 1.5 0.4")
        .set("Masses/flywheels/Rotary inertia", "0.2 0.1 0.3")
        .set("Loads/push/Force y", "-3 * t")
        .add("Joints/axles",
             "Joints = 8 | Struts = 0 | Type = revolute | Axis = 1 2 3")
        .add("Loads/turn",
             "Joints = notches | Direction = follows the joint | "
             "Force z = 0.3 * t | Moment x = 0.4 * t | Moment y = -0.2 | "
             "Moment z = 0.3 * t^2");
    }
  } // namespace testing_support
} // namespace auxfem

#endif
