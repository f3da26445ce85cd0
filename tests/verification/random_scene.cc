#include "random_scene.h"

#include <auxfem/mesh/segment.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    namespace
    {
      /** Adds features to a scene one after the other. */
      class SceneGenerator
      {
      public:
        explicit SceneGenerator(const unsigned int seed) : generator(seed)
        {
          dimension = chance(0.5) ? 2 : 3;
          scene.text.dimension(dimension);
        }

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
            add_rigid_part();
          if (chance(0.5))
            add_connector();
          if (chance(0.3))
            add_mass();
          scene.final_load.emplace();
          if (chance(0.2))
            add_gravity();
          add_load();
          if (chance(0.5))
            add_plate();
          scene.text.probe("tip", std::to_string(points.size() - 1));
          return scene;
        }

      private:
        using Point  = dealii::Point<3>;
        using Vector = dealii::Tensor<1, 3>;

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

        /** The standard's distributions differ among libraries. */
        double number(const double low, const double high)
        {
          return low + (high - low) * (generator() / 4294967296.);
        }

        bool chance(const double probability)
        {
          return number(0, 1) < probability;
        }

        template <class Value>
        Value one_of(const std::vector<Value> &values)
        {
          return values[static_cast<std::size_t>(number(0, values.size()))];
        }

        std::string coordinates(const Vector &point) const
        {
          std::string result = text(point[0]) + " " + text(point[1]);
          return dimension == 3 ? result + " " + text(point[2]) : result;
        }

        void note(const std::string &feature)
        {
          scene.features += (scene.features.empty() ? "" : ", ") + feature;
        }

        /** A chain of joints that climbs, so that no struts cross, with
         * braces. */
        void add_frame()
        {
          const unsigned int n = static_cast<unsigned int>(number(3, 6));
          std::string        joints, struts;
          for (unsigned int i = 0; i < n; ++i)
            {
              // Left, right, left, ...: braces join next but one neighbours.
              const double side = i % 2 == 0 ? 0. : 1.;
              const double x    = side + number(-0.2, 0.2),
                           y    = 0.6 * i + number(-0.15, 0.15),
                           z    = dimension == 3 ? number(-0.4, 0.4) : 0.;
              points.push_back(length * Point(x, y, z));
              joints += (i > 0 ? "; " : "") + coordinates(points.back());
            }
          for (unsigned int i = 0; i + 1 < n; ++i)
            ends.push_back({i, i + 1});
          for (unsigned int i = 0; i + 2 < n; ++i)
            if (chance(0.5))
              ends.push_back({i, i + 2});
          for (std::size_t s = 0; s < ends.size(); ++s)
            struts += (s > 0 ? "; " : "") + std::to_string(ends[s][0]) + " " +
              std::to_string(ends[s][1]);
          scene.text.frame(joints, struts);
        }

        void add_section()
        {
          thickness = number(0.02, 0.06) * length;
          modulus   = std::pow(10., number(7, 11));
          density   = number(900, 8000);
          const Material material{modulus, density, 0.3};
          const bool     is_strip = chance(0.5);
          if (is_strip)
            {
              const double width = thickness * number(0.5, 2);
              scene.text.rectangle("strut", width, thickness, material);
              area    = width * thickness;
              bending = modulus * area * thickness * thickness / 12;
            }
          else
            {
              scene.text.circle("strut", thickness / 2, material);
              area    = std::acos(-1.) * thickness * thickness / 4;
              bending = modulus * area * thickness * thickness / 16;
            }
          // A strut's first bending period if both ends are clamped.
          period = 2 * std::acos(-1.) / 22.4 * length * length *
            std::sqrt(density * area / bending);
          force_scale = bending / (length * length);
          if (chance(0.3))
            {
              scene.text.set("Sections/strut/Stiffness-proportional damping",
                             number(0.001, 0.02) * period);
              note("damping of struts");
            }
        }

        void add_supports()
        {
          scene.text.support("foot", "0", "clamp");
          const unsigned int last = points.size() - 1;
          if (points.size() > 2 && chance(0.2))
            {
              scene.text.prescribe("side",
                                   std::to_string(last),
                                   {history(number(-0.2, 0.2) * length),
                                    "free",
                                    "free"});
              note("moved support");
            }
          else if (points.size() > 2 && chance(0.3))
            {
              scene.text.support("side", std::to_string(last), "roller x");
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
          note(scheme);
          end_time = scene.is_static ? 1 : 10 * period;
          scene.text.time(end_time, end_time / 20, scheme);
          if (!scene.is_static)
            scene.text.time(end_time, end_time / 200, scheme);
          if (chance(0.2))
            {
              scene.text.set("Output/Time between rows", end_time / 33);
              note("rows within steps");
            }
          if (!scene.is_static && scheme != "energy-momentum" && chance(0.2))
            {
              scene.text.set("Time/Relative tolerance", 1e-3);
              note("tolerance");
            }
          if (chance(0.3))
            {
              scene.text.mesh(1 + static_cast<unsigned int>(number(1, 4)),
                              static_cast<unsigned int>(number(0, 3)));
              note("other mesh");
            }
          if (chance(0.3))
            {
              scene.text.set("Effects/Large rotation", "on");
              note("exact kinematics");
            }
        }

        std::string any_joint()
        {
          return std::to_string(
            static_cast<unsigned int>(number(0, points.size())));
        }

        void add_joint()
        {
          const std::string joint = any_joint(),
                            type  = one_of(
                              dimension == 2
                                ? std::vector<std::string>{"hinge",
                                                            "rotational spring"}
                                : std::vector<std::string>{"hinge",
                                                            "rotational spring",
                                                            "revolute"});
          has_releases = true;
          scene.text.set("Joints/link/Joints", joint);
          scene.text.set("Joints/link/Type", type);
          if (type == "rotational spring")
            scene.text.set("Joints/link/Stiffness",
                           number(0.1, 10) * bending / length);
          if (type == "revolute")
            scene.text.set("Joints/link/Axis", "0 0 1");
          note(type + " at " + joint);
        }

        void add_rigid_part()
        {
          if (ends.size() < 2)
            return;
          const std::string strut = std::to_string(
            1 + static_cast<unsigned int>(number(0, ends.size() - 1)));
          scene.text.rigid_part("block", strut, area * length * density);
          if (scene.is_static || chance(0.5))
            scene.text.set("Rigid parts/block/Elastic struts", "clamped");
          has_rigid_part = true;
          note("rigid strut " + strut);
        }

        void add_connector()
        {
          if (points.size() < 3)
            return;
          const double stiffness = number(0.1, 3) * force_scale / length,
                       damper    = stiffness * number(0.1, 3) *
            (scene.is_static ? 0.3 : period);
          const std::string  law = one_of<std::string>({"spring",
                                                        "dashpot",
                                                        "kelvin-voigt",
                                                        "maxwell",
                                                        "standard-linear-solid",
                                                        "generalized-maxwell"});
          const unsigned int begin =
            static_cast<unsigned int>(number(0, points.size() - 2));
          std::string entries =
            "Between = " + text(begin) + " " + text(begin + 2);
          if (law != "dashpot" && law != "generalized-maxwell")
            entries += " | Spring stiffness = " + text(stiffness);
          if (law != "spring" && law != "generalized-maxwell")
            entries += " | Damping coefficient = " + text(damper);
          if (law == "standard-linear-solid" || law == "generalized-maxwell")
            entries += " | Long-time stiffness = " + text(stiffness / 2);
          if (law == "generalized-maxwell")
            entries += " | Stiffnesses = " + text(stiffness) + ", " +
              text(stiffness / 3) +
              " | Relaxation times = " + text(damper / stiffness) + ", " +
              text(5 * damper / stiffness);
          scene.text.connector("link", law, entries);
          note(law);
        }

        void add_mass()
        {
          scene.text.mass("weight",
                          std::to_string(points.size() - 1),
                          number(0.1, 3) * area * length * density);
          has_mass = true;
          note("mass");
        }

        void add_gravity()
        {
          const double whole = number(0.01, 0.2) * force_scale;
          double       mass  = 0;
          for (const auto &[a, b] : ends)
            mass += density * area * points[a].distance(points[b]);
          const double acceleration = -whole / mass;
          scene.text.set("Gravity/Acceleration y", acceleration);
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
              scene.text.add("Loads/wind", "Type = line | Struts = 0");
              const double size = points[0].distance(points[1]);
              for (unsigned int c = 0; c < dimension; ++c)
                {
                  scene.text.set(std::string("Loads/wind/Force per length ") +
                                   "xyz"[c],
                                 history(force[c] / size));
                  if (scene.final_load)
                    (*scene.final_load)[c] += force[c];
                }
              return;
            }
          const std::string joint = std::to_string(points.size() - 1);
          scene.text.set("Loads/push/Joints", joint);
          for (unsigned int c = 0; c < dimension; ++c)
            {
              scene.text.set(std::string("Loads/push/Force ") + "xyz"[c],
                             history(force[c]));
              if (scene.final_load)
                (*scene.final_load)[c] += force[c];
            }
          if (kind == "follower")
            {
              scene.text.set("Loads/push/Direction", "follows the joint");
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
          scene.text.add("Plates/body", entries);
          // One element cannot follow the corner that a small body makes.
          scene.text.mesh(3, 1);
          if (!scene.is_static && chance(0.5))
            {
              scene.text.set("Contact/Friction coefficient", 0.3);
              note("friction");
            }
          note(std::string(is_thrown ? "thrown " : "moved ") +
               (body.is_cylinder ? "cylinder" : "sphere") + " of radius " +
               text(body.radius / thickness) + " thicknesses");
        }

        std::mt19937       generator;
        RandomScene        scene;
        unsigned int       dimension;
        const double       length = 0.1; ///< of struts (m)
        std::vector<Point> points;       ///< joints (m)
        std::vector<std::array<unsigned int, 2>> ends;
        double thickness, area, modulus, density, bending;
        double period;      ///< s
        double force_scale; ///< that bends a strut by about its length (N)
        double end_time;    ///< s
        bool   has_rigid_part = false, has_mass = false, has_releases = false;
      };
    } // namespace

    RandomScene random_scene(const unsigned int seed)
    {
      return SceneGenerator(seed).make();
    }
  } // namespace testing_support
} // namespace auxfem
