#include "random_scene.h"

#include <auxfem/mesh/strut_geometry.h>

#include <cmath>
#include <vector>

#include "random_structure.h"

namespace auxfem
{
  namespace testing_support
  {
    namespace
    {
      /** Adds features to a scene one after the other. */
      class SceneGenerator : RandomStructure
      {
      public:
        explicit SceneGenerator(const unsigned int seed) : RandomStructure(seed)
        {}

        RandomScene make()
        {
          add_frame();
          add_section();
          choose_scheme();
          add_supports();
          const double part = number(0, 1);
          if (part < 0.3)
            add_joint();
          else if (part < 0.55)
            add_rigid_part(scene.is_static);
          if (chance(0.5))
            add_connector({"spring",
                           "dashpot",
                           "kelvin-voigt",
                           "maxwell",
                           "standard-linear-solid",
                           "generalized-maxwell"},
                          scene.is_static ? 0.3 : period);
          if (chance(0.3))
            add_mass();
          scene.final_load.emplace();
          if (chance(0.2))
            add_gravity();
          add_load();
          if (chance(0.5))
            add_plate();
          // Last, so that the other features of a seed stay the same.
          add_law();
          if (chance(0.3))
            add_nonlinear_connector(!has_stages);
          scene_text.probe("tip", std::to_string(points.size() - 1));
          scene.text     = scene_text;
          scene.features = features;
          return scene;
        }

      private:
        /** A rigid body beside a strut. */
        struct Body
        {
          bool    is_cylinder;
          double  radius; ///< m
          Point   centre;
          Vector  axis_direction;
          Vector  away; ///< unit vector from the strut
          Segment axis; ///< of a sphere next to nothing
        };

        void add_supports()
        {
          scene_text.support("foot", "0", "clamp");
          const unsigned int last = points.size() - 1;
          if (points.size() > 2 && chance(0.2))
            {
              scene_text.prescribe("side",
                                   std::to_string(last),
                                   {history(number(-0.2, 0.2) * length),
                                    "free",
                                    "free"});
              note("moved support");
            }
          else if (points.size() > 2 && chance(0.3))
            {
              scene_text.support("side", std::to_string(last), "roller x");
              note("roller");
            }
        }

        void choose_scheme()
        {
          const std::string scheme = one_of<std::string>({"static",
                                                          "static",
                                                          "newmark",
                                                          "generalized-alpha",
                                                          "hht",
                                                          "energy-momentum",
                                                          "esdirk"});
          scene.is_static          = scheme == "static";
          has_stages               = scheme == "esdirk";
          note(scheme);
          end_time = scene.is_static ? 1 : 10 * period;
          scene_text.time(end_time, end_time / 20, scheme);
          if (!scene.is_static)
            scene_text.time(end_time, end_time / 200, scheme);
          if (chance(0.2))
            {
              scene_text.set("Output/Time between rows", end_time / 33);
              note("rows within steps");
            }
          if (!scene.is_static && scheme != "energy-momentum" && chance(0.2))
            {
              scene_text.set("Time/Relative tolerance", 1e-3);
              note("tolerance");
            }
          if (chance(0.3))
            {
              scene_text.mesh(1 + static_cast<unsigned int>(number(1, 4)),
                              static_cast<unsigned int>(number(0, 3)));
              note("other mesh");
            }
          if (chance(0.3))
            {
              scene_text.set("Effects/Large rotation", "on");
              note("exact kinematics");
            }
        }

        /** Lets some lattices relax or yield. */
        void add_law()
        {
          const double part = number(0, 1);
          if (part > 0.4)
            return;
          std::string law;
          if (part < 0.2 && !has_stages)
            {
              const double yield = modulus * std::pow(10., number(-3, -2));
              law = "Law = elastic-plastic | Yield stress = " + text(yield) +
                " | Plastic strains = 1 | Flow stresses = " +
                text(yield + number(0.02, 0.1) * modulus);
              if (chance(0.3))
                law += " | Shear and torsion = yield";
              note("yielding struts");
            }
          else
            {
              law = "Law = viscoelastic | Relaxing parts = " +
                text(number(0.1, 0.4)) +
                ", 0.3 | Relaxation times = " + text(0.1 * period) + ", " +
                text(number(1, 20) * period);
              note("relaxing struts");
            }
          scene_text.remove("Sections/strut/Young's modulus");
          scene_text.remove("Sections/strut/Density");
          scene_text.remove("Sections/strut/Poisson's ratio");
          if (has_damped_struts)
            scene_text.remove("Sections/strut/Stiffness-proportional damping");
          scene_text.add("Materials/law",
                         law + " | Young's modulus = " + text(modulus) +
                           " | Density = " + text(density) +
                           " | Poisson's ratio = 0.3");
          scene_text.set("Sections/strut/Material", "law");
        }

        void add_gravity()
        {
          const double whole = number(0.01, 0.2) * force_scale;
          double       mass  = 0;
          for (const auto &[a, b] : ends)
            mass += density * area * points[a].distance(points[b]);
          const double acceleration = -whole / mass;
          scene_text.set("Gravity/Acceleration y", acceleration);
          if (has_rigid_part || has_mass)
            scene.final_load.reset();
          else
            (*scene.final_load)[1] += acceleration * mass;
          note("gravity");
        }

        /** Grows smoothly to its value at the end of the time. */
        std::string history(const double value) const
        {
          return text(value) + " * (1 - cos(pi * t / " + text(end_time) +
            ")) / 2";
        }

        void add_load()
        {
          Vector force;
          for (unsigned int c = 0; c < dimension; ++c)
            force[c] = number(-0.5, 0.5) * force_scale;
          std::string kind = one_of<std::string>({"joint", "line", "follower"});
          // Where all struts are released there is no rotation to follow.
          if (has_releases || has_rigid_part)
            kind = "joint";
          note(kind + " load");
          if (kind == "line")
            {
              scene_text.add("Loads/wind", "Type = line | Struts = 0");
              const double size = points[0].distance(points[1]);
              for (unsigned int c = 0; c < dimension; ++c)
                {
                  scene_text.set(std::string("Loads/wind/Force per length ") +
                                   "xyz"[c],
                                 history(force[c] / size));
                  if (scene.final_load)
                    (*scene.final_load)[c] += force[c];
                }
              return;
            }
          const std::string joint = std::to_string(points.size() - 1);
          scene_text.set("Loads/push/Joints", joint);
          for (unsigned int c = 0; c < dimension; ++c)
            {
              scene_text.set(std::string("Loads/push/Force ") + "xyz"[c],
                             history(force[c]));
              if (scene.final_load)
                (*scene.final_load)[c] += force[c];
            }
          if (kind == "follower")
            {
              scene_text.set("Loads/push/Direction", "follows the joint");
              scene.final_load.reset();
            }
        }

        /** Whether a body at @p position, which leaves strut @p pressed by
         * @p gap, is clear of all others. */
        bool is_clear(const Body &body, const std::size_t pressed) const
        {
          for (std::size_t s = 0; s < ends.size(); ++s)
            if (s != pressed &&
                auxfem::distance(body.axis,
                                 {points[ends[s][0]], points[ends[s][1]]}) <
                  body.radius + 2 * thickness)
              return false;
          return true;
        }

        /** A body that is to press a strut aside somewhere along it, from
         * either side. */
        Body body_beside(const std::size_t strut, const double gap)
        {
          const Point &a = points[ends[strut][0]], &b = points[ends[strut][1]];
          const Vector along  = (b - a) / (b - a).norm();
          Vector       across = Point({-along[1], along[0], 0.});
          across *= (chance(0.5) ? 1 : -1) / across.norm();
          Body body;
          body.is_cylinder = dimension == 3 && chance(0.5);
          body.radius      = thickness * std::pow(10., number(-0.7, 1.3));
          body.away        = across;
          body.centre      = a + number(0.2, 0.8) * (b - a) +
            (body.radius + thickness / 2 + gap) * across;
          const Vector axis   = dealii::cross_product_3d(along, across);
          body.axis_direction = axis;
          const double half   = body.is_cylinder ? 100 * length : 1e-6 * length;
          body.axis = {body.centre - half * axis, body.centre + half * axis};
          return body;
        }

        void add_plate()
        {
          constexpr unsigned int n_trials = 20;
          for (unsigned int trial = 0; trial < n_trials; ++trial)
            {
              const std::size_t strut =
                static_cast<std::size_t>(number(0, ends.size()));
              const double gap  = number(0.1, 1) * thickness;
              const Body   body = body_beside(strut, gap);
              if (is_clear(body, strut))
                return add_body(body, gap + number(0.5, 4) * thickness);
            }
        }

        /** Which is moved by @p stroke (m), or thrown that way. */
        void add_body(const Body &body, const double stroke)
        {
          std::string entries = std::string("Shape = ") +
            (body.is_cylinder ? "cylinder" : "sphere") +
            " | Radius = " + text(body.radius) +
            " | Position = " + coordinates(body.centre);
          if (body.is_cylinder)
            entries += " | Axis = " + coordinates(body.axis_direction);
          const bool is_thrown = !scene.is_static && chance(0.5);
          for (unsigned int c = 0; c < 2; ++c)
            {
              const std::string axis = c == 0 ? "x" : "y";
              if (is_thrown)
                entries += " | Displacement " + axis + " = free" +
                  " | Initial velocity " + axis + " = " +
                  text(-5 * stroke / end_time * body.away[c]);
              else
                entries += " | Displacement " + axis + " = " +
                  history(-stroke * body.away[c]);
            }
          if (is_thrown)
            entries +=
              " | Mass = " + text(area * length * density * number(0.1, 3));
          scene_text.add("Plates/body", entries);
          // One element cannot follow the corner that a small body makes.
          scene_text.mesh(3, 1);
          if (!scene.is_static && chance(0.5))
            {
              scene_text.set("Contact/Friction coefficient", 0.3);
              note("friction");
            }
          note(std::string(is_thrown ? "thrown " : "moved ") +
               (body.is_cylinder ? "cylinder" : "sphere") + " of radius " +
               text(body.radius / thickness) + " thicknesses");
        }

        RandomScene scene;
        double      end_time; ///< s
        bool        has_stages = false;
      };
    } // namespace

    RandomScene random_scene(const unsigned int seed)
    {
      return SceneGenerator(seed).make();
    }
  } // namespace testing_support
} // namespace auxfem
