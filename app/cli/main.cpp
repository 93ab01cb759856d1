// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <exception>
#include <new>
#include <string>

#include "app/cli/console.h"
#include "app/cli/program.h"
#include "app/process/kept_heap.h"

int main(int argc, char** argv)
try {
    planewright::keepFreedMemory();
    return static_cast<int>(planewright::runProgram(argc, argv));
} catch (const std::bad_alloc&) {
    planewright::printError("out of memory; close other programs or use a smaller recording");
    return static_cast<int>(planewright::ExitCode::Internal);
} catch (const std::exception& error) {
    planewright::printError(std::string{"internal error: "} + error.what());
    return static_cast<int>(planewright::ExitCode::Internal);
}
