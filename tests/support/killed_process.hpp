#pragma once

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pcvt::testing {

/// Runs `action` in a process that ends at once afterwards, as a killed one does.
template <class Action>
void in_killed_process(const Action& action) {
    const pid_t child = fork();
    if (child == 0) {
        action();
        _exit(0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
}

}  // namespace pcvt::testing
