#ifndef auxfem_tests_support_followed_path_h
#define auxfem_tests_support_followed_path_h

#include <auxfem/analysis/simulation/imperfect_lattice.h>
#include <auxfem/output/recorder.h>
#include <auxfem/scene/scene.h>
#include <auxfem/simulation.h>

#include <array>
#include <string>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** Records a path of equilibria in this process, without files. Motions are
     * those of joints on this rank. */
    class FollowedPath : public Recorder
    {
    public:
      struct Point
      {
        double                       load_factor, arc_length;
        std::optional<unsigned long> n_negative;
        std::optional<int>           determinant_sign;
        Energies                     energies;
        /** By joint and component of motion. */
        std::vector<std::array<double, n_motion_components>> motions;
      };
      struct Singular : Point
      {
        SingularPoint::Kind kind;
        SingularPoint       singular;
      };

      /**
       * Follows the path of a scene, which need not say that it is one.
       * @param restart_checkpoint a checkpoint; nullptr: from the start
       */
      explicit FollowedPath(const std::string              &prm_text,
                            const std::vector<std::string> &overrides = {},
                            const MPI_Comm        communicator = MPI_COMM_SELF,
                            const CheckpointData *restart_checkpoint = nullptr)
        : former(restart_checkpoint)
      {
        std::vector<std::string> all = {"Analysis=static path"};
        all.insert(all.end(), overrides.begin(), overrides.end());
        const Scene scene = read_scene_from_text(prm_text, "test.prm", all);
        result            = run(scene, communicator, *this);
      }

      /** The singular points of one kind, in their order. */
      std::vector<Singular> points_of_kind(const SingularPoint::Kind kind) const
      {
        std::vector<Singular> found;
        for (const Singular &point : singular_points)
          if (point.kind == kind)
            found.push_back(point);
        return found;
      }

      std::vector<Singular> limits() const
      {
        return points_of_kind(SingularPoint::Kind::limit);
      }

      std::vector<Singular> bifurcations() const
      {
        return points_of_kind(SingularPoint::Kind::bifurcation);
      }

      std::vector<Point>    points;
      std::vector<Singular> singular_points;
      RunResult             result;
      /** Before every point but the first, with how many points and singular
       * points there were. */
      struct Checkpoint
      {
        CheckpointData records;
        std::size_t    n_points, n_singular_points;
      };
      std::vector<Checkpoint> checkpoints;

    private:
      void begin(const Equations &run_equations) override
      {
        equations = &run_equations;
      }

      void start(const Solution &solution) override
      {
        points.push_back(point(solution.state));
      }

      const CheckpointData *restart_checkpoint() const override
      {
        return former;
      }

      void store_checkpoint(CheckpointData records) override
      {
        checkpoints.push_back(
          {std::move(records), points.size(), singular_points.size()});
      }

      void step(const Solution &solution, const StepReport &) override
      {
        points.push_back(point(solution.state));
      }

      void singular_point(const Solution      &solution,
                          const SingularPoint &singular) override
      {
        singular_points.push_back(
          {point(solution.state), singular.kind, singular});
      }

      Point point(const State &state) const
      {
        Point       point{state.path->load_factor,
                    state.time,
                    state.path->n_negative,
                    state.path->determinant_sign,
                    state.energies,
                    {}};
        const auto &model = equations->model();
        point.motions.resize(model.lattice.joints.size());
        for (unsigned int joint = 0; joint < point.motions.size(); ++joint)
          for (const unsigned int c : model.numbering.components())
            if (model.numbering.joint_has(joint, c))
              if (const int i = model.numbering.joint_unknown(joint, c); i >= 0)
                point.motions[joint][c] = state.displacement[i];
        return point;
      }

      const Equations      *equations = nullptr;
      const CheckpointData *former;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
