#include "random_structure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace auxfem
{
  namespace testing_support
  {
    RandomStructure::RandomStructure(const unsigned int seed) : generator(seed)
    {
      dimension = chance(0.5) ? 2 : 3;
      scene_text.dimension(dimension);
    }

    double RandomStructure::number(const double low, const double high)
    {
      return low + (high - low) * (generator() / 4294967296.);
    }

    bool RandomStructure::chance(const double probability)
    {
      return number(0, 1) < probability;
    }

    std::string RandomStructure::coordinates(const Vector &point) const
    {
      std::string result = text(point[0]) + " " + text(point[1]);
      return dimension == 3 ? result + " " + text(point[2]) : result;
    }

    void RandomStructure::note(const std::string &feature)
    {
      features += (features.empty() ? "" : ", ") + feature;
    }

    void RandomStructure::add_frame()
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
      scene_text.frame(joints, struts);
    }

    void RandomStructure::add_section()
    {
      thickness = number(0.02, 0.06) * length;
      modulus   = std::pow(10., number(7, 11));
      density   = number(900, 8000);
      const Material material{modulus, density, 0.3};
      const bool     is_strip = chance(0.5);
      if (is_strip)
        {
          const double width = thickness * number(0.5, 2);
          scene_text.rectangle("strut", width, thickness, material);
          area    = width * thickness;
          bending = modulus * area * thickness * thickness / 12;
        }
      else
        {
          scene_text.circle("strut", thickness / 2, material);
          area    = std::acos(-1.) * thickness * thickness / 4;
          bending = modulus * area * thickness * thickness / 16;
        }
      // A strut's first bending period if both ends are clamped.
      period = 2 * std::acos(-1.) / 22.4 * length * length *
        std::sqrt(density * area / bending);
      force_scale = bending / (length * length);
      if (chance(0.3))
        {
          scene_text.set("Sections/strut/Stiffness-proportional damping",
                         number(0.001, 0.02) * period);
          has_damped_struts = true;
          note("damping of struts");
        }
    }

    std::string RandomStructure::any_joint()
    {
      return std::to_string(
        static_cast<unsigned int>(number(0, points.size())));
    }

    void RandomStructure::add_joint()
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
      scene_text.set("Joints/link/Joints", joint);
      scene_text.set("Joints/link/Type", type);
      if (type == "rotational spring")
        scene_text.set("Joints/link/Stiffness",
                       number(0.1, 10) * bending / length);
      if (type == "revolute")
        scene_text.set("Joints/link/Axis", "0 0 1");
      note(type + " at " + joint);
    }

    void RandomStructure::add_rigid_part(const bool is_held)
    {
      if (ends.size() < 2)
        return;
      const std::string strut = std::to_string(
        1 + static_cast<unsigned int>(number(0, ends.size() - 1)));
      scene_text.rigid_part("block", strut, area * length * density);
      if (is_held || chance(0.5))
        scene_text.set("Rigid parts/block/Elastic struts", "clamped");
      has_rigid_part = true;
      note("rigid strut " + strut);
    }

    void RandomStructure::add_nonlinear_connector(const bool rubs)
    {
      if (points.size() < 3)
        return;
      const double size  = force_scale * number(0.1, 1);
      const double span  = 0.01 * length;
      const auto   entry = [](const std::string &name, const double value) {
        return " | " + name + " = " + text(value);
      };
      const std::string        stiff = entry("Spring stiffness", size / span);
      std::vector<std::string> laws  = {
         "cubic" + stiff + entry("Cubic stiffness", size / std::pow(span, 3)),
         "bilinear" + stiff + entry("Second stiffness", 0.2 * size / span) +
           entry("Kink extension", 0.3 * span),
         "gap" + stiff + entry("Gap", 0.1 * span),
         "hook" + stiff + entry("Slack", 0.1 * span),
         "buckling-link" + stiff + entry("Buckling load", 0.2 * size),
         "expression | Force = " + text(size) + " * tanh(u / " + text(span) +
           ")" + entry("Typical extension", span)};
      if (rubs)
        laws.push_back("friction-slider" + stiff +
                       entry("Slip force", 0.2 * size));
      std::string law = one_of(laws);
      note("connector " + law.substr(0, law.find(' ')));
      if (rubs && chance(0.3))
        {
          law += entry("Failure force", 0.3 * size);
          note("breaking");
        }
      scene_text.add("Connectors/stop", "Law = " + law);
      scene_text.set("Connectors/stop/Between",
                     "0 " + std::to_string(points.size() - 1));
    }

    void RandomStructure::add_connector(const std::vector<std::string> &laws,
                                        const double relaxation_time)
    {
      if (points.size() < 3)
        return;
      const double stiffness = number(0.1, 3) * force_scale / length,
                   damper    = stiffness * number(0.1, 3) * relaxation_time;
      const std::string  law = one_of(laws);
      const unsigned int begin =
        static_cast<unsigned int>(number(0, points.size() - 2));
      std::string entries = "Between = " + text(begin) + " " + text(begin + 2);
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
      scene_text.connector("link", law, entries);
      note(law);
    }

    void RandomStructure::add_mass()
    {
      scene_text.mass("weight",
                      std::to_string(points.size() - 1),
                      number(0.1, 3) * area * length * density);
      has_mass = true;
      note("mass");
    }

    void expect_message(const std::string &message)
    {
      for (const char *technical : {"std::", "dealii", "terminate", "nan"})
        EXPECT_EQ(message.find(technical), std::string::npos) << message;
    }
  } // namespace testing_support
} // namespace auxfem
