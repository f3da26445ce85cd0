#ifndef auxfem_output_json_h
#define auxfem_output_json_h

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * A JSON object that is written once, member after member, in the order in
   * which they are added. Names are not checked for repetition.
   */
  class JsonObject
  {
  public:
    /** @name Add a member. */
    ///@{
    void add(const std::string &name, const std::string &value);
    void add(const std::string &name, const char *value);
    /**
     * As many digits as are needed to read the same number; null if not
     * finite.
     */
    void add(const std::string &name, double value);
    void add(const std::string &name, unsigned int value);
    void add(const std::string &name, unsigned long value);
    void add(const std::string &name, const std::vector<std::string> &values);
    void add(const std::string &name, const JsonObject &value);
    void add(const std::string &name, const std::vector<JsonObject> &values);
    ///@}

    /**
     * The object as text, members indented by two blanks, no line break at the
     * end.
     */
    std::string text() const;

  private:
    struct Member
    {
      std::string name;
      std::string value; ///< JSON text, its own line breaks not yet indented
    };
    std::vector<Member> members;
  };

  /** @p text as a JSON string with its quotes. Bytes above 127 are taken for UTF-8. */
  std::string json_string(const std::string &text);
} // namespace auxfem

#endif
