#ifndef springfit_tests_mesh_messages_h
#define springfit_tests_mesh_messages_h

#include <springfit/core/error.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

/** Expect that @p action throws an InputError that says all of @p words. */
template <typename Action>
void
expect_error(const Action &action, const std::vector<std::string> &words)
{
  try
    {
      action();
      ADD_FAILURE() << "nothing is thrown";
    }
  catch (const springfit::InputError &error)
    {
      const std::string message = error.what();
      for (const std::string &word : words)
        EXPECT_NE(message.find(word), std::string::npos)
          << "'" << word << "' is missing in: " << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

#endif
