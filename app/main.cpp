// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/process/kept_heap.h"
#include "app/window/window_program.h"

int main(int argc, char** argv)
{
    planewright::keepFreedMemory();
    const auto options = planewright::parseWindowOptions(argc, argv);
    return options ? planewright::runWindow(*options, argc, argv) : options.error();
}
