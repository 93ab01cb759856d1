// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace planewright {

/// Sets a serial line to pass every byte as it is: 8 data bits, no parity, one stop bit, no flow control, at any speed
/// [bit/s]. False, with errno set, where the descriptor is no serial line or cannot have this speed.
bool setRawLine(int descriptor, int baud);

/// Tells a serial line's other end that somebody is here (DTR, RTS), and asks the driver not to collect bytes before it
/// passes them on, as some USB adapters do for 16 ms. Lines that have neither are left as they are.
void raiseModemLines(int descriptor);

/// Speed of a serial line [bit/s]; 0 where there is none.
int baudOf(int descriptor);

}  // namespace planewright
