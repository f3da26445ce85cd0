#include <auxfem/parameters/errors.h>
#include <auxfem/study/settings.h>

#include <charconv>

namespace auxfem
{
  bool operator==(const Settings &one, const Settings &other)
  {
    return overrides(one, other).empty();
  }



  Settings settings_of(const Scene &scene)
  {
    return {scene.discretization.order,
            scene.discretization.refinements,
            scene.time.step,
            scene.newton.tolerance,
            scene.time.scheme->name(),
            scene.time.relative_tolerance};
  }



  std::vector<std::string> overrides(const Settings &from, const Settings &to)
  {
    std::vector<std::string> assignments;
    const auto               assign = [&assignments](const std::string &path,
                                       const auto        &former,
                                       const auto        &value,
                                       const std::string &text) {
      if (former != value)
        assignments.push_back(path + "=" + text);
    };
    assign("Discretization/Order",
           from.order,
           to.order,
           std::to_string(to.order));
    assign("Discretization/Global refinements",
           from.refinements,
           to.refinements,
           std::to_string(to.refinements));
    assign("Time/Scheme", from.scheme, to.scheme, to.scheme);
    assign("Time/Time step",
           from.time_step,
           to.time_step,
           short_number(to.time_step));
    assign("Time/Relative tolerance",
           from.time_tolerance,
           to.time_tolerance,
           to.time_tolerance ? short_number(*to.time_tolerance) : "none");
    assign("Newton/Tolerance",
           from.newton_tolerance,
           to.newton_tolerance,
           short_number(to.newton_tolerance));
    return assignments;
  }



  std::string command_line_text(const std::vector<std::string> &overrides)
  {
    std::string text;
    for (const std::string &assignment : overrides)
      text += " --set \"" + assignment + "\"";
    return text;
  }



  Scene scene_with(const Scene                    &scene,
                   const std::vector<std::string> &overrides)
  {
    std::vector<std::string> all = {"Analysis=simulation"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    try
      {
        return read_scene_from_text(scene.all_parameters, scene.file, all);
      }
    catch (const InputError &error)
      {
        throw InputError("A simulation of the study cannot be done, that with" +
                         command_line_text(overrides) + ":\n" + error.what());
      }
  }



  std::string short_number(const double value)
  {
    // 20 us read and halved is not 1e-05 to the last digit.
    constexpr int digits = 12;
    char          text[32];
    const auto    end = std::to_chars(text,
                                   text + sizeof(text),
                                   value,
                                   std::chars_format::general,
                                   digits)
                       .ptr;
    return {text, end};
  }
} // namespace auxfem
