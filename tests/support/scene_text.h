#ifndef auxfem_tests_support_scene_text_h
#define auxfem_tests_support_scene_text_h

#include <auxfem/struts/beam_3d.h>

#include <algorithm>
#include <array>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** A short text that reads back as @p value. */
    inline std::string text(const double value)
    {
      for (int digits = 6;; ++digits)
        {
          std::ostringstream stream;
          stream << std::setprecision(digits) << value;
          if (digits == std::numeric_limits<double>::max_digits10 ||
              std::stod(stream.str()) == value)
            return stream.str();
        }
    }

    /** The value of a parameter as text; numbers are converted. */
    struct SceneValue
    {
      /** As it stands. */
      SceneValue(const std::string &words) : words(words)
      {}

      /** As it stands. */
      SceneValue(const char *const words) : words(words)
      {}

      /** All its digits. */
      template <typename Number,
                typename = std::enable_if_t<std::is_arithmetic_v<Number>>>
      SceneValue(const Number number) : words(text(number))
      {}

      std::string words;
    };

    /** Section stiffnesses: axial EA (N), shear kGA (N), bending EI (N m2). */
    struct Stiffnesses
    {
      double axial;
      double shear;
      double bending;
    };

    /** Material of struts; empty values are not set. */
    struct Material
    {
      SceneValue youngs_modulus;
      SceneValue density        = "";
      SceneValue poissons_ratio = "";
    };

    /** Expressions in t for x, y, z. */
    using SpaceTexts = std::array<std::string, 3>;

    /**
     * The text of a `.prm` file, put together parameter by parameter. A
     * parameter that is set again has the later value and keeps its place, so
     * that a scene can be a variant of another one.
     */
    class SceneText
    {
    public:
      /** Sets one parameter: `Subsection/Subsection/Name`. */
      SceneText &set(const std::string &path, const SceneValue &value)
      {
        for (auto &[known, words] : parameters)
          if (known == path)
            {
              words = value.words;
              return *this;
            }
        parameters.emplace_back(path, value.words);
        return *this;
      }

      /**
       * Sets parameters of one subsection: `Name = value | Name = value`.
       * Nothing may stand between two bars, so that tests can join what they
       * vary.
       */
      SceneText &add(const std::string &subsection, const std::string &entries)
      {
        const std::string separator = " | ", equals = " = ";
        for (std::size_t begin = 0; begin < entries.size();)
          {
            const std::size_t end =
              std::min(entries.find(separator, begin), entries.size());
            const std::string entry  = entries.substr(begin, end - begin);
            const std::size_t middle = entry.find(equals);
            if (!entry.empty() && middle == std::string::npos)
              throw std::logic_error("No \" = \" in \"" + entry + "\"");
            if (!entry.empty())
              set(subsection + "/" + entry.substr(0, middle),
                  entry.substr(middle + equals.size()));
            begin = end + separator.size();
          }
        return *this;
      }

      /** Sets all that @p further sets. */
      SceneText &add(const SceneText &further)
      {
        for (const auto &[path, words] : further.parameters)
          set(path, words);
        return *this;
      }

      /** Takes a parameter or a subsection out, which must be there. */
      SceneText &remove(const std::string &path)
      {
        const auto first_removed =
          std::remove_if(parameters.begin(),
                         parameters.end(),
                         [&path](const auto &parameter) {
                           return parameter.first == path ||
                             parameter.first.rfind(path + "/", 0) == 0;
                         });
        if (first_removed == parameters.end())
          throw std::logic_error("The scene has no " + path);
        parameters.erase(first_removed, parameters.end());
        return *this;
      }

      /** 2 or 3. */
      SceneText &dimension(const unsigned int n)
      {
        return set("Dimension", n);
      }

      /** A free-form frame; see the parameters of `Lattice/Cell = frame`. */
      SceneText &frame(const std::string &joints, const std::string &struts)
      {
        set("Lattice/Cell", "frame");
        set("Lattice/Joints", joints);
        return set("Lattice/Struts", struts);
      }

      /** @p n_x x @p n_y cells of a kind. */
      SceneText &cells(const std::string &kind,
                       const unsigned int n_x,
                       const unsigned int n_y)
      {
        set("Lattice/Cell", kind);
        set("Lattice/Cells x", n_x);
        return set("Lattice/Cells y", n_y);
      }

      /** A section by its stiffnesses; E = G = 1 Pa makes them areas. */
      SceneText &section(const Stiffnesses &stiffnesses,
                         const std::string &struts = "all")
      {
        const std::string name = "section " + std::to_string(n_sections++);
        set("Sections/" + name + "/Struts", struts);
        return given(name, stiffnesses, {1, "", -0.5});
      }

      /** The same in space, for all struts. */
      SceneText &space_section(const Beam3D::Stiffness &stiffness)
      {
        const std::string path = "Sections/all/";
        given("all",
              {stiffness.axial, stiffness.shear_2, stiffness.bending_3},
              {1, "", -0.5});
        set(path + "Shear area 3", stiffness.shear_3);
        set(path + "Torsion constant", stiffness.torsion);
        return set(path + "Second moment of area 2", stiffness.bending_2);
      }

      /** A section by area, shear area and second moment of area. */
      SceneText &given(const std::string &name,
                       const Stiffnesses &areas,
                       const Material    &material)
      {
        const std::string path = "Sections/" + name + "/";
        set(path + "Shape", "given");
        set(path + "Area", areas.axial);
        set(path + "Shear area", areas.shear);
        set(path + "Second moment of area", areas.bending);
        return of(path, material);
      }

      /** A rectangular section. */
      SceneText &rectangle(const std::string &name,
                           const SceneValue  &width,
                           const SceneValue  &height,
                           const Material    &material)
      {
        const std::string path = "Sections/" + name + "/";
        set(path + "Shape", "rectangle");
        set(path + "Width", width);
        set(path + "Height", height);
        return of(path, material);
      }

      /** A circular section. */
      SceneText &circle(const std::string &name,
                        const SceneValue  &radius,
                        const Material    &material)
      {
        const std::string path = "Sections/" + name + "/";
        set(path + "Shape", "circle");
        set(path + "Radius", radius);
        return of(path, material);
      }

      /** Type: one that needs no more, as `clamp` or `roller x`. */
      SceneText &support(const std::string &name,
                         const std::string &joints,
                         const std::string &type)
      {
        set("Supports/" + name + "/Joints", joints);
        return set("Supports/" + name + "/Type", type);
      }

      /** Displacements x, y and rotation: an expression in t, or `free`. */
      SceneText &prescribe(const std::string &name,
                           const std::string &joints,
                           const SpaceTexts  &motion)
      {
        const std::string path = "Supports/" + name + "/";
        support(name, joints, "prescribed");
        set(path + "Displacement x", motion[0]);
        set(path + "Displacement y", motion[1]);
        return set(path + "Rotation z", motion[2]);
      }

      /** Displacement and rotation in space. */
      SceneText &prescribe(const std::string &name,
                           const std::string &joints,
                           const SpaceTexts  &displacement,
                           const SpaceTexts  &rotation)
      {
        const std::string path = "Supports/" + name + "/";
        support(name, joints, "prescribed");
        set_components(path + "Displacement ", displacement);
        return set_components(path + "Rotation ", rotation);
      }

      /** Force x, y and moment on each joint: expressions in t. */
      SceneText &load(const std::string &name,
                      const std::string &joints,
                      const SpaceTexts  &components)
      {
        const std::string path = "Loads/" + name + "/";
        set(path + "Joints", joints);
        set(path + "Force x", components[0]);
        set(path + "Force y", components[1]);
        return set(path + "Moment z", components[2]);
      }

      /** Force and moment on each joint in space. */
      SceneText &load(const std::string &name,
                      const std::string &joints,
                      const SpaceTexts  &force,
                      const SpaceTexts  &moment)
      {
        const std::string path = "Loads/" + name + "/";
        set(path + "Joints", joints);
        set_components(path + "Force ", force);
        return set_components(path + "Moment ", moment);
      }

      /** A joint definition of the default type. */
      SceneText &hinge(const std::string &name,
                       const std::string &joints,
                       const std::string &struts = "all")
      {
        set("Joints/" + name + "/Joints", joints);
        return set("Joints/" + name + "/Struts", struts);
      }

      /** On each of the joints. */
      SceneText &mass(const std::string &name,
                      const std::string &joints,
                      const SceneValue  &mass,
                      const SceneValue  &rotary_inertia = "")
      {
        const std::string path = "Masses/" + name + "/";
        set(path + "Joints", joints);
        set(path + "Mass", mass);
        return set_unless_empty(path + "Rotary inertia", rotary_inertia);
      }

      /** Mass in kg. */
      SceneText &rigid_part(const std::string &name,
                            const std::string &struts,
                            const SceneValue  &mass)
      {
        set("Rigid parts/" + name + "/Struts", struts);
        return set("Rigid parts/" + name + "/Mass", mass);
      }

      /** @p entries: between which joints and what the law needs; see add(). */
      SceneText &connector(const std::string &name,
                           const std::string &law,
                           const std::string &entries)
      {
        set("Connectors/" + name + "/Law", law);
        return add("Connectors/" + name, entries);
      }

      /** 2^@p refinements elements of @p order a strut. */
      SceneText &mesh(const unsigned int order,
                      const unsigned int refinements = 0)
      {
        set("Discretization/Order", order);
        return set("Discretization/Global refinements", refinements);
      }

      /** End and step in s; without @p scheme the program chooses. */
      SceneText &time(const SceneValue  &end,
                      const SceneValue  &step,
                      const std::string &scheme = "")
      {
        set_unless_empty("Time/Scheme", scheme);
        set("Time/End time", end);
        return set("Time/Time step", step);
      }

      /** Small displacements: one step of the element linearised once. */
      SceneText &linear()
      {
        set("Effects/Large rotation", "off");
        return time(1, 1);
      }

      /** A column of the history. */
      SceneText &probe(const std::string &name, const std::string &selection)
      {
        return set("Probes/" + name, selection);
      }

      /** The text of the `.prm` file. */
      std::string str() const
      {
        // Entries of each subsection, which may be given once only.
        std::vector<std::pair<std::string, std::string>> groups;
        for (const auto &[path, words] : parameters)
          {
            const std::size_t slash     = end_of_subsection(path);
            const bool        is_at_top = slash == std::string::npos;
            const std::string group =
              is_at_top ? "" : path.substr(0, slash + 1);
            auto found = std::find_if(groups.begin(),
                                      groups.end(),
                                      [&](const auto &other) {
                                        return other.first == group;
                                      });
            if (found == groups.end())
              found = groups.insert(groups.end(), {group, ""});
            found->second += "set " + path.substr(is_at_top ? 0 : slash + 1) +
              " = " + words + "\n";
          }
        std::string text;
        for (const auto &[group, entries] : groups)
          {
            std::string end;
            std::size_t from = 0;
            for (std::size_t to = group.find('/'); to != std::string::npos;
                 from = to + 1, to = group.find('/', from))
              {
                text += "subsection " + group.substr(from, to - from) + "\n";
                end += "end\n";
              }
            text += entries + end;
          }
        return text;
      }

      /** For all that takes the text of a scene. */
      operator std::string() const
      {
        return str();
      }

    private:
      /** Position of the slash before the name of the entry @p path, which is
       * itself a path in some subsections. */
      static std::size_t end_of_subsection(const std::string &path)
      {
        for (const std::string name : {"Sweep/", "Design variables/"})
          if (path.compare(0, name.size(), name) == 0)
            return name.size() - 1;
        return path.rfind('/');
      }

      SceneText &of(const std::string &path, const Material &material)
      {
        set(path + "Young's modulus", material.youngs_modulus);
        set_unless_empty(path + "Poisson's ratio", material.poissons_ratio);
        return set_unless_empty(path + "Density", material.density);
      }

      SceneText &set_unless_empty(const std::string &path,
                                  const SceneValue  &value)
      {
        return value.words.empty() ? *this : set(path, value);
      }

      SceneText &set_components(const std::string &begin,
                                const SpaceTexts  &values)
      {
        for (unsigned int c = 0; c < 3; ++c)
          set(begin + "xyz"[c], values[c]);
        return *this;
      }

      /** Paths and values in the order in which they came. */
      std::vector<std::pair<std::string, std::string>> parameters;
      unsigned int                                     n_sections = 0;
    };

    /** All parameters of both; where both set one, @p second counts. */
    inline SceneText operator+(SceneText first, const SceneText &second)
    {
      return first.add(second);
    }

    /**
     * The start of a static scene: full Newton and a residual tolerance of
     * 1e-11, so that what is compared is the equilibrium and not where the
     * iteration stopped.
     */
    inline SceneText static_scene()
    {
      return SceneText()
        .set("Time/Scheme", "static")
        .set("Newton/Factorization", "every iteration")
        .set("Newton/Tolerance", "1e-11");
    }

    /** A static scene with a free-form frame. */
    inline SceneText static_frame(const std::string &joints,
                                  const std::string &struts)
    {
      return static_scene().frame(joints, struts);
    }

    /** The same in space. */
    inline SceneText static_space_frame(const std::string &joints,
                                        const std::string &struts)
    {
      return static_frame(joints, struts).dimension(3);
    }

    /**
     * A function of t that passes through 0 at t = 0 and values[i] at t = i +
     * 1,
     * linear in between, times @p factor.
     */
    inline std::string through(const std::vector<double> &values,
                               const double               factor = 1)
    {
      std::string  expression, closing;
      double       previous = 0;
      unsigned int i        = 0;
      for (const double value : values)
        {
          expression += "if(t <= " + std::to_string(i + 1) + ", " +
            text(factor * previous) + " + " +
            text(factor * (value - previous)) + " * (t - " + std::to_string(i) +
            "), ";
          closing += ")";
          previous = value;
          ++i;
        }
      return expression + text(factor * previous) + closing;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
