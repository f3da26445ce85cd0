#include <auxfem/parameters/json.h>

#include <nlohmann/json.hpp>

namespace auxfem
{
  std::string json_text(const Json &json)
  {
    return json.dump(/*indent=*/2,
                     /*indent_char=*/' ',
                     /*ensure_ascii=*/false,
                     Json::error_handler_t::replace);
  }
} // namespace auxfem
