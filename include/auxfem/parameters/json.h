#ifndef auxfem_parameters_json_h
#define auxfem_parameters_json_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace auxfem
{
  /** Members keep the order in which they are added. */
  using Json = nlohmann::ordered_json;

  /**
   * @p json as text, members indented by two blanks. Numbers have as many digits
   * as are needed to read the same ones, null if they are not finite; bytes
   * that are no UTF-8, as file names may have, become U+FFFD.
   */
  std::string json_text(const Json &json);
} // namespace auxfem

#endif
