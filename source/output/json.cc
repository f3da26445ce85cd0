#include <auxfem/output/json.h>

#include <charconv>
#include <cmath>
#include <cstdio>

namespace auxfem
{
  std::string json_string(const std::string &text)
  {
    std::string quoted = "\"";
    for (const char character : text)
      if (character == '"' || character == '\\')
        {
          quoted += '\\';
          quoted += character;
        }
      else if (character == '\n')
        quoted += "\\n";
      else if (static_cast<unsigned char>(character) < 0x20)
        {
          char escape[8];
          std::snprintf(escape,
                        sizeof(escape),
                        "\\u%04x",
                        static_cast<unsigned int>(character));
          quoted += escape;
        }
      else
        quoted += character;
    return quoted + '"';
  }

  void JsonObject::add(const std::string &name, const std::string &value)
  {
    members.push_back({name, json_string(value)});
  }

  void JsonObject::add(const std::string &name, const char *value)
  {
    add(name, std::string(value));
  }

  void JsonObject::add(const std::string &name, const double value)
  {
    char       number[32];
    const auto end = std::to_chars(number, number + sizeof(number), value).ptr;
    members.push_back(
      {name, std::isfinite(value) ? std::string(number, end) : "null"});
  }

  void JsonObject::add(const std::string &name, const unsigned int value)
  {
    members.push_back({name, std::to_string(value)});
  }

  void JsonObject::add(const std::string &name, const unsigned long value)
  {
    members.push_back({name, std::to_string(value)});
  }

  void JsonObject::add(const std::string              &name,
                       const std::vector<std::string> &values)
  {
    std::string list = "[";
    for (const std::string &value : values)
      list += (list.size() > 1 ? ", " : "") + json_string(value);
    members.push_back({name, list + ']'});
  }

  void JsonObject::add(const std::string &name, const JsonObject &value)
  {
    members.push_back({name, value.text()});
  }

  void JsonObject::add(const std::string             &name,
                       const std::vector<JsonObject> &values)
  {
    std::string list = "[";
    for (const JsonObject &value : values)
      list += (list.size() > 1 ? ", " : "") + value.text();
    members.push_back({name, list + ']'});
  }

  std::string JsonObject::text() const
  {
    if (members.empty())
      return "{}";

    std::string text = "{";
    for (const Member &member : members)
      {
        text += text.size() > 1 ? ",\n  " : "\n  ";
        text += json_string(member.name) + ": ";
        // Strings hold no line break, so each one here is layout.
        for (const char character : member.value)
          {
            text += character;
            if (character == '\n')
              text += "  ";
          }
      }
    return text + "\n}";
  }
} // namespace auxfem
