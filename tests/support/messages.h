#ifndef auxfem_tests_support_messages_h
#define auxfem_tests_support_messages_h

#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** The message of the InputError that @p action throws; empty if none. */
  template <class Action>
  std::string input_error_of(const Action &action)
  {
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  inline bool contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  /** Expects each of @p parts in @p message. */
  inline void expect_parts(const std::string              &message,
                           const std::vector<std::string> &parts)
  {
    for (const std::string &part : parts)
      EXPECT_TRUE(contains(message, part))
        << "no \"" << part << "\" in: " << message;
  }
} // namespace auxfem

#endif
