#ifndef auxfem_tests_equations_equations_on_ranks_h
#define auxfem_tests_equations_equations_on_ranks_h

#include <auxfem/equations/equations.h>
#include <auxfem/model/build_lattice.h>

#include <deal.II/fe/fe_q.h>

#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** A scene from `.prm` text with its model and equations on given ranks,
     * and room for one evaluation. */
    struct EquationsOnRanks
    {
      explicit EquationsOnRanks(const std::string              &prm_text,
                                const std::vector<std::string> &overrides = {},
                                const MPI_Comm communicator = MPI_COMM_WORLD)
        : scene(read_scene_from_text(prm_text, "test.prm", overrides))
        , lattice(build_lattice(scene))
        , model(scene, lattice, communicator)
        , equations(scene, model)
        , results(equations.make_results())
      {}

      const DofNumbering &dofs() const
      {
        return model.numbering;
      }

      /** A step with inertia or without, as the scene's scheme has it. */
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

      /** Of the evaluation last given to residual(). */
      void tangent(const Evaluation     &evaluation,
                   const TangentFactors &factors,
                   TangentMatrix        &matrix) const
      {
        equations.tangent(evaluation, results, factors, matrix);
      }

      /** Of the evaluation last given to residual(). */
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

    /**
     * What an unknown is, independent of its number: joint or strut, fraction
     * of the strut's length, component. Released ends count as points of the
     * strut, rigid parts and constraints as joints past the last.
     */
    using UnknownName = std::tuple<bool, unsigned int, double, unsigned int>;

    /** Name and position at rest of a local unknown. */
    struct NamedUnknown
    {
      UnknownName      name;
      dealii::Point<3> position;
    };

    /** Unknowns of the rigid parts themselves and all multipliers. */
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
      // A hinge has two.
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
      const dealii::FE_Q<1>     fe(dofs.order());
      for (unsigned int e = 0; e < dofs.elements().size(); ++e)
        {
          const StrutMesh::Interval &interval = dofs.elements()[e].interval;
          for (unsigned int a = 0; a <= dofs.order(); ++a)
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

    /**
     * Fills @p vector with an irregular field of about @p size that depends on
     * where an unknown lies and what it is, not on its number.
     */
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

    /** Values of @p vector at this rank's own unknowns, by their names. */
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
     * mass of 1.5 kg/m, with @p further subsections.
     */
    inline std::string frame_scene(const std::string &joints,
                                   const std::string &struts,
                                   const std::string &further)
    {
      return "subsection Lattice\n  set Cell = frame\n  set Joints = " +
        joints + "\n  set Struts = " + struts + R"(
end
subsection Sections
  subsection band
    set Shape = given
    set Area = 3
    set Shear area = 5
    set Second moment of area = 0.7
    set Young's modulus = 1
    set Poisson's ratio = 0.25
    set Density = 0.5
  end
end
)" + further;
    }

    /**
     * A cantilever of 1 m (EA = 3, EI = 0.7) with @p force across its free end,
     * joint 1, and @p time in subsection Time.
     */
    inline std::string cantilever(const std::string &force,
                                  const std::string &time)
    {
      return frame_scene("0 0; 1 0",
                         "0 1",
                         "subsection Supports\n"
                         "  subsection wall\n"
                         "    set Joints = 0\n"
                         "    set Type = clamp\n"
                         "  end\n"
                         "end\n"
                         "subsection Loads\n"
                         "  subsection tip\n"
                         "    set Joints = 1\n"
                         "    set Force y = " +
                           force + "\n  end\nend\nsubsection Time\n" + time +
                           "end\n");
    }

    /**
     * Star cells with strut length 1 and section stiffnesses of about one, and
     * everything a scene may have: hinges, rotational springs, connectors of
     * several laws, prescribed motion, masses, loads, gravity, damping.
     */
    inline std::string star_with_everything(const unsigned int n_x,
                                            const unsigned int n_y)
    {
      return "subsection Lattice\n"
             "  set Cell = star\n"
             "  set Cells x = " +
        std::to_string(n_x) + "\n  set Cells y = " + std::to_string(n_y) +
        R"(
  set Strut length = 1
  set Opening angle = 60 deg
end
subsection Sections
  subsection band
    set Shape = given
    set Area = 3
    set Shear area = 5
    set Second moment of area = 0.7
    set Young's modulus = 1
    set Poisson's ratio = 0.3
    set Density = 0.5
    set Stiffness-proportional damping = 0.3
    set Mass-proportional damping = 0.4
  end
end
subsection Joints
  subsection springs
    set Joints = tips
    set Type = rotational spring
    set Stiffness = 0.8
  end
  subsection hinges
    set Joints = top
    set Type = hinge
  end
end
subsection Connectors
  subsection damper
    set Law = kelvin-voigt
    set Spring stiffness = 0.6
    set Damping coefficient = 0.9
  end
  subsection relaxing
    set Law = maxwell
    set Spring stiffness = 0.7
    set Damping coefficient = 1.1
    set Between = in-cell x
  end
  subsection fixed direction
    set Law = standard-linear-solid
    set Long-time stiffness = 0.2
    set Spring stiffness = 0.5
    set Damping coefficient = 0.4
    set Between = 0 5; 1 6
    set Geometry = direction
    set Direction = 1 2
  end
  subsection anchors
    set Law = kelvin-voigt
    set Spring stiffness = 0.4
    set Damping coefficient = 0.2
    set Between = ground: top
    set Ground offset = 0.3 1.5
  end
end
subsection Supports
  subsection foundation
    set Joints = bottom
    set Type = clamp
  end
  subsection shaker
    set Joints = left
    set Type = prescribed
    set Displacement x = 0.02 * sin(3 * t)
  end
end
subsection Masses
  subsection weights
    set Joints = tips
    set Mass = 0.3
  end
  subsection flywheels
    set Joints = notches
    set Mass = 0.1
    set Rotary inertia = 0.2
  end
end
subsection Loads
  subsection push
    set Joints = top
    set Force y = -0.2 * t
    set Force x = 0.05
  end
  subsection wind
    set Type = line
    set Struts = all
    set Force per length x = 0.01 * t
  end
end
subsection Gravity
  set Acceleration y = -0.1
end
subsection Discretization
  set Order = 2
end
subsection Time
  set End time = 0.5
  set Time step = 0.05
end
)";
    }

    /**
     * 2 x 2 x 2 stars in space with all that star_with_everything() has, a
     * revolute hinge and loads in all directions: hit so hard that struts turn
     * far.
     */
    inline std::string space_star_with_everything()
    {
      std::string text    = star_with_everything(2, 2);
      const auto  replace = [&text](const std::string &from,
                                   const std::string &to) {
        text.replace(text.find(from), from.size(), to);
      };
      replace("set Cell = star\n",
              "set Cell = space star\n  set Cells z = 2\n");
      replace("60 deg", "70 deg");
      replace("set Direction = 1 2", "set Direction = 1 2 -1");
      replace("set Ground offset = 0.3 1.5", "set Ground offset = 0.3 1.5 0.4");
      replace("set Rotary inertia = 0.2", "set Rotary inertia = 0.2 0.1 0.3");
      replace("set Force y = -0.2 * t", "set Force y = -3 * t");
      return "set Dimension = 3\n" + text + R"(
subsection Joints
  subsection axles
    set Joints = 8
    set Struts = 0
    set Type = revolute
    set Axis = 1 2 3
  end
end
subsection Loads
  subsection turn
    set Joints = notches
    set Direction = follows the joint
    set Force z = 0.3 * t
    set Moment x = 0.4 * t
    set Moment y = -0.2
    set Moment z = 0.3 * t^2
  end
end
)";
    }
  } // namespace testing_support
} // namespace auxfem

#endif
