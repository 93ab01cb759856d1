// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ostream>

#include "core/formats/csv_record.h"
#include "core/formats/plane_cells.h"
#include "core/formats/planes_csv.h"
#include "core/formats/written.h"

namespace planewright {

Result<void> writePlanesCsv(std::ostream& out, std::span<const PlaneResult> planes)
{
    const bool ofMap = !planes.empty() && !planes.front().stops.empty();
    out << "# format = planewright-planes 1\n";
    out << "id,nx,ny,nz,d,segments,points,error,rms_m,area_m2,width_m,height_m,cx,cy,cz,sigma_normal_deg,sigma_d_m,"
           "born_step,changed_step,lineage,polygon_wkt,name,class";
    out << (ofMap ? ",stops\n" : "\n");
    std::string row;
    for (const PlaneResult& plane : planes) {
        row.clear();
        for (const PlaneCell& cell : planeCells(plane)) {
            if (cell.kind == PlaneCell::Kind::Text)
                appendCsvText(row, cell.text);
            else if (cell.kind == PlaneCell::Kind::Polygon && !cell.text.empty())
                appendQuotedCsvText(row, cell.text);
            else
                row += cell.text;
            row += ',';
        }
        row.back() = '\n';
        out << row;
    }
    return written(out);
}

}  // namespace planewright
