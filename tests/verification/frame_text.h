#ifndef auxfem_tests_verification_frame_text_h
#define auxfem_tests_verification_frame_text_h

#include <array>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>
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

    /** Section stiffnesses: axial EA (N), shear kGA (N), bending EI (N m2). */
    struct Stiffnesses
    {
      double axial;
      double shear;
      double bending;
    };

    /**
     * The `.prm` text of a static scene, put together parameter by parameter.
     * Starts with full Newton and a residual tolerance of 1e-11, so that what
     * is compared is the equilibrium and not where the iteration stopped.
     */
    class StaticScene
    {
    public:
      StaticScene()
      {
        set("Time/Scheme", "static");
        set("Newton/Factorization", "every iteration");
        set("Newton/Tolerance", "1e-11");
      }

      /** A free-form frame; see the parameters of `Lattice/Cell = frame`. */
      StaticScene(const std::string &joints, const std::string &struts)
        : StaticScene()
      {
        set("Lattice/Cell", "frame");
        set("Lattice/Joints", joints);
        set("Lattice/Struts", struts);
      }

      /** Sets one parameter: `Subsection/Subsection/Name`. */
      StaticScene &set(const std::string &path, const std::string &value)
      {
        std::string begin, end;
        std::size_t from = 0;
        for (std::size_t to = path.find('/'); to != std::string::npos;
             from = to + 1, to = path.find('/', from))
          {
            begin += "subsection " + path.substr(from, to - from) + "\n";
            end += "end\n";
          }
        prm += begin + "set " + path.substr(from) + " = " + value + "\n" + end;
        return *this;
      }

      StaticScene &set(const std::string &path, const double value)
      {
        return set(path, text(value));
      }

      /** A section by its stiffnesses; E = G = 1 Pa makes them areas. */
      StaticScene &section(const Stiffnesses &stiffnesses,
                           const std::string &struts = "all")
      {
        const std::string path =
          "Sections/section " + std::to_string(n_sections++) + "/";
        set(path + "Struts", struts);
        set(path + "Shape", "given");
        set(path + "Young's modulus", "1");
        set(path + "Poisson's ratio", "-0.5");
        set(path + "Area", stiffnesses.axial);
        set(path + "Shear area", stiffnesses.shear);
        return set(path + "Second moment of area", stiffnesses.bending);
      }

      /** A rectangular section of unit width. */
      StaticScene &rectangle(const double height,
                             const double youngs_modulus,
                             const double poissons_ratio)
      {
        set("Sections/wall/Shape", "rectangle");
        set("Sections/wall/Width", "1");
        set("Sections/wall/Height", height);
        set("Sections/wall/Young's modulus", youngs_modulus);
        return set("Sections/wall/Poisson's ratio", poissons_ratio);
      }

      StaticScene &support(const std::string &name,
                           const std::string &joints,
                           const std::string &type)
      {
        set("Supports/" + name + "/Joints", joints);
        return set("Supports/" + name + "/Type", type);
      }

      /** Displacements x, y and rotation: an expression in t, or `free`. */
      StaticScene &prescribe(const std::string                &name,
                             const std::string                &joints,
                             const std::array<std::string, 3> &motion)
      {
        const std::string path = "Supports/" + name + "/";
        support(name, joints, "prescribed");
        set(path + "Displacement x", motion[0]);
        set(path + "Displacement y", motion[1]);
        return set(path + "Rotation z", motion[2]);
      }

      /** Force x, y and moment on each joint: expressions in t. */
      StaticScene &load(const std::string                &name,
                        const std::string                &joints,
                        const std::array<std::string, 3> &components)
      {
        const std::string path = "Loads/" + name + "/";
        set(path + "Joints", joints);
        set(path + "Force x", components[0]);
        set(path + "Force y", components[1]);
        return set(path + "Moment z", components[2]);
      }

      StaticScene &hinge(const std::string &name,
                         const std::string &joints,
                         const std::string &struts = "all")
      {
        set("Joints/" + name + "/Joints", joints);
        return set("Joints/" + name + "/Struts", struts);
      }

      /** 2^@p refinements elements of @p order a strut. */
      StaticScene &mesh(const unsigned int order,
                        const unsigned int refinements)
      {
        set("Discretization/Order", order);
        return set("Discretization/Global refinements", refinements);
      }

      StaticScene &time(const double end, const double step)
      {
        set("Time/End time", end);
        return set("Time/Time step", step);
      }

      /** Small displacements: one step of the element linearised once. */
      StaticScene &linear()
      {
        set("Effects/Large rotation", "off");
        return time(1, 1);
      }

      const std::string &str() const
      {
        return prm;
      }

    private:
      std::string  prm;
      unsigned int n_sections = 0;
    };

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
