// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/sqlite_message.h"

#include <sqlite3.h>

namespace planewright {

std::string sqliteMessage(int code)
{
    switch (code & 0xFF) {  // the rest says where it happened
        case SQLITE_FULL:
            return "the disk is full; free some space";
        case SQLITE_READONLY:
            return "the file cannot be written; check its permissions and those of its folder";
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return "another program holds the file; close it there, or try again";
        case SQLITE_CANTOPEN:
            return "the file cannot be opened; check its name, its folder and their permissions";
        case SQLITE_IOERR:
            return "its disk cannot be read or written; check the disk and its free space";
        case SQLITE_CORRUPT:
            return "the database is damaged; get a sound copy";
        case SQLITE_NOTADB:
            return "this is no SQLite database; give a file that was recorded as .pwscan";
        case SQLITE_NOMEM:
            return "out of memory; close other programs";
        case SQLITE_TOOBIG:
            return "a value in it is larger than a recording can have; get a sound copy";
        case SQLITE_INTERRUPT:
            return "reading it takes longer than a recording ever can; get a sound copy";
        default:
            return std::string{"SQLite says '"} + sqlite3_errstr(code) + "'; get a sound copy";
    }
}

}  // namespace planewright
