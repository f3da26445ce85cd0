#ifndef auxfem_study_settings_h
#define auxfem_study_settings_h

#include <auxfem/scene/scene.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** What decides on the error of a simulation and on its price. */
  struct Settings
  {
    unsigned int order            = 1; ///< of the struts' elements
    unsigned int refinements      = 0; ///< 2^n elements a strut
    double       time_step        = 1; ///< s
    double       newton_tolerance = 1;
    std::string  scheme; ///< as in Time/Scheme
    /** Time/Relative tolerance. */
    std::optional<double> time_tolerance = {};

    /** Elements a strut. */
    unsigned long elements() const
    {
      return 1ul << refinements;
    }
  };

  bool operator==(const Settings &one, const Settings &other);

  /** Those of @p scene. */
  Settings settings_of(const Scene &scene);

  /**
   * Assignments of the command line that turn a scene of the settings @p from
   * into one of @p to.
   */
  std::vector<std::string> overrides(const Settings &from, const Settings &to);

  /** What follows `auxfem FILE.prm` on a command line for these overrides. */
  std::string command_line_text(const std::vector<std::string> &overrides);

  /**
   * The simulation of @p scene with other parameters. Throws InputError if they
   * are wrong.
   */
  Scene scene_with(const Scene                    &scene,
                   const std::vector<std::string> &overrides);

  /** @p value with twelve digits, zeros at the end left out. */
  std::string short_number(double value);
} // namespace auxfem

#endif
